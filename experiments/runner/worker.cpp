#include "experiments/runner/worker.h"

#include <array>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <fstream>

#include "experiments/process/family.h"
#include "experiments/process/tree.h"
#include "experiments/runner/job_files.h"
#include "sim/files/regular_file.h"

namespace runner {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_quote = 300;  // [bytes] of a worker's last words in the ledger
constexpr std::chrono::milliseconds memory_look{1000};

fs::path job_file(const fs::path& folder) { return folder / "job.json"; }
fs::path result_file(const fs::path& folder) { return folder / "result.json"; }
fs::path log_file(const fs::path& folder) { return folder / "worker.log"; }

std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000));
}

/// "60 s", "0.2 s"
std::string text(std::chrono::milliseconds span) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g s", std::chrono::duration<double>(span).count());
  return text.data();
}

process::Child start(std::vector<std::string> command, const WorkerLimits& limits, const Job& job,
                     const Place& place) {
  process::remove_tree(place.folder);  // of an attempt that was cut short
  fs::create_directories(place.folder);
  std::vector<std::pair<std::string, std::string>> environment = {
      {game_variable, place.folder.string() + "/"}};
  if (!place.scratch.empty()) {
    fs::create_directories(place.scratch);
    environment.emplace_back("TMPDIR", place.scratch.string());
  }
  record::MatchConfig config = job.game.config;
  config.directory = place.folder;
  write_job(job_file(place.folder), config);
  command.push_back(job_file(place.folder).string());
  command.push_back(result_file(place.folder).string());
  return process::Child({.arguments = std::move(command),
                         .environment = std::move(environment),
                         .directory = {},
                         .output = log_file(place.folder),
                         .output_limit = limits.output,
                         .cpu = place.cpu});
}

/// The last line of the worker's log: usually what it died of.
std::string last_words(const fs::path& folder) {
  if (!files::not_regular(log_file(folder)).empty()) return "";
  std::ifstream stream(log_file(folder));
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  if (last.size() > longest_quote) last.resize(longest_quote);
  return last;
}

}  // namespace

WorkerLimits worker_limits(const schedule::Limits& limits, std::chrono::milliseconds start_up,
                           std::chrono::milliseconds grace) {
  WorkerLimits result;
  result.start_up = start_up;
  result.grace = grace;
  result.silence = milliseconds(limits.silence);
  result.game = milliseconds(limits.game);
  result.output = static_cast<std::size_t>(limits.output) << 20;
  return result;
}

std::string start_problem(const std::exception& error) {
  return std::string("the worker could not be started: ") + error.what();
}

record::MatchRecord never_started(const std::exception& error) {
  record::MatchRecord record;
  record.termination = record::Termination::HarnessFault;
  record.at_fault = record::Party::Harness;
  record.reason = start_problem(error);
  return record;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

Worker::Worker(const std::vector<std::string>& command, const WorkerLimits& limits, Job job, Place place)
    : limits_(limits),
      job_(std::move(job)),
      place_(std::move(place)),
      child_(start(command, limits_, job_, place_)) {}

double Worker::seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

std::optional<record::Attempt> Worker::poll() {
  const bool ended = child_.has_ended();  // empties its pipe too
  const Clock::time_point now = Clock::now();
  if (ended) return attempt(result());
  if (const auto problem = trouble(now)) {
    stop();
    return attempt(fault(*problem));
  }
  return std::nullopt;
}

std::optional<std::string> Worker::trouble(Clock::time_point now) {
  const std::optional<double> simulated = read_progress(progress_file(result_file(place_.folder)));
  if (simulated && (!began_ || *simulated > simulated_)) {
    began_ = true;
    simulated_ = *simulated;
    last_sign_ = now;
  }
  if (!began_ && now - start_ > limits_.start_up) {
    return "the worker did not begin to play within " + text(limits_.start_up);
  }
  if (began_ && now - last_sign_ > limits_.silence) {
    std::array<char, 64> where{};
    std::snprintf(where.data(), where.size(), "%.1f s", simulated_);
    return "stuck at " + std::string(where.data()) + " of the match: no simulated time has passed for " +
           text(limits_.silence);
  }
  if (now - start_ > limits_.game) return "the game took longer than " + text(limits_.game);
  if (now - memory_seen_ > memory_look) {
    memory_seen_ = now;
    const std::int64_t held = process::resident_memory(child_.pid());
    if (held > limits_.memory) {
      return "the worker held " + std::to_string(held >> 20) + " MiB of memory, " +
             std::to_string(limits_.memory >> 20) + " MiB are allowed";
    }
  }
  return std::nullopt;
}

record::MatchRecord Worker::result() {
  const process::Exit exit = child_.stop(std::chrono::milliseconds{0});  // and whatever it left behind
  if (!exit.clean()) {
    const std::string words = last_words(place_.folder);
    return fault("the worker " + exit.describe() + (words.empty() ? "" : "; it said last: " + words));
  }
  try {
    return read_result(result_file(place_.folder));
  } catch (const std::exception& error) {
    return fault(std::string("the worker left no usable result: ") + error.what());
  }
}

record::MatchRecord Worker::fault(const std::string& reason) const {
  record::MatchRecord record;
  record.termination = record::Termination::HarnessFault;
  record.at_fault = record::Party::Harness;
  record.reason = reason;
  record.wall_seconds = seconds();
  return record;
}

record::Attempt Worker::attempt(record::MatchRecord record) {
  strays_ = process::end_started_with(game_variable + ("=" + place_.folder.string() + "/"));
  if (!place_.scratch.empty()) process::remove_tree(place_.scratch);  // the run's end removes what is left
  record::Attempt attempt = attempt_of(job_);
  attempt.record = std::move(record);
  attempt.started = place_.started;
  attempt.worker = place_.slot;
  return attempt;
}

void Worker::ask_to_end() { ::kill(-child_.pid(), SIGTERM); }
void Worker::stop() { child_.stop(limits_.grace); }

}  // namespace runner
