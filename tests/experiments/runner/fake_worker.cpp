// A worker that plays nothing: scores come from the seed, and it misbehaves as told.
//
//   fake_worker [--milliseconds N] [--fail always|first] [--how HOW] JOB RESULT
//
// HOW is one of:
//   crash, abort, exit, forfeit, interrupted
//   hang      before it plays
//   stuck     while it plays, printing all the time
//   long      goes on without end
//   silent    no result
//   nonsense  a bad result
//   eater     takes memory
// or, for a game that is good but strange:
//   differs   another hash whenever teams play live
//   unstable  another hash always
//   daemon    leaves a process in a session of its own
//   sparse    a forfeit, with a file of 1 TiB that has no bytes
//
// --fail first: only in the first attempt of pairs whose seed says so, about one game in four.
#include <signal.h>
#include <sys/wait.h>
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

/// A process that is in no group, session or family of ours.
void start_daemon() {
  if (const pid_t child = ::fork(); child != 0) {
    ::waitpid(child, nullptr, 0);
    return;
  }
  ::setsid();
  if (::fork() != 0) ::_exit(0);
  for (;;) ::pause();
}

void misbehave(const Behaviour& behaviour, runner::ProgressWriter& progress) {
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
  if (behaviour.how == "stuck") {
    progress.write(12.5);
    for (;;) std::cout << std::string(1000, 'x') << '\n';
  }
  if (behaviour.how == "long") {
    for (double seconds = 1;; ++seconds) {
      progress.write(seconds);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  if (behaviour.how == "eater") {
    progress.write(1);
    const std::string eaten(std::size_t{64} << 20, 'x');
    for (;;) ::pause();
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
  runner::ProgressWriter progress(runner::progress_file(behaviour.result));
  runner::serve_job(behaviour.job, behaviour.result, [&](const record::MatchConfig& config) {
    std::this_thread::sleep_for(behaviour.length);
    const bool first_attempt = behaviour.job.parent_path().filename() == "1";
    const bool fails =
        behaviour.fail == "always" || (behaviour.fail == "first" && first_attempt && config.seed % 4 == 0);
    record::MatchRecord record = score(config);
    const bool sparse = behaviour.how == "sparse";
    if (fails && (behaviour.how == "forfeit" || sparse)) {
      record.termination = record::Termination::Crashed;
      record.at_fault = record::Party::Yellow;
      record.reason = "yellow fell over";
    } else if (fails && behaviour.how == "interrupted") {
      record.termination = record::Termination::Interrupted;
      record.at_fault = record::Party::Harness;
      record.reason = "the game was interrupted";
    } else if (behaviour.how == "differs" || behaviour.how == "unstable") {
      record.hash += "-" + std::to_string(::getpid());
    }
    // The recorded replies of a game are its hash here.
    if (config.recording) std::ofstream(*config.recording) << record.hash << '\n';
    if (config.continuation && behaviour.how != "unstable") {
      std::ifstream(config.continuation->recording) >> record.hash;
    }
    if (fails && sparse) {
      const std::filesystem::path folder = behaviour.job.parent_path() / "yellow";
      std::filesystem::create_directories(folder);
      std::ofstream(folder / "long").close();
      std::filesystem::resize_file(folder / "long", std::uintmax_t{1} << 40);
    }
    if (behaviour.how == "daemon") start_daemon();
    if (fails && !sparse && behaviour.how != "forfeit" && behaviour.how != "interrupted")
      misbehave(behaviour, progress);
    return record;
  });
}
