#include "experiments/tell.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <ostream>

namespace commands {
namespace {

std::string team_text(const record::TeamConfig& team) {
  std::string text =
      fmt::format("{} ({}), robots {}", team.name, fmt::join(team.command, " "), fmt::join(team.robots, " "));
  if (team.speed_factor != 1) text += fmt::format(", speed {:g}", team.speed_factor);
  return text;
}

/// "INDIRECT yellow" as the referee writes it, "INDIRECT(yellow)".
std::string command_text(const std::string& command) {
  const std::size_t blank = command.find(' ');
  if (command.empty()) return "-";
  if (blank == std::string::npos) return command;
  return command.substr(0, blank) + "(" + command.substr(blank + 1) + ")";
}

/// A line per statistic, both teams beside each other.
void tell_statistics(const record::MatchStatistics& game, std::ostream& out) {
  const auto number = [](double value, int decimals) {
    if (std::isnan(value)) return std::string("-");
    return fmt::format("{:.{}f}", value, value == std::floor(value) ? 0 : decimals);
  };
  out << fmt::format("  {:<28} {:>9} {:>9}\n", "", "yellow", "blue");
  for (const record::Statistic& statistic : record::team_statistics()) {
    out << fmt::format("  {:<28} {:>9} {:>9}\n", statistic.label,
                       number(statistic.value(game, world::Team::Yellow), statistic.decimals),
                       number(statistic.value(game, world::Team::Blue), statistic.decimals));
  }
  for (const record::Statistic& statistic : record::game_statistics()) {
    out << fmt::format("  {:<28} {:>9}\n", statistic.label,
                       number(statistic.value(game, world::Team::Yellow), statistic.decimals));
  }
}

}  // namespace

void tell_circumstances(const record::MatchConfig& config, std::ostream& out) {
  out << "realism " << record::text(config.realism) << ", rule set " << config.rules;
  if (config.half_length) out << fmt::format(" with halves of {:g} s", *config.half_length);
  if (config.winner) out << " until there is a winner";
  out << ", seed " << config.seed << "\n";
  out << "yellow: " << team_text(config.teams.yellow) << "\n";
  out << "blue:   " << team_text(config.teams.blue) << "\n";
  out << fmt::format("blue defends the goal at {}x first, {} kicks off\n\n",
                     config.blue_on_positive_half ? "+" : "-", world::name(config.first_kickoff));
  if (config.continuation) {
    out << "the game recorded in " << config.continuation->recording.string();
    if (config.continuation->tick) {
      out << fmt::format(", from {:.3f} s on played by the teams above",
                         static_cast<double>(*config.continuation->tick) * world::tick_length);
    }
    out << "\n\n";
  }
  out << fmt::format("{:>10}  {:<10} {:<16} {}  {}\n", "time", "row", "command", "y-b", "call") << std::flush;
}

std::string call_line(const record::CallEntry& call, const world::PerTeam<int>& score) {
  const auto ms = std::chrono::round<std::chrono::milliseconds>(call.time.time_since_epoch()).count();
  return fmt::format("{:>3}:{:02}.{:03}  {:<10} {:<16} {}-{}  {}", ms / 60000, ms / 1000 % 60, ms % 1000,
                     call.row, command_text(call.command), score.yellow, score.blue, call.sentence);
}

void tell_result(const record::MatchConfig& config, const record::MatchRecord& record, std::ostream& out) {
  out << fmt::format("\nyellow {} : {} blue    {} against {}\n", record.goals.yellow, record.goals.blue,
                     config.teams.yellow.name, config.teams.blue.name);
  if (record.termination != record::Termination::Finished) {
    out << fmt::format("not finished: {}, at fault: {}; {}\n", record::name(record.termination),
                       record::name(record.at_fault), record.reason);
    const bool a_team = record.at_fault == record::Party::Yellow || record.at_fault == record::Party::Blue ||
                        record.at_fault == record::Party::Both;
    if (a_team && config.directory.empty()) out << "what the team printed: --team-logs FOLDER keeps it\n";
  }
  for (const world::Team team : world::both_teams) {
    const auto refused = record.costs.find(std::string("refused_connections_") + world::name(team));
    if (refused == record.costs.end()) continue;
    out << fmt::format("{:g} connections to the socket of {} by processes of neither team were refused\n",
                       refused->second, world::name(team));
  }
  const double simulated = static_cast<double>(record.ticks) * world::tick_length;
  out << fmt::format("{} ticks, {:.1f} s simulated in {:.1f} s, {:.0f} times real time\n", record.ticks,
                     simulated, record.wall_seconds,
                     record.wall_seconds > 0 ? simulated / record.wall_seconds : 0);
  out << fmt::format("stoppages {}, fouls called against yellow {}, against blue {}\n", record.stoppages,
                     record.fouls.yellow, record.fouls.blue);
  for (const auto& [event, count] : record.calls) out << fmt::format("  {:<28} {:>6}\n", event, count);
  for (const auto& [counter, value] : record.counters)
    out << fmt::format("  {:<28} {:>6.6g}\n", counter, value);
  if (record.statistics) tell_statistics(*record.statistics, out);
  out << "hash " << record.hash << "\n" << std::flush;
}

}  // namespace commands
