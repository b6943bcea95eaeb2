#include "experiments/report/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace report {

std::string percent(std::int64_t count, std::int64_t games, const stats::Interval& interval) {
  const double share = games > 0 ? static_cast<double>(count) / static_cast<double>(games) : 0;
  return fmt::format("{:.1f} [{:.1f}, {:.1f}]", 100 * share, 100 * interval.low, 100 * interval.high);
}

std::string percent(const Side& side, std::int64_t games) {
  return percent(side.wins, games, side.win_share);
}

std::string plus_minus(const stats::Mean& mean, int decimals) {
  if (mean.count == 0) return "-";
  if (!mean.has_error()) return fmt::format("{:.{}f} ± ?", mean.mean, decimals);
  return fmt::format("{:.{}f} ± {:.{}f}", mean.mean, decimals, mean.standard_error, decimals);
}

std::string signed_plus_minus(const stats::Mean& mean) {
  if (mean.count == 0) return "-";
  return (mean.mean >= 0 ? "+" : "") + plus_minus(mean);
}

std::string signed_number(double value, int decimals) { return fmt::format("{:+.{}f}", value, decimals); }

std::string bracketed(const stats::Interval& interval, int decimals) {
  if (!std::isfinite(interval.low) || !std::isfinite(interval.high)) return "[?, ?]";
  return fmt::format("[{:.{}f}, {:.{}f}]", interval.low, decimals, interval.high, decimals);
}

std::string p_value(double p) { return p < 0.001 ? "< 0.001" : fmt::format("{:.3f}", p); }

std::string p_value(double p, std::optional<double> holm) {
  return p_value(p) + (holm ? " (Holm " + p_value(*holm) + ")" : "");
}

std::string p_value(const stats::TTest& test) { return test.known ? p_value(test.p) : "?"; }

std::string holm_p(const Comparison& comparison) {
  return comparison.test.known ? p_value(comparison.p_holm) : "?";
}

std::string correlation(const stats::PairCorrelation& found) {
  if (!found.known) return "unknown";
  return fmt::format("{:.2f} ± {:.2f}", found.value, found.standard_error);
}

std::string one_decimal(double value) { return fmt::format("{:.1f}", value); }

std::string described(char letter, const record::TeamConfig& team) {
  return fmt::format("{} {}", letter, described(team));
}

std::string described(const record::TeamConfig& team) {
  std::string text = team.name;
  if (team.robots.size() != record::TeamConfig{}.robots.size()) {
    text += fmt::format(", {} robot{}", team.robots.size(), team.robots.size() == 1 ? "" : "s");
  }
  if (team.speed_factor != 1) text += fmt::format(", speed {:g}", team.speed_factor);
  return text;
}

std::string titled(const Header& header, std::size_t condition) {
  const Header::Condition& one = header.conditions[condition];
  return one.realism == header.realism ? one.name : one.name + " (realism " + one.realism + ")";
}

std::string sentence(const Sweep& sweep) {
  if (!sweep.trend.known)
    return fmt::format("{}: too few pairs to say anything about {}", sweep.name, sweep.key);
  const stats::Trend& trend = sweep.trend;
  return fmt::format(
      "{}: A's goal difference changes by {:+.3g} [{:.3g}, {:.3g}] a game per unit of {} (p {}, permutation "
      "{})",
      sweep.name, trend.slope, trend.interval.low, trend.interval.high, sweep.key,
      trend.p < 0.001 ? "< 0.001" : fmt::format("= {:.3f}", trend.p), p_value(trend.permutation_p));
}

std::string circumstances(const Summary& summary) {
  const Header& header = summary.header;
  std::string text = "rule set " + header.rules;
  if (header.half_length) text += fmt::format(" with halves of {:g} s", *header.half_length);
  text += fmt::format(", realism {}, seed {}, {} pair{} per condition\n", header.realism, header.seed,
                      header.pairs, header.pairs == 1 ? "" : "s");
  return text +
         fmt::format("{} of {} games, experiment {}", summary.games, summary.planned, header.experiment);
}

std::vector<std::string> warnings(const Summary& summary) {
  std::vector<std::string> found;
  for (const Row& row : summary.rows) {
    if (row.void_attempts > 0) {
      found.push_back(fmt::format("{}: {} void attempt{} by no fault of a single team, played again",
                                  row.condition, row.void_attempts, row.void_attempts == 1 ? "" : "s"));
    }
    if (row.given_up_pairs > 0) {
      found.push_back(fmt::format("{}: {} pair{} given up after {} void attempts, missing above",
                                  row.condition, row.given_up_pairs, row.given_up_pairs == 1 ? "" : "s",
                                  record::max_attempts));
    }
    if (row.a.forfeits + row.b.forfeits > 0) {
      found.push_back(fmt::format("{}: {} forfeit{} by A, {} by B", row.condition, row.a.forfeits,
                                  row.a.forfeits == 1 ? "" : "s", row.b.forfeits));
    }
  }
  if (summary.repeated_games > 0) {
    found.push_back(
        fmt::format("{} game{} went exactly like an earlier one: these are no evidence of their own",
                    summary.repeated_games, summary.repeated_games == 1 ? "" : "s"));
  }
  found.insert(found.end(), summary.header.remarks.begin(), summary.header.remarks.end());
  return found;
}

std::vector<std::string> footnotes(const Summary& summary) {
  std::vector<std::string> notes = {
      "± is one standard error, intervals are 95 %; win %: Wilson; fouls are calls against the team a game",
      "p is the exact two-sided sign test of A's wins against its losses; it takes the games of a pair as "
      "independent, the sign flips do not",
      "A - B: mean over pairs of games with colours exchanged; sign flips: permutation test over pairs; r: "
      "correlation"};
  bool adjusted = false;
  for (const Row& row : summary.rows) adjusted = adjusted || row.p_holm.has_value();
  const bool unknown = std::any_of(summary.rows.begin(), summary.rows.end(), [](const Row& row) {
    return row.difference.count > 0 && (!row.t_test.known || !std::isfinite(row.bootstrap.low));
  });
  if (unknown) {
    notes.emplace_back(
        "?: cannot be known from fewer than two pairs (the bootstrap: six), or when all pairs came out "
        "alike");
  }
  if (adjusted) notes.emplace_back("Holm: adjusted for the number of conditions");
  if (!summary.sweeps.empty()) {
    notes.emplace_back("points of a sweep are not adjusted for their number: the trend is the question");
  }
  if (!summary.header.stopping.empty()) {
    notes.emplace_back(
        "the run was to stop early: means and intervals in the tables are not corrected for that, the "
        "answers above "
        "are");
  }
  return notes;
}

}  // namespace report
