// Plays games in this process and prints what the football was like: the tool for tuning the reference team.
//
// team_watch [games] [half seconds] [first seed] [yellow] [blue] [trace from s] [trace to s]
// A side is reference, chaser, none, three (reference with 3 robots) or half (at half speed).

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "teams/chaser/chaser.h"
#include "teams/reference/reference_team.h"
#include "tests/teams/support/arena.h"

namespace {

support::Side side(const std::string& name, bool tracing_notes) {
  support::Side s;
  if (name == "none") return s;
  if (name == "chaser") {
    s.make = [](const kit::Setup&) { return std::make_unique<chaser::Chaser>(); };
    return s;
  }
  s.make = [tracing_notes](const kit::Setup& setup) {
    return std::make_unique<reference::ReferenceTeam>(setup, reference::Parameters{}, tracing_notes);
  };
  if (name == "off") {
    s.make = [tracing_notes](const kit::Setup& setup) {
      reference::Parameters parameters;
      parameters.turn_dribble = false;
      return std::make_unique<reference::ReferenceTeam>(setup, parameters, tracing_notes);
    };
  }
  if (name == "three") s.robots = {0, 1, 2};
  if (name == "half") s.speed_factor = 0.5;
  return s;
}

}  // namespace

int main(int argc, char** argv) {
  const auto arg = [&](int i, const char* otherwise) { return std::string(argc > i ? argv[i] : otherwise); };
  const int games = std::atoi(arg(1, "1").c_str());
  const double half = std::atof(arg(2, "600").c_str());
  const int first_seed = std::atoi(arg(3, "1").c_str());
  const double trace_from = std::atof(arg(6, "-1").c_str());
  const double trace_to = std::atof(arg(7, "-1").c_str());

  std::map<std::string, int> rows;
  int yellow_goals = 0, blue_goals = 0, wins = 0, losses = 0;
  for (int game = 0; game < games; ++game) {
    support::Arena arena(side(arg(4, "reference"), trace_from >= 0),
                         side(arg(5, "reference"), trace_from >= 0),
                         static_cast<std::uint64_t>(first_seed + game));
    arena.start_referee(world::from_seconds(half));
    std::int64_t in_play = 0;
    std::array<int, 2> kicks{};
    double longest = 0, since = 0;
    while (arena.tick() && world::seconds(arena.engine().time()) < 2400) {
      const double now = world::seconds(arena.engine().time());
      const bool on = arena.referee()->state().location == world::Location::GameOn;
      in_play += on;
      if (!on) since = now;
      longest = std::max(longest, now - since);
      for (const truth::Kick& kick : arena.engine().truth().kicks) {
        kicks[static_cast<std::size_t>(kick.robot.team)] += 1;
      }
      const bool tracing = now >= trace_from && now <= trace_to;
      for (const referee::Call& call : arena.calls()) {
        rows[call.row] += 1;
        if (tracing || (games == 1 && trace_from < 0))
          std::printf("%s\n", referee::format_call(call).c_str());
      }
      if (tracing) {
        const truth::Ball& ball = arena.engine().truth().ball;
        for (const truth::Kick& kick : arena.engine().truth().kicks) {
          std::printf("  KICK %s %d  v %.2f %.2f %.2f\n", world::name(kick.robot.team), kick.robot.number,
                      kick.velocity.x(), kick.velocity.y(), kick.velocity.z());
        }
        if (arena.engine().tick() % 12 == 0) {
          std::printf("%.2f ball %.2f %.2f v %.2f %.2f\n", now, ball.position.x(), ball.position.y(),
                      ball.velocity.x(), ball.velocity.y());
          for (const world::Team team : world::both_teams) {
            if (arena.team(team) == nullptr) continue;
            const std::string_view note = arena.team(team)->note();
            std::printf("   %s: %.*s\n     ", world::name(team), static_cast<int>(note.size()), note.data());
            for (const truth::Robot& robot : arena.engine().truth().robots) {
              if (robot.id.team != team) continue;
              std::printf(" %d(%.2f %.2f %.0f%s)", robot.id.number, robot.position.x(), robot.position.y(),
                          robot.orientation * 57.3, robot.ball_contact ? " B" : "");
            }
            std::printf("\n");
          }
        }
      }
    }
    const world::GameState& state = arena.referee()->state();
    const double length = world::seconds(arena.engine().time());
    const auto ticks = static_cast<double>(arena.engine().tick());
    std::printf(
        "seed %d: %d:%d (yellow:blue) in %.0f s, in play %.0f %%, longest %.0f s, kicks %d %d, %.1f "
        "us/tick/team\n",
        first_seed + game, state.score.yellow, state.score.blue, length,
        100 * static_cast<double>(in_play) / ticks, longest, kicks[0], kicks[1],
        arena.thinking_seconds() / ticks / 2 * 1e6);
    std::fflush(stdout);
    yellow_goals += state.score.yellow;
    blue_goals += state.score.blue;
    wins += state.score.yellow > state.score.blue;
    losses += state.score.yellow < state.score.blue;
  }
  std::printf("goals %d:%d, yellow wins %d, draws %d, losses %d\ncalls per game:", yellow_goals, blue_goals,
              wins, games - wins - losses, losses);
  for (const auto& [row, count] : rows)
    std::printf("  %s %.1f", row.c_str(), static_cast<double>(count) / games);
  std::printf("\n");
}
