// Plays pairs of games between two settings of the reference team in this process and prints what each did
// with the ball: the tool for tuning a feature.
//
// team_duel PAIRS HALF_SECONDS FIRST_SEED [flags of A] [-- flags of B]
//   team_duel 10 300 1 --attack zones -- --attack greedy
// In the first game of a pair A is yellow, in the second blue, with the same seed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "teams/reference/reference_team.h"
#include "tests/teams/support/arena.h"

namespace {

reference::Parameters parsed(const std::vector<const char*>& arguments) {
  reference::Parameters parameters;
  kit::Flags flags;
  reference::declare(flags, parameters);
  if (const auto code =
          flags.parse(static_cast<int>(arguments.size()), arguments.data(), "team_duel", "settings")) {
    std::exit(*code);
  }
  return parameters;
}

support::Side side(const reference::Parameters& parameters) {
  support::Side s;
  s.make = [parameters](const kit::Setup& setup) {
    return std::make_unique<reference::ReferenceTeam>(setup, parameters);
  };
  return s;
}

// Sums over the games of one setting.
struct Total {
  double passes = 0, completed = 0, intercepted = 0, shots = 0, redirects = 0, clearances = 0;
  double goals_after_pass = 0, possession = 0, entropy = 0, goals = 0;

  void add(const reference::Telemetry::Counts& c) {
    passes += c.passes, completed += c.completed, intercepted += c.intercepted;
    shots += c.shots, redirects += c.redirects, clearances += c.clearances;
    goals_after_pass += c.goals_after_pass;
    possession += c.possession_share(), entropy += c.zone_entropy();
  }
  void print(const char* name, double games) const {
    std::printf(
        "%s a game: goals %.2f (after a pass %.2f), shots %.1f (at the first touch %.1f), passes %.1f, "
        "completed %.0f %%, intercepted %.0f %%, clearances %.1f, possession %.3f, zone entropy %.2f\n",
        name, goals / games, goals_after_pass / games, shots / games, redirects / games, passes / games,
        100 * completed / passes, 100 * intercepted / passes, clearances / games, possession / games,
        entropy / games);
  }
};

/// Spells with the ball at one robot's dribbler, by how they ended.
struct Spells {
  int all = 0, kicked = 0, lost = 0;  // lost: an opponent had the break beam next, without a kick
  double time_to_kick = 0;            // [s] summed over the kicked

  void add(const Spells& other) {
    all += other.all, kicked += other.kicked, lost += other.lost, time_to_kick += other.time_to_kick;
  }
  void print(const char* name, double games) const {
    std::printf("%s at the dribbler: %.1f times a game, kicked %.0f %%, lost %.0f %%, %.2f s to the kick\n",
                name, all / games, 100.0 * kicked / std::max(all, 1), 100.0 * lost / std::max(all, 1),
                time_to_kick / std::max(kicked, 1));
  }
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
  if (argc < 4) {
    std::fprintf(stderr, "usage: team_duel PAIRS HALF_SECONDS FIRST_SEED [flags of A] [-- flags of B]\n");
    return 2;
  }
  const int pairs = std::atoi(argv[1]);
  const double half = std::atof(argv[2]);
  const int first_seed = std::atoi(argv[3]);
  std::array<std::vector<const char*>, 2> arguments{{{"a"}, {"b"}}};
  std::size_t reading = 0;
  for (int i = 4; i < argc; ++i) {
    if (std::string(argv[i]) == "--") {
      reading = 1;
    } else {
      arguments[reading].push_back(argv[i]);
    }
  }
  const std::array<reference::Parameters, 2> settings{parsed(arguments[0]), parsed(arguments[1])};

  std::array<Total, 2> totals;
  std::array<Spells, 2> spells;
  int wins = 0, losses = 0;
  double thinking = 0, ticks = 0, squares = 0, difference = 0, stoppages = 0;
  for (int game = 0; game < 2 * pairs; ++game) {
    const world::Team a = game % 2 == 0 ? world::Team::Yellow : world::Team::Blue;
    const world::Team b = a == world::Team::Yellow ? world::Team::Blue : world::Team::Yellow;
    support::Arena arena(side(settings[game % 2]), side(settings[1 - game % 2]),
                         static_cast<std::uint64_t>(first_seed + game / 2));
    arena.start_referee(world::from_seconds(half));
    Follower follower;
    world::PerTeam<Spells> counts;
    while (arena.tick() && world::seconds(arena.engine().time()) < 4 * half + 600) {
      stoppages += static_cast<double>(arena.calls().size());
      if (arena.referee()->state().location == world::Location::GameOn) {
        follower.look(arena.engine().truth(), counts);
      } else {
        follower.stop();
      }
    }
    const auto& score = arena.referee()->state().score;
    const int ours = score[a], theirs = score[b];
    wins += ours > theirs;
    losses += ours < theirs;
    difference += ours - theirs;
    squares += (ours - theirs) * (ours - theirs);
    totals[0].goals += ours;
    totals[1].goals += theirs;
    totals[0].add(static_cast<reference::ReferenceTeam*>(arena.team(a))->counts());
    totals[1].add(static_cast<reference::ReferenceTeam*>(arena.team(b))->counts());
    spells[0].add(counts[a]);
    spells[1].add(counts[b]);
    thinking += arena.thinking_seconds();
    ticks += static_cast<double>(arena.engine().tick());
    std::printf("%d:%d ", ours, theirs);
    std::fflush(stdout);
  }
  const double games = 2 * pairs;
  const double mean = difference / games;
  std::printf("\n");
  totals[0].print("A", games);
  totals[1].print("B", games);
  spells[0].print("A", games);
  spells[1].print("B", games);
  std::printf(
      "A: %d wins, %d draws, %d losses; %+.2f +- %.2f goals a game; %.1f us a tick and team, calls %.0f\n",
      wins, static_cast<int>(games) - wins - losses, losses, mean,
      std::sqrt((squares / games - mean * mean) / games), thinking / ticks / 2 * 1e6, stoppages / games);
}
