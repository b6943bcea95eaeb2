#include "experiments/runner/refresher.h"

namespace runner {
namespace {

constexpr std::chrono::minutes longest{2};  // of one turn, ours: a report of 10 000 games takes seconds
constexpr std::size_t log_bytes = 65536;

}  // namespace

Refresher::Refresher(std::vector<std::string> command, std::chrono::milliseconds interval,
                     std::filesystem::path log)
    : command_(std::move(command)), interval_(interval), log_(std::move(log)), started_(Clock::now()) {}

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
  } else if (now - started_ > interval_) {
    start();
  }
  return std::nullopt;
}

std::optional<std::string> Refresher::last() {
  if (command_.empty()) return std::nullopt;
  if (child_) child_->wait(longest);
  child_.reset();
  start();
  if (child_) child_->wait(longest);
  return ended();
}

}  // namespace runner
