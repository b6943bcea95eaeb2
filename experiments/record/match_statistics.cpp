#include "experiments/record/match_statistics.h"

#include <array>
#include <limits>

namespace record {
namespace {

using world::Team;

/// In percent; not a number of nothing.
double percent(double part, double whole) {
  return whole > 0 ? 100 * part / whole : std::numeric_limits<double>::quiet_NaN();
}

template <int TeamStatistics::*count>
double number(const MatchStatistics& game, Team team) {
  return game.teams[team].*count;
}

double pass_completion(const MatchStatistics& game, Team team) {
  return percent(game.teams[team].passes_completed, game.teams[team].passes);
}

template <double TeamStatistics::*seconds>
double share(const MatchStatistics& game, Team team) {
  return percent(game.teams[team].*seconds, game.teams.yellow.*seconds + game.teams.blue.*seconds);
}

double distance(const MatchStatistics& game, Team team) { return game.teams[team].distance; }

constexpr std::array<Statistic, 12> of_team = {{
    {"shots", "shots", 1, number<&TeamStatistics::shots>},
    {"shots_on_target", "shots on target", 1, number<&TeamStatistics::shots_on_target>},
    {"saves", "saves", 1, number<&TeamStatistics::saves>},
    {"passes", "passes", 1, number<&TeamStatistics::passes>},
    {"pass_completion", "passes completed [%]", 1, pass_completion},
    {"possession", "possession [%]", 1, share<&TeamStatistics::possession>},
    {"territory", "territory [%]", 1, share<&TeamStatistics::territory>},
    {"turnovers", "balls lost", 1, number<&TeamStatistics::turnovers>},
    {"balls_out", "balls put out", 1, number<&TeamStatistics::balls_out>},
    {"kicks", "kicks", 1, number<&TeamStatistics::kicks>},
    {"touches", "touches", 1, number<&TeamStatistics::touches>},
    {"distance", "distance run [m]", 0, distance},
}};

double ball_in_play(const MatchStatistics& game, Team) { return percent(game.in_play, game.time); }
double passages(const MatchStatistics& game, Team) { return game.passages; }
double longest_passage(const MatchStatistics& game, Team) { return game.longest_passage; }

constexpr std::array<Statistic, 3> of_game = {{
    {"ball_in_play", "ball in play [%]", 1, ball_in_play},
    {"passages", "passages of play", 1, passages},
    {"longest_passage", "longest passage [s]", 1, longest_passage},
}};

}  // namespace

std::span<const Statistic> team_statistics() { return of_team; }
std::span<const Statistic> game_statistics() { return of_game; }

}  // namespace record
