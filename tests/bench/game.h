#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "autoref/referee/referee.h"
#include "experiments/host/ball_reset.h"
#include "experiments/host/channel.h"
#include "experiments/host/game_hash.h"
#include "experiments/host/messages.h"
#include "experiments/host/robot_count.h"
#include "experiments/host/tally.h"
#include "sim/engine/engine.h"
#include "teams/kit/channel.h"
#include "teams/kit/session.h"

namespace hot {

/// What a tick consists of, in the order in which it happens.
enum class Part : std::uint8_t { Engine, Referee, Bookkeeping, Encode, Channel, Session, Decode };
inline constexpr std::size_t part_count = 7;
const char* name(Part part);

kit::MakeTeam reference_team();
/// The plainest players, of this folder alone: they do not change when teams and skills do. The nearest robot
/// runs at the ball and kicks, the others stand in their own half, off a ball that is not theirs.
kit::MakeTeam plain_team();

/// The standard game in one process: everything the host does in a tick and everything both team programs do,
/// through real sockets and in the same order, without processes.
class Game {
 public:
  explicit Game(const kit::MakeTeam& players = reference_team(), std::uint64_t seed = 7);

  /// One tick. False when the referee has finished.
  bool tick();
  /// Ticks until the given match time [s].
  void play_to(double seconds);

  /// Called when a part of a tick has been done; Channel and Session once for each team.
  std::function<void(Part)> on_part = [](Part) {};

  const engine::Engine& engine() const { return *engine_; }
  const referee::Referee& referee() const { return *referee_; }
  /// Of the last tick.
  const referee::Output& output() const { return output_; }
  const world::PerTeam<world::TeamCommands>& commands() const { return commands_; }
  /// What was sent to a team, without its length, and its answer; only with `keep`.
  const std::string& payload(world::Team team) const { return payloads_[team]; }
  const std::string& reply(world::Team team) const { return replies_[team]; }
  const std::string& hello(world::Team team) const { return hellos_[team]; }
  const record::MatchConfig& config() const { return config_; }
  const referee::Setup& setup() const { return setup_; }
  /// Of the system, for the channels so far.
  std::int64_t host_calls() const;
  std::int64_t team_calls() const;

  /// Keeps payloads and replies for reading, which costs copies.
  bool keep = false;

 private:
  struct Side;

  void exchange(world::Team team);

  record::MatchConfig config_;
  referee::Setup setup_;
  std::unique_ptr<engine::Engine> engine_;
  std::unique_ptr<referee::Referee> referee_;
  world::PerTeam<std::shared_ptr<Side>> sides_;
  host::TickMessages messages_;
  host::GameHash hash_;
  host::Tally tally_;
  host::BallReset ball_reset_;
  host::RobotCount robot_count_;
  referee::Output output_;
  world::PerTeam<world::TeamCommands> commands_;
  world::PerTeam<int> bad_commands_{};
  world::PerTeam<std::string> hellos_, payloads_, replies_;
};

/// The bytes behind the length of a frame.
std::span<const std::byte> payload_of(std::string_view frame);

}  // namespace hot
