#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "autoref/referee/referee.h"
#include "experiments/judge/shadow.h"
#include "sim/engine/engine.h"

namespace judge {

/// An outside autoref beside the acting referee: a program that thinks it is at a game of the league.
///
/// It runs in a network namespace of its own:
/// - SSL-Vision's packets come on 224.5.23.2:10006: every camera image when it is delivered, the geometry
///   once a second.
/// - The acting referee's messages come on 224.5.23.1:10003: when they change, and ten times a second.
/// - It reports to the game controller's port 10007.
///
/// Time in the packets is the match's; they are sent at its pace by the wall clock,
/// or `speed` times as fast. It hears `linger` later that play was stopped: the league's controller takes a
/// second to stop it, ours a tick.
///
/// What it says depends on the machine's load: such a shadow is not deterministic. The game is.
class NetShadow {
 public:
  /// Enters the namespace (the whole process does) and starts the program by the shell.
  /// @throws std::invalid_argument without the right to a namespace; process::StartError
  NetShadow(std::string name, const std::string& command, double speed, const world::Geometry& geometry,
            world::RuleSet rules);
  ~NetShadow();
  NetShadow(NetShadow&&) noexcept;

  const std::string& name() const { return name_; }
  const world::RuleSet& rules() const { return rules_; }

  /// Sends what the tick brought, waits for its time, and hears reports. The first time it waits until the
  /// program has registered.
  /// @throws std::runtime_error when the program does not register within 10 s, or has ended
  void tick(const engine::Engine& engine, const referee::Referee& referee);
  /// Hears the last reports and ends the program with all it has started.
  void end();

  const std::vector<Call>& calls() const { return calls_; }

 private:
  struct Inside;
  void take();
  void wait_for_registration();

  std::string name_;
  double speed_;
  world::RuleSet rules_;
  std::vector<Call> calls_;
  std::unique_ptr<Inside> inside_;
};

}  // namespace judge
