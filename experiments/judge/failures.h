#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiments/judge/game.h"

namespace judge {

/// What truth and call say, and how they differ.
std::string sentence(const Case& one);

/// A case that failed, for the list: what truth and call say, and where in which game.
struct Failure {
  std::string game, shadow, event, what;
  std::int64_t first_tick = 0, last_tick = 0;  ///< two seconds before, or the last touch, to one after
};
/// Of `shadow`: missed, late, extra, last touch wrong; outside the bands, in order of event and game.
std::vector<Failure> failures(std::span<const GameResult> games, const std::string& shadow);
std::string as_csv(std::span<const Failure> failures);

}  // namespace judge
