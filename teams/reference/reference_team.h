#pragma once

#include <array>
#include <functional>
#include <string>

#include "teams/kit/team.h"
#include "teams/reference/parameters.h"
#include "teams/reference/roles.h"
#include "teams/reference/situation.h"
#include "teams/reference/support.h"
#include "teams/reference/telemetry.h"
#include "teams/reference/winner.h"
#include "teams/skills/steer.h"

namespace reference {

/// Changes an order after everything else was decided: how another team is made of this one.
using Revise = std::function<void(const kit::View&, const kit::Robot&, const Roles&, skills::Order&)>;

/// The reference team: observes, gives out roles, lets each tactic say an order, makes it legal for the phase
/// of the game, and steers.
class ReferenceTeam final : public kit::Team {
 public:
  ReferenceTeam(const kit::Setup& setup, const Parameters& parameters, bool notes = false)
      : setup_(setup), parameters_(parameters), notes_(notes) {}

  /// From now on every order passes through `revise` before steering.
  void revise_orders(Revise revise) { revise_ = std::move(revise); }

  void play(const kit::View& view, world::TeamCommands& out) override;
  std::string_view note() const override { return note_; }
  std::string summary() const override { return telemetry_.summary(); }

  /// The order of one robot in this tick; for tests and notes.
  const skills::Order& order_of(int number) const { return orders_[static_cast<std::size_t>(number)]; }
  const Roles& roles() const { return roles_; }
  const Telemetry::Counts& counts() const { return telemetry_.counts(); }

 private:
  void notice_phase(const kit::View& view);
  void give_out_roles(const kit::View& view, const Situation& situation);
  skills::Order order_for(const kit::View& view, const Situation& situation, const kit::Robot& robot);
  skills::Order goalie_order(const kit::View& view, const Situation& situation, const kit::Robot& robot);
  skills::Order winner_order(const kit::View& view, const Situation& situation, const kit::Robot& robot);
  const kit::View& with_ball_in_place(const kit::View& view);
  void hold_place(const kit::View& view, const kit::Robot& robot, skills::Order& order);
  Vector2d place_apart(const kit::View& view, const kit::Robot& robot, const skills::Order& order) const;
  void write_note(const kit::View& view, const Situation& situation);

  kit::Setup setup_;
  Parameters parameters_;
  bool notes_;
  Revise revise_;

  Observer observer_;
  Roles roles_;
  Winner winner_;
  Supports supports_tactic_;
  Telemetry telemetry_;
  skills::Steering steering_;
  kit::View dead_ball_view_;
  std::array<skills::Order, world::max_robot_number + 1> orders_;

  // Places held while the ball is dead, so that the robots come to rest and the game goes on.
  kit::Phase phase_ = kit::Phase::Halt;
  double phase_began_ = 0;  // [s]
  Vector2d phase_ball_ = Vector2d::Zero();
  std::array<std::optional<Vector2d>, world::max_robot_number + 1> places_;
  std::string note_;
};

}  // namespace reference
