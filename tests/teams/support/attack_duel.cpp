// Plays pairs of games between two settings of the reference team in this process and prints what each did
// with the ball: the tool for tuning a feature.
//
//   attack_duel PAIRS HALF_SECONDS FIRST_SEED [flags of A] [-- flags of B]
//   attack_duel 10 300 1 --attack zones -- --attack greedy
//
// In the first game of a pair A is yellow, in the second blue, with the same seed.

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
          flags.parse(static_cast<int>(arguments.size()), arguments.data(), "attack_duel", "settings")) {
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

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: attack_duel PAIRS HALF_SECONDS FIRST_SEED [flags of A] [-- flags of B]\n");
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
  int wins = 0, losses = 0;
  double thinking = 0, ticks = 0, squares = 0, difference = 0, stoppages = 0;
  for (int game = 0; game < 2 * pairs; ++game) {
    const world::Team a = game % 2 == 0 ? world::Team::Yellow : world::Team::Blue;
    const world::Team b = a == world::Team::Yellow ? world::Team::Blue : world::Team::Yellow;
    support::Arena arena(side(settings[game % 2]), side(settings[1 - game % 2]),
                         static_cast<std::uint64_t>(first_seed + game / 2));
    arena.start_referee(world::from_seconds(half));
    while (arena.tick() && world::seconds(arena.engine().time()) < 4 * half + 600) {
      stoppages += static_cast<double>(arena.calls().size());
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
  std::printf(
      "A: %d wins, %d draws, %d losses; %+.2f +- %.2f goals a game; %.1f us a tick and team, calls %.0f\n",
      wins, static_cast<int>(games) - wins - losses, losses, mean,
      std::sqrt((squares / games - mean * mean) / games), thinking / ticks / 2 * 1e6, stoppages / games);
}
