#pragma once

#include <string>

#include "experiments/report/summary.h"

// Small pieces that the formats for readers share.
namespace report {

std::string percent(std::int64_t count, std::int64_t games,
                    const stats::Interval& interval);  ///< "37.5 [13.7, 69.4]"
std::string percent(const Side& side, std::int64_t games);
std::string plus_minus(const stats::Mean& mean, int decimals = 2);  ///< "1.88 ± 0.35"
std::string signed_plus_minus(const stats::Mean& mean);             ///< "+1.88 ± 0.35"
std::string signed_number(double value, int decimals);              ///< "+1.88"
std::string bracketed(const stats::Interval& interval,
                      int decimals = 2);  ///< "[-0.10, 1.23]", "[?, ?]" when infinite
std::string one_decimal(double value);
std::string p_value(double p);                                 ///< "0.031", "< 0.001"
std::string p_value(double p, std::optional<double> holm);     ///< "0.031 (Holm 0.062)"
std::string p_value(const stats::TTest& test);                 ///< "?" when it has none
std::string holm_p(const Comparison& comparison);              ///< the same, adjusted
std::string correlation(const stats::PairCorrelation& found);  ///< "0.12 ± 0.20", "unknown"

/// "A ours", and what hinders it: "B theirs, 3 robots, speed 0.5".
std::string described(char letter, const record::TeamConfig& team);

/// The same without the letter.
std::string described(const record::TeamConfig& team);

/// "equal", and its realism where that is another than the design's.
std::string titled(const Header& header, std::size_t condition);

/// Rule set, realism, seed, size and identity in one or two lines of at most 100 columns.
std::string circumstances(const Summary& summary);

/// The trend of a sweep in one sentence.
std::string sentence(const Sweep& sweep);

/// What a reader must know before believing the numbers: void games, given-up pairs, repeated games, and the
/// header's remarks; a sentence each.
std::vector<std::string> warnings(const Summary& summary);

/// What the numbers of a table are; a sentence each.
std::vector<std::string> footnotes(const Summary& summary);

}  // namespace report
