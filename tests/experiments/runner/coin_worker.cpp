// A worker whose teams toss coins: each scores a Poisson number of goals, drawn from the game's seed,
// whose mean stands in its command as goals=1.5. Games take no time, so that whole experiments can be
// played by the thousand.
//
//   coin_worker JOB RESULT
#include <cmath>
#include <cstdlib>
#include <string>

#include "experiments/runner/job_files.h"
#include "sim/world/random.h"

namespace {

double mean_of(const record::TeamConfig& team) {
  const std::string key = "goals=";
  for (const std::string& word : team.command) {
    if (word.rfind(key, 0) == 0) return std::strtod(word.c_str() + key.size(), nullptr);
  }
  return 1;
}

/// Knuth's method.
int poisson(world::RandomStream& random, double mean) {
  const double limit = std::exp(-mean);
  int goals = -1;
  for (double product = 1; product > limit; ++goals) product *= random.uniform();
  return goals;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  runner::serve_job(argv[1], argv[2], [](const record::MatchConfig& config) {
    world::RandomStream random(config.seed, "coin");
    record::MatchRecord record;
    record.goals.yellow = poisson(random, mean_of(config.teams.yellow));
    record.goals.blue = poisson(random, mean_of(config.teams.blue));
    record.termination = record::Termination::Finished;
    record.at_fault = record::Party::Nobody;
    record.hash = std::to_string(config.seed);
    return record;
  });
}
