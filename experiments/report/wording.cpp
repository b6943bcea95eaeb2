#include "experiments/report/wording.h"

#include <fmt/format.h>

namespace report {

std::string percent(const Side& side, std::int64_t games) {
  const double share = games > 0 ? static_cast<double>(side.wins) / static_cast<double>(games) : 0;
  return fmt::format("{:.1f} [{:.1f}, {:.1f}]", 100 * share, 100 * side.win_share.low,
                     100 * side.win_share.high);
}

std::string plus_minus(const stats::Mean& mean) {
  if (mean.count == 0) return "-";
  if (!mean.has_error()) return fmt::format("{:.2f} ± ?", mean.mean);
  return fmt::format("{:.2f} ± {:.2f}", mean.mean, mean.standard_error);
}

std::string signed_plus_minus(const stats::Mean& mean) {
  if (mean.count == 0) return "-";
  return (mean.mean >= 0 ? "+" : "") + plus_minus(mean);
}

std::string one_decimal(double value) { return fmt::format("{:.1f}", value); }

std::string described(char letter, const record::TeamConfig& team) {
  std::string text = fmt::format("{} {}", letter, team.name);
  if (team.robots.size() != record::TeamConfig{}.robots.size()) {
    text += fmt::format(", {} robot{}", team.robots.size(), team.robots.size() == 1 ? "" : "s");
  }
  if (team.speed_factor != 1) text += fmt::format(", speed {:g}", team.speed_factor);
  return text;
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
  return found;
}

}  // namespace report
