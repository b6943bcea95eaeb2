// libFuzzer's entries for one target: FUZZ_TARGET is its name, FUZZ_MUTATOR how its inputs are changed.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/mutators.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  fuzz::silence_protobuf();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  fuzz::Random random(seed);
  const std::string output = fuzz::FUZZ_MUTATOR({reinterpret_cast<const char*>(data), size}, most, random);
  std::ranges::copy(output, data);
  return output.size();
}
