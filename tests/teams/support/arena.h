#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "autoref/referee/referee.h"
#include "autoref/tracker/tracker.h"
#include "experiments/host/ball_reset.h"
#include "sim/engine/engine.h"
#include "teams/kit/looker.h"

namespace support {

/// Who plays: an empty `make` leaves the side away.
struct Side {
  std::function<std::unique_ptr<kit::Team>(const kit::Setup&)> make;
  std::vector<int> robots = {0, 1, 2, 3, 4, 5};
  double speed_factor = 1;
};

/// A game without processes, sockets and messages: engine, and team objects called directly. With a referee,
/// or with a message the test writes itself.
class Arena {
 public:
  Arena(Side yellow, Side blue, std::uint64_t seed, const char* realism = "measured");

  /// Plays with a real referee from now on.
  void start_referee(world::Duration half_length);
  /// One tick. False when the referee has finished.
  bool tick();

  /// Without referee: what the teams are told.
  void tell(world::Command command, std::optional<world::Vector2d> designated = {});
  world::RefereeMessage& told() { return told_; }

  engine::Engine& engine() { return *engine_; }
  referee::Referee* referee() { return referee_.get(); }
  const kit::View* view(world::Team team) const {
    return players_[team].looker ? &players_[team].looker->view() : nullptr;
  }
  kit::Team* team(world::Team team) { return players_[team].team.get(); }
  const world::TeamCommands& commands(world::Team team) const { return commands_[team]; }
  std::span<const referee::Call> calls() const { return calls_; }
  double thinking_seconds() const { return thinking_seconds_; }  ///< both teams: tracker, view, decisions

 private:
  struct Player {
    std::unique_ptr<kit::Team> team;
    std::optional<tracker::Tracker> tracker;
    std::optional<kit::Looker> looker;
  };
  world::PerTeam<Player> players_;
  world::PerTeam<int> keepers_{};
  world::PerTeam<world::TeamCommands> commands_;
  std::unique_ptr<engine::Engine> engine_;
  std::unique_ptr<referee::Referee> referee_;
  host::BallReset ball_reset_;
  world::RefereeMessage told_;
  std::span<const referee::Call> calls_;
  double thinking_seconds_ = 0;
};

}  // namespace support
