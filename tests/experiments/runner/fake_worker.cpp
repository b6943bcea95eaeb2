// A worker that plays nothing: scores come from the seed, and it misbehaves as told.
//
//   fake_worker [--milliseconds N] [--fail always|first] [--how
//   crash|abort|exit|hang|silent|nonsense|forfeit|flood] JOB RESULT
//
// --fail first: only in the first attempt of pairs whose seed says so, about one game in four.
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>

#include "experiments/runner/job_files.h"

namespace {

struct Behaviour {
  std::chrono::milliseconds length{0};
  std::string fail = "never";
  std::string how = "crash";
  std::filesystem::path job;
  std::filesystem::path result;
};

Behaviour read(int argc, char** argv) {
  Behaviour behaviour;
  int i = 1;
  for (; i + 2 < argc; i += 2) {
    const std::string flag = argv[i];
    const std::string value = argv[i + 1];
    if (flag == "--milliseconds") behaviour.length = std::chrono::milliseconds(std::stoi(value));
    if (flag == "--fail") behaviour.fail = value;
    if (flag == "--how") behaviour.how = value;
  }
  behaviour.job = argv[i];
  behaviour.result = argv[i + 1];
  return behaviour;
}

record::MatchRecord score(const record::MatchConfig& config) {
  record::MatchRecord record;
  record.goals = {.yellow = static_cast<int>(config.seed % 4),
                  .blue = static_cast<int>(config.seed / 16 % 4)};
  record.termination = record::Termination::Finished;
  record.at_fault = record::Party::Nobody;
  record.ticks = 72'000;
  record.hash = std::to_string(config.seed);
  record.wall_seconds = 0.001 * static_cast<double>(::getpid() % 1000);  // differs from run to run, as it may
  return record;
}

void misbehave(const Behaviour& behaviour) {
  if (behaviour.how == "crash") ::raise(SIGKILL);
  if (behaviour.how == "abort") {
    std::cerr << "assertion failed: ball is round" << std::endl;
    std::abort();
  }
  if (behaviour.how == "exit") std::exit(3);
  if (behaviour.how == "hang") {
    ::signal(SIGTERM, SIG_IGN);
    for (;;) ::pause();
  }
  if (behaviour.how == "flood") {
    for (;;) std::cout << std::string(1000, 'x') << '\n';
  }
  if (behaviour.how == "silent") std::exit(0);
  if (behaviour.how == "nonsense") {
    std::ofstream(behaviour.result) << "{\"goals\": 3}\n";
    std::exit(0);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Behaviour behaviour = read(argc, argv);
  runner::serve_job(behaviour.job, behaviour.result, [&](const record::MatchConfig& config) {
    std::this_thread::sleep_for(behaviour.length);
    const bool first_attempt = behaviour.job.parent_path().filename() == "1";
    const bool fails =
        behaviour.fail == "always" || (behaviour.fail == "first" && first_attempt && config.seed % 4 == 0);
    record::MatchRecord record = score(config);
    if (fails && behaviour.how == "forfeit") {
      record.termination = record::Termination::Crashed;
      record.at_fault = record::Party::Yellow;
      record.reason = "yellow fell over";
    } else if (fails) {
      misbehave(behaviour);
    }
    return record;
  });
}
