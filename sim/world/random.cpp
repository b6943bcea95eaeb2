#include "sim/world/random.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace world {

std::uint64_t derived_seed(std::uint64_t seed, std::string_view name) {
  return XXH3_64bits_withSeed(name.data(), name.size(), seed);
}

}  // namespace world
