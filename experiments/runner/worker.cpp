#include "experiments/runner/worker.h"

#include <array>
#include <csignal>
#include <ctime>
#include <fstream>

#include "experiments/runner/job_files.h"

namespace runner {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_quote = 300;  // [bytes] of a worker's last words in the ledger

fs::path job_file(const fs::path& folder) { return folder / "job.json"; }
fs::path result_file(const fs::path& folder) { return folder / "result.json"; }
fs::path log_file(const fs::path& folder) { return folder / "worker.log"; }

process::Child start(std::vector<std::string> command, int cpu, const Job& job, const fs::path& folder) {
  fs::remove_all(folder);  // of an attempt that was cut short
  fs::create_directories(folder);
  record::MatchConfig config = job.game.config;
  config.directory = folder;
  write_job(job_file(folder), config);
  command.push_back(job_file(folder).string());
  command.push_back(result_file(folder).string());
  return process::Child({.arguments = std::move(command),
                         .environment = {},
                         .directory = {},
                         .output = log_file(folder),
                         .cpu = cpu});
}

/// The last line of the worker's log: usually what it died of.
std::string last_words(const fs::path& folder) {
  std::ifstream stream(log_file(folder));
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  if (last.size() > longest_quote) last.resize(longest_quote);
  return last;
}

}  // namespace

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

Worker::Worker(const std::vector<std::string>& command, const WorkerLimits& limits, int slot, int cpu,
               Job job, const fs::path& folder)
    : limits_(limits),
      slot_(slot),
      job_(std::move(job)),
      folder_(folder),
      started_(utc_now()),
      child_(start(command, cpu, job_, folder)) {}

std::optional<record::Attempt> Worker::poll() {
  const bool ended = child_.has_ended();
  const Clock::time_point now = Clock::now();
  const std::size_t printed = child_.output().written() + child_.output().discarded();
  if (printed != printed_) last_sign_ = now;
  printed_ = printed;

  if (ended) return attempt(result());
  const auto seconds = [](std::chrono::milliseconds span) {
    return std::to_string(span.count() / 1000) + " s";
  };
  if (now - last_sign_ > limits_.silence) {
    stop();
    return attempt(fault("no sign of life from the worker for " + seconds(limits_.silence)));
  }
  if (now - start_ > limits_.game) {
    stop();
    return attempt(fault("the game took longer than " + seconds(limits_.game)));
  }
  return std::nullopt;
}

record::MatchRecord Worker::result() {
  const process::Exit exit = child_.stop(std::chrono::milliseconds{0});  // and whatever it left behind
  if (!exit.clean()) {
    const std::string words = last_words(folder_);
    return fault("the worker " + exit.describe() + (words.empty() ? "" : "; it said last: " + words));
  }
  try {
    return read_result(result_file(folder_));
  } catch (const std::exception& error) {
    return fault(std::string("the worker left no usable result: ") + error.what());
  }
}

record::MatchRecord Worker::fault(const std::string& reason) const {
  record::MatchRecord record;
  record.termination = record::Termination::HarnessFault;
  record.at_fault = record::Party::Harness;
  record.reason = reason;
  record.wall_seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  return record;
}

record::Attempt Worker::attempt(record::MatchRecord record) const {
  record::Attempt attempt = attempt_of(job_);
  attempt.record = std::move(record);
  attempt.started = started_;
  attempt.worker = slot_;
  return attempt;
}

void Worker::ask_to_end() { ::kill(-child_.pid(), SIGTERM); }
void Worker::stop() { child_.stop(limits_.grace); }

}  // namespace runner
