#include "teams/reference/reference_team.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "teams/reference/defense.h"
#include "teams/reference/goalie.h"
#include "teams/reference/legal.h"
#include "teams/reference/restart.h"

namespace reference {
namespace {

using kit::Phase;

// Places are chosen for this long, then only walked to [s].
constexpr double choose_places_for = 0.7;

// Nobody waits for us to find better ones: the referee waits until everyone is at rest.
bool holds_places(Phase phase) {
  return is_dead(phase) || is_kickoff(phase) || phase == Phase::PreparePenalty;
}

}  // namespace

void ReferenceTeam::play(const kit::View& real, world::TeamCommands& out) {
  const kit::View& view = with_ball_in_place(real);
  notice_phase(view);
  const Situation& situation = observer_.observe(view);
  give_out_roles(view, situation);
  supports_tactic_.think(view, situation, roles_, parameters_, winner_.choice());
  for (const kit::Robot& robot : view.own) {
    skills::Order& order = orders_[robot.number];
    order = order_for(view, situation, robot);
    make_legal(real, robot, roles_, parameters_, order);
    const bool kicker = roles_.winner == robot.number && view.game.ours;
    if (holds_places(view.game.phase) && !kicker) hold_place(real, robot, order);
    if (revise_) revise_(view, robot, roles_, order);
    out.push_back(steering_.command(real, robot, order));
  }
  std::optional<Kick> kicked;
  if (roles_.winner >= 0 && orders_[static_cast<std::size_t>(roles_.winner)].kick_speed > 0) {
    kicked = winner_.choice();
  }
  telemetry_.update(view, situation, roles_, supports_tactic_.partition(), kicked);
  if (notes_) write_note(view, situation);
}

void ReferenceTeam::notice_phase(const kit::View& view) {
  const Phase phase = view.game.phase;
  const bool ball_jumped = (view.ball.position - phase_ball_).norm() > 0.3 && phase != Phase::Running;
  if (phase == phase_ && !ball_jumped) return;
  if (phase_ == Phase::PrepareKickoff && phase == Phase::Kickoff) {
    phase_ = phase;  // places stay: who changes them now crosses the halfway line on the way
    winner_.forget();
    return;
  }
  if (phase != phase_ || is_dead(phase)) places_.fill({});
  phase_ = phase;
  phase_began_ = view.time;
  phase_ball_ = view.ball.position;
  if (phase != Phase::Running) winner_.forget();
}

void ReferenceTeam::give_out_roles(const kit::View& view, const Situation& situation) {
  const kit::Game& game = view.game;
  Possession possession = situation.possession;
  if (game.phase != Phase::Running) possession = game.ours ? Possession::Ours : Possession::Theirs;
  if (is_dead(game.phase)) possession = Possession::Contested;
  const int field_players = std::max(0, static_cast<int>(view.own.size()) - 1);
  const Formation shape = formation(field_players, possession, view.ball.position.x(), parameters_);
  std::optional<int> receiver;
  if (game.phase == Phase::Running) receiver = winner_.receiver(view);
  roles_ = assign_roles(view, situation, roles_, shape, receiver);
}

// While the ball is dead it is going to be placed: everything is planned for where it will lie.
const kit::View& ReferenceTeam::with_ball_in_place(const kit::View& view) {
  if (!is_dead(view.game.phase) || !view.game.designated_position) return view;
  dead_ball_view_ = view;
  dead_ball_view_.ball.position = *view.game.designated_position;
  dead_ball_view_.ball.velocity = Vector2d::Zero();
  dead_ball_view_.ball.height = 0;
  return dead_ball_view_;
}

skills::Order ReferenceTeam::order_for(const kit::View& view, const Situation& situation,
                                       const kit::Robot& robot) {
  const bool must_leave = view.game.forbidden == robot.number && view.game.phase == Phase::Running;
  switch (roles_.of(robot.number)) {
    case Role::Goalie:
      return goalie_order(view, situation, robot);
    case Role::Winner:
      return winner_order(view, situation, robot);
    case Role::Support:
      if (must_leave) return leave_ball(view, robot);
      return supports_tactic_.play(view, robot);
    case Role::Defender: {
      if (must_leave) return leave_ball(view, robot);
      const auto task = static_cast<std::size_t>(roles_.index[robot.number]);
      return play_defender(view, robot, roles_.defense.tasks[task]);
    }
    case Role::None:
      break;
  }
  return {};
}

skills::Order ReferenceTeam::goalie_order(const kit::View& view, const Situation& situation,
                                          const kit::Robot& robot) {
  const kit::Game& game = view.game;
  const bool alone = roles_.winner == robot.number;
  if (alone && game.ours && game.phase != Phase::Running) {
    skills::Order order = winner_order(view, situation, robot);
    order.enter_own_area = true;
    return order;
  }
  if (is_penalty(game.phase) && !game.ours) return face_penalty(view, robot);
  if (alone && game.phase == Phase::Running && may_leave_goal(view, situation, robot)) {
    skills::Order order = winner_order(view, situation, robot);
    order.enter_own_area = true;
    return order;
  }
  return play_goalie(view, situation, robot);
}

skills::Order ReferenceTeam::winner_order(const kit::View& view, const Situation& situation,
                                          const kit::Robot& robot) {
  const kit::Game& game = view.game;
  if (is_dead(game.phase) || (game.phase != Phase::Running && !game.ours)) {
    return block_the_ball(view, robot, parameters_);
  }
  KickRules rules;
  rules.targets = supports_tactic_.targets();
  switch (game.phase) {
    case Phase::PrepareKickoff:
    case Phase::PreparePenalty:
      return wait_behind_ball(view, robot);
    case Phase::Kickoff:
      rules.given = set_kick(view, rules.targets);
      rules.must_kick = true;
      rules.must_go_forward = true;
      return winner_.play(view, situation, robot, rules, parameters_);
    case Phase::Penalty:
      return take_penalty(view, robot, parameters_);
    case Phase::DirectFree:
    case Phase::IndirectFree: {
      if (game.age < parameters_.kick_delay) return wait_behind_ball(view, robot);
      rules.must_kick = true;
      rules.shot_allowed = game.phase == Phase::DirectFree;
      if (set_play(view) == SetPlay::GoalKick) {
        rules.only_targets = true;
        rules.otherwise = long_goal_kick(view);
      }
      return winner_.play(view, situation, robot, rules, parameters_);
    }
    default:
      break;
  }
  // The ball is in the goalie's hands: wait outside for what comes out.
  const double in_area =
      world::distance_to_defense_area(view.field(), world::Side::Negative, view.ball.position);
  if (in_area < 0 && view.ball.velocity.norm() < 1.5) {
    skills::Order order;
    order.why = "wait for goalie";
    order.target =
        world::moved_out_of_defense_area(view.field(), world::Side::Negative, view.ball.position, 0.5);
    order.heading = world::angle_of(view.ball.position - robot.position);
    return order;
  }
  rules.shot_allowed = !game.indirect;
  return winner_.play(view, situation, robot, rules, parameters_);
}

// The first 0.7 s choose a place, then it is kept: a formation that goes on moving would
// keep the referee waiting.
void ReferenceTeam::hold_place(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  std::optional<Vector2d>& place = places_[robot.number];
  const bool still_choosing = view.time - phase_began_ < choose_places_for;
  if (!place || (still_choosing && (order.target - *place).norm() > 0.3)) {
    place = place_apart(view, robot, order);
  }
  order.target = *place;
}

// The order's target, or the nearest legal place beside it that no team-mate holds: two robots that want the
// same place never come to rest.
Vector2d ReferenceTeam::place_apart(const kit::View& view, const kit::Robot& robot,
                                    const skills::Order& order) const {
  const auto is_free = [&](const Vector2d& point) {
    for (const kit::Robot& mate : view.own) {
      const std::optional<Vector2d>& held = places_[mate.number];
      if (mate.number == robot.number || !held) continue;
      if ((*held - point).norm() < robot.specs.radius + mate.specs.radius + 0.06) return false;
    }
    return true;
  };
  if (is_free(order.target)) return order.target;
  for (const double radius : {0.15, 0.3, 0.45}) {
    for (int i = 0; i < 8; ++i) {
      skills::Order beside = order;
      beside.target += radius * world::direction(M_PI / 4 * i);
      make_legal(view, robot, roles_, parameters_, beside);
      if (is_free(beside.target)) return beside.target;
    }
  }
  return order.target;
}

void ReferenceTeam::write_note(const kit::View& view, const Situation& situation) {
  std::array<char, 128> line;
  std::snprintf(line.data(), line.size(), "%s%s %s", kit::name(view.game.phase),
                view.game.ours ? " (ours)" : "", name(situation.possession));
  note_ = line.data();
  for (const kit::Robot& robot : view.own) {
    const skills::Order& order = orders_[robot.number];
    std::snprintf(line.data(), line.size(), "; %d %s: %s", robot.number, name(roles_.of(robot.number)),
                  order.why);
    note_ += line.data();
  }
  if (winner_.choice()) {
    std::snprintf(line.data(), line.size(), "; %s %.2f", name(winner_.choice()->kind),
                  winner_.choice()->value);
    note_ += line.data();
  }
}

}  // namespace reference
