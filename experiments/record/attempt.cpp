#include "experiments/record/attempt.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace record {

std::string game_id(const GameKey& key) {
  std::array<char, 32> numbers{};
  std::snprintf(numbers.data(), numbers.size(), "-%04d-%d", key.pair, key.leg);
  return key.condition + numbers.data();
}

PairState pair_state(std::span<const Attempt* const> attempts) {
  PairState state;
  for (const Attempt* attempt : attempts) {
    if (outcome(attempt->record) != Outcome::Void) continue;
    ++state.voids;
    state.attempt = std::max(state.attempt, attempt->attempt + 1);
  }
  state.given_up = state.attempt > max_attempts;
  for (const Attempt* attempt : attempts) {
    if (attempt->attempt == state.attempt)
      state.legs.at(static_cast<std::size_t>(attempt->key.leg)) = attempt;
  }
  return state;
}

}  // namespace record
