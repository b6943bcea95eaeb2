#include "experiments/record/checksum.h"

#include <xxhash.h>

#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "sim/files/regular_file.h"

namespace record {
namespace {

struct FreeState {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

std::string digits(XXH128_hash_t hash) {
  std::array<char, 33> text{};
  std::snprintf(text.data(), text.size(), "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text.data();
}

}  // namespace

std::string checksum(std::string_view bytes) { return digits(XXH3_128bits(bytes.data(), bytes.size())); }

std::string checksum_of_file(const std::filesystem::path& file, std::int64_t most) {
  files::RegularFile source(file);
  const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
  XXH3_128bits_reset(state.get());
  std::array<char, 65536> buffer;
  for (std::size_t got = buffer.size(); got == buffer.size();) {
    got = source.read(buffer.data(), buffer.size());
    most -= static_cast<std::int64_t>(got);
    if (most < 0) throw std::runtime_error(file.string() + ": has more bytes than it may have");
    XXH3_128bits_update(state.get(), buffer.data(), got);
  }
  return digits(XXH3_128bits_digest(state.get()));
}

void RowChecksum::add(const Value& value) {
  if (std::holds_alternative<std::monostate>(value)) {
    bytes_ += '-';
  } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    add_text(std::to_string(*integer));
  } else if (const auto* real = std::get_if<double>(&value)) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.17g", *real);
    add_text(text.data());
  } else {
    add_text(std::get<std::string>(value));
  }
}

void RowChecksum::add_text(std::string_view text) {
  bytes_ += std::to_string(text.size());
  bytes_ += ':';
  bytes_ += text;
}

}  // namespace record
