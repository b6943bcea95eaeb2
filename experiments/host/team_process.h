#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "experiments/host/channel.h"
#include "experiments/host/listener.h"
#include "experiments/host/messages.h"
#include "experiments/process/child.h"
#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"

namespace host {

/// What a team did wrong: it ends the game.
struct Fault {
  record::Termination termination{};
  std::string reason;  ///< one sentence, naming the colour
};

/// Until when something may take, on the wall clock.
struct Deadline {
  using Clock = std::chrono::steady_clock;
  explicit Deadline(std::chrono::milliseconds span) : allowed(span), end(Clock::now() + span) {}
  bool has_passed() const { return Clock::now() >= end; }

  std::chrono::milliseconds allowed;
  Clock::time_point end;
};

/// One team as the host sees it: a process, a socket, and what went wrong with it.
///
/// Every function that talks to the team does nothing once it has a fault. While it waits it calls
/// `while_waiting` every 10 ms at least, which may throw to leave.
class TeamProcess {
 public:
  using Idle = std::function<void()>;

  /// @param socket  path for the team's socket; the listening starts here
  TeamProcess(world::Team team, const record::TeamConfig& config, const std::filesystem::path& socket);

  /// Starts the program, its output going to a file in `directory` unless that is empty; NotStarted when that
  /// fails.
  void start(const std::filesystem::path& directory);
  /// Waits for its connection until `deadline`.
  void accept(const Deadline& deadline, const Idle& while_waiting);

  /// Writes one frame.
  void send(std::string_view frame, const Deadline& deadline, const Idle& while_waiting);
  /// Waits for the next frame; false when there is none, which is a fault.
  bool receive(const Deadline& deadline, const Idle& while_waiting);
  /// The frame that came, as a message, valid until the next one; null when it is none, which is a fault.
  const wire::proto::TeamMessage* message();

  /// Declares a fault; the first one counts.
  void blame(record::Termination termination, const std::string& what);
  const std::optional<Fault>& fault() const { return fault_; }

  /// Empties the pipe of its standard output.
  void drain();

  /// Says goodbye, gives it `grace` to leave, and ends what is left of it.
  void end(const std::string& reason, std::chrono::milliseconds grace);

  /// What it has used so far, or had when it ended.
  const process::Usage& usage() const { return usage_; }
  std::int64_t bytes_in() const { return channel_ ? channel_->bytes_in() : 0; }
  std::int64_t channel_calls() const { return channel_ ? channel_->calls() : 0; }
  pid_t pid() const { return child_ ? child_->pid() : -1; }

 private:
  void note_gone();  // it closed the channel or ended: why?

  world::Team team_;
  record::TeamConfig config_;
  Listener listener_;
  std::optional<process::Child> child_;
  std::optional<Channel> channel_;
  std::span<const std::byte> payload_;  // of the last frame, in the channel's memory
  MessageParser parser_;
  std::optional<Fault> fault_;
  process::Usage usage_;
};

}  // namespace host
