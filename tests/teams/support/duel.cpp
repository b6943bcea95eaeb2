// One reference team against another with other flags, in this process: which is better, and what became of
// the ball at their dribblers. The tool behind the tables of tries in teams/reference/README.md.
//
// team_duel [games] [half seconds] [first seed] [flags of A] [flags of B] [realism]
// Flags in one word each, such as "--turn-dribble=off --turn-rate=6". Games come in pairs: one seed, colours
// swapped.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "teams/reference/reference_team.h"
#include "tests/teams/support/arena.h"

namespace {

reference::Parameters parameters_of(const std::string& words) {
  std::vector<std::string> all{"team"};
  std::istringstream in(words);
  for (std::string word; in >> word;) all.push_back(word);
  std::vector<const char*> argv;
  for (const std::string& word : all) argv.push_back(word.c_str());
  reference::Parameters parameters;
  kit::Flags flags;
  reference::declare(flags, parameters);
  if (const auto code = flags.parse(static_cast<int>(argv.size()), argv.data(), "team", "")) std::exit(*code);
  return parameters;
}

support::Side side(const reference::Parameters& parameters) {
  support::Side s;
  s.make = [parameters](const kit::Setup& setup) {
    return std::make_unique<reference::ReferenceTeam>(setup, parameters, false);
  };
  return s;
}

/// Spells with the ball at one robot's dribbler, by how they ended.
struct Spells {
  int all = 0, kicked = 0, lost = 0;  // lost: an opponent had the break beam next, without a kick
  double time_to_kick = 0;            // [s] summed over the kicked
};

/// Follows the break beams and kicks of a game.
class Follower {
 public:
  void look(const truth::Frame& frame, world::PerTeam<Spells>& spells) {
    const double now = world::seconds(frame.time);
    for (const truth::Kick& kick : frame.kicks) {
      if (held_ && holder_ == kick.robot) {
        spells[kick.robot.team].kicked += 1;
        spells[kick.robot.team].time_to_kick += now - since_;
      }
      held_ = false;
    }
    for (const truth::Robot& robot : frame.robots) {
      if (!robot.ball_contact) continue;
      if (held_ && holder_ == robot.id) return;
      if (held_ && holder_.team != robot.id.team) spells[holder_.team].lost += 1;
      held_ = true;
      holder_ = robot.id;
      since_ = now;
      spells[robot.id.team].all += 1;
      return;
    }
  }
  void stop() { held_ = false; }

 private:
  bool held_ = false;
  world::RobotId holder_;
  double since_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const auto arg = [&](int i, const char* otherwise) { return std::string(argc > i ? argv[i] : otherwise); };
  const int games = std::atoi(arg(1, "2").c_str());
  const double half = std::atof(arg(2, "300").c_str());
  const int first_seed = std::atoi(arg(3, "1").c_str());
  const std::array<reference::Parameters, 2> parameters{parameters_of(arg(4, "")), parameters_of(arg(5, ""))};

  std::array<Spells, 2> spells;
  std::array<std::map<std::string, int>, 2> fouls;
  std::array<int, 2> goals{};
  int wins = 0, losses = 0;
  for (int game = 0; game < games; ++game) {
    const std::size_t yellow = game % 2 == 0 ? 0 : 1;  // which of A and B is yellow
    support::Arena arena(side(parameters[yellow]), side(parameters[1 - yellow]),
                         static_cast<std::uint64_t>(first_seed + game / 2), arg(6, "measured").c_str());
    arena.start_referee(world::from_seconds(half));
    Follower follower;
    world::PerTeam<Spells> counts;
    while (arena.tick() && world::seconds(arena.engine().time()) < 2400) {
      if (arena.referee()->state().location == world::Location::GameOn) {
        follower.look(arena.engine().truth(), counts);
      } else {
        follower.stop();
      }
      for (const referee::Call& call : arena.calls()) fouls[0][call.row] += 1;
    }
    const auto& score = arena.referee()->state().score;
    for (const world::Team team : world::both_teams) {
      const std::size_t who = (team == world::Team::Yellow) == (yellow == 0) ? 0 : 1;
      spells[who].all += counts[team].all;
      spells[who].kicked += counts[team].kicked;
      spells[who].lost += counts[team].lost;
      spells[who].time_to_kick += counts[team].time_to_kick;
      goals[who] += score[team];
    }
    const int a = yellow == 0 ? score.yellow : score.blue;
    const int b = yellow == 0 ? score.blue : score.yellow;
    wins += a > b;
    losses += a < b;
    std::printf("%d:%d ", a, b);
    std::fflush(stdout);
  }
  // Two-sided sign test, normal approximation with continuity correction: for tuning.
  const int decided = wins + losses;
  const double z = decided > 0 ? (std::abs(wins - losses) - 1) / std::sqrt(static_cast<double>(decided)) : 0;
  std::printf("\nA wins %d, draws %d, losses %d, goals %d:%d, z %.2f, p %.4f\n", wins, games - decided,
              losses, goals[0], goals[1], wins >= losses ? z : -z,
              std::erfc(std::max(z, 0.0) / std::sqrt(2.0)));
  for (std::size_t who = 0; who < 2; ++who) {
    const Spells& s = spells[who];
    std::printf("%c: %.1f spells a game, kicked %.0f %%, lost %.0f %%, %.2f s to the kick\n", "AB"[who],
                static_cast<double>(s.all) / games, 100.0 * s.kicked / std::max(s.all, 1),
                100.0 * s.lost / std::max(s.all, 1), s.time_to_kick / std::max(s.kicked, 1));
  }
  std::printf("calls a game:");
  for (const auto& [row, count] : fouls[0])
    std::printf("  %s %.1f", row.c_str(), static_cast<double>(count) / games);
  std::printf("\n");
}
