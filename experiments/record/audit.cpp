#include "experiments/record/audit.h"

#include <array>
#include <stdexcept>

namespace record {
namespace {

constexpr std::array<const char*, 5> names = {"same", "team-differs", "simulator-differs",
                                              "teams-or-us-differ", "failed"};

}  // namespace

const char* name(Verdict verdict) { return names.at(static_cast<std::size_t>(verdict)); }

Verdict verdict_from_name(std::string_view word) {
  std::string known;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (word == names[i]) return static_cast<Verdict>(i);
    known += (known.empty() ? "" : ", ") + std::string(names[i]);
  }
  throw std::invalid_argument("unknown verdict '" + std::string(word) + "'; known are: " + known);
}

}  // namespace record
