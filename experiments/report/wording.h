#pragma once

#include <string>

#include "experiments/report/summary.h"

// Small pieces that the formats for readers share.
namespace report {

std::string percent(const Side& side, std::int64_t games);  ///< "37.5 [13.7, 69.4]"
std::string plus_minus(const stats::Mean& mean);            ///< "1.88 ± 0.35"
std::string signed_plus_minus(const stats::Mean& mean);     ///< "+1.88 ± 0.35"
std::string one_decimal(double value);

/// "A ours", and what hinders it: "B theirs, 3 robots, speed 0.5".
std::string described(char letter, const record::TeamConfig& team);

/// Rule set, realism, seed, size and identity in one or two lines of at most 110 columns.
std::string circumstances(const Summary& summary);

/// What a reader must know before believing the numbers: void games, given-up pairs, repeated games; a
/// sentence each.
std::vector<std::string> warnings(const Summary& summary);

}  // namespace report
