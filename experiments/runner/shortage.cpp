#include "experiments/runner/shortage.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "experiments/process/program.h"

namespace runner {
namespace {

constexpr std::chrono::milliseconds longest{60'000};  // ours: a night loses a minute at most when it passes

}  // namespace

bool is_shortage(const std::exception& error) {
  if (const auto* start = dynamic_cast<const process::StartError*>(&error)) {
    return process::is_shortage(start->cause());
  }
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  return system != nullptr && process::is_shortage(system->code().value());
}

bool is_shortage(const record::MatchRecord& record) {
  if (record.termination != record::Termination::HarnessFault) return false;
  constexpr std::array causes = {EAGAIN, ENOMEM, EMFILE, ENFILE};
  return std::any_of(causes.begin(), causes.end(), [&](int cause) {
    return record.reason.find(std::generic_category().message(cause)) != std::string::npos;
  });
}

std::optional<std::string> Shortage::failed(Clock::time_point now, const std::string& reason) {
  reason_ = reason;
  if (waiting(now)) return std::nullopt;
  const bool first = !since_;
  wait_ = first ? first_ : std::min(2 * wait_, std::max(longest, first_));
  until_ = now + wait_;
  if (!first) return std::nullopt;
  since_ = now;
  return reason +
         ": the machine lacks processes, memory or open files; games are started again after a while";
}

std::optional<std::string> Shortage::too_long(Clock::time_point now) const {
  if (!since_ || now - *since_ < patience_) return std::nullopt;
  return reason_ + ": for " +
         std::to_string(std::chrono::duration_cast<std::chrono::seconds>(now - *since_).count()) +
         " s the machine has lacked processes, memory or open files";
}

}  // namespace runner
