#include "experiments/runner/refresher.h"

#include <algorithm>

namespace runner {
namespace {

constexpr std::chrono::minutes longest{2};      // of one turn, ours: a report of 10 000 games takes seconds
constexpr std::chrono::milliseconds pause{20};  // between two looks whether anybody still waits
constexpr std::size_t log_bytes = 65536;
constexpr int share = 20;  // at most a twentieth of the time goes into it, however long one turn takes (ours)

}  // namespace

Refresher::Refresher(std::vector<std::string> command, std::chrono::milliseconds interval,
                     std::filesystem::path log)
    : command_(std::move(command)),
      interval_(interval),
      pause_(interval),
      log_(std::move(log)),
      started_(Clock::now()) {}

void Refresher::start() {
  started_ = Clock::now();
  try {
    child_.emplace(process::Command{.arguments = command_,
                                    .environment = {},
                                    .directory = {},
                                    .output = log_,
                                    .output_limit = log_bytes});
  } catch (const std::runtime_error& error) {
    problem_ = error.what();
  }
}

std::optional<std::string> Refresher::ended() {
  std::string how;
  if (child_) {
    const process::Exit exit = child_->stop(std::chrono::milliseconds{0});
    child_.reset();
    pause_ = std::max<Clock::duration>(interval_, share * (Clock::now() - started_));
    if (exit.clean()) {
      std::error_code ignored;
      std::filesystem::remove(log_, ignored);
      return std::nullopt;
    }
    how = exit.describe();
  } else {
    how = problem_.value_or("");
    problem_.reset();
  }
  if (complained_) return std::nullopt;
  complained_ = true;
  return "the report could not be renewed: " + command_.front() + " " + how + "; what it said is in " +
         log_.string();
}

std::optional<std::string> Refresher::look(Clock::time_point now) {
  if (command_.empty()) return std::nullopt;
  if (problem_) return ended();
  if (child_) {
    if (child_->has_ended() || now - started_ > longest) return ended();
  } else if (now - started_ > pause_) {
    start();
  }
  return std::nullopt;
}

/// False when nobody waits for it.
bool Refresher::wait(const std::function<bool()>& enough) {
  const auto until = Clock::now() + longest;
  while (child_ && !child_->wait(pause) && Clock::now() < until) {
    if (enough && enough()) return false;
  }
  return true;
}

std::optional<std::string> Refresher::last(const std::function<bool()>& enough) {
  if (command_.empty()) return std::nullopt;
  for (const bool again : {false, true}) {
    if (again) start();
    if (wait(enough)) continue;
    child_.reset();
    return std::nullopt;
  }
  return ended();
}

}  // namespace runner
