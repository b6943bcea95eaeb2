#include "teams/rough/habits.h"

#include <algorithm>
#include <cmath>

#include "teams/reference/legal.h"
#include "teams/skills/ball_handling.h"

namespace rough {
namespace {

using kit::Phase;

constexpr double anywhere = -1;  // [m] as a distance to their area: none to keep

bool is_free_kick(Phase phase) { return phase == Phase::DirectFree || phase == Phase::IndirectFree; }

const kit::Robot* nearest_opponent(const kit::View& view, const Vector2d& point) {
  const kit::Robot* nearest = nullptr;
  for (const kit::Robot& other : view.opponents) {
    if (nearest == nullptr || (other.position - point).norm() < (nearest->position - point).norm()) {
      nearest = &other;
    }
  }
  return nearest;
}

skills::Order take(const kit::View& view, const kit::Robot& robot, const char* why) {
  skills::Order order = skills::capture(view, robot, kit::BallModel(view.geometry));
  order.why = why;
  order.enter_own_area = true;
  order.their_area = anywhere;
  return order;
}

}  // namespace

bool Temptation::gives_way(int robot, bool opportunity, double rate, world::RandomStream& stream) {
  State& state = states_[static_cast<std::size_t>(robot)];
  if (!opportunity) {
    state = {};
  } else if (!state.open) {
    state.open = true;
    state.gave_way = stream.uniform() < rate;
  }
  return state.gave_way;
}

// The ball is dead or the kick is theirs: too near, too fast, in the wrong half.
void Habits::while_dead_or_theirs(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const Phase phase = view.game.phase;
  const bool stopped = phase == Phase::Stop;
  if (encroach_.gives_way(robot.number, true, rudeness_.encroachment, stream_)) {
    const Vector2d ball = view.game.designated_position.value_or(view.ball.position);
    Vector2d out = robot.position - ball;
    if (out.norm() < 0.05) out = view.own_goal() - ball;
    order.why = "encroach";
    order.target = ball + out.normalized() * (0.2 + robot.specs.radius);
    order.ball_distance = 0.1;
  }
  if (speed_.gives_way(robot.number, stopped, rudeness_.stop_speeding, stream_)) {
    // Up and down beside its place, so that there is something to be fast for.
    const double side = static_cast<int>(view.time) % 2 == 0 ? 1.2 : -1.2;
    order.why = "speed";
    order.max_speed = robot.specs.max_speed;
    order.target.x() += order.target.x() > 0 ? -std::abs(side) + side : std::abs(side) + side;
  }
}

// A kick of ours is due.
void Habits::while_ours(const kit::View& view, const kit::Robot& robot, bool kicker, skills::Order& order) {
  const bool free_kick = is_free_kick(view.game.phase);
  if (kicker) {
    if (do_not_kick_.gives_way(robot.number, free_kick, rudeness_.slow_restarts, stream_)) {
      order = {};
      order.why = "dawdle";
      order.target = robot.position;
      order.heading = robot.orientation;
      return;
    }
    // A tap, to be there again at once.
    if (touch_again_.gives_way(robot.number, free_kick, rudeness_.double_touches, stream_)) {
      if (order.kick_speed > 0) order.kick_speed = 1.0;
      order.kick_angle = 0;
    }
    return;
  }
  if (wait_at_area_.gives_way(robot.number, free_kick, rudeness_.area_waiting, stream_)) {
    order.why = "wait at area";
    order.target = world::moved_out_of_defense_area(
        view.field(), world::Side::Positive, view.their_goal() - Vector2d(0.9, 0.3 * robot.number - 0.8),
        robot.specs.radius + 0.05);
    order.their_area = 0.02;
  }
}

// What a robot does to the ball and to others while the game runs.
void Habits::while_running(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const std::size_t n = robot.number;
  const bool goalie = robot.number == view.game.own_keeper;
  const bool again = view.game.forbidden == robot.number;
  if (again && touch_again_.gives_way(robot.number, true, rudeness_.double_touches, stream_)) {
    order = take(view, robot, "touch again");
    return;
  }
  if (!again) touch_again_.gives_way(robot.number, false, 0, stream_);
  if (goalie) {
    const bool has =
        (view.ball.position - robot.position).norm() < 0.2 &&
        world::distance_to_defense_area(view.field(), world::Side::Negative, view.ball.position) < -0.1;
    if (!has) keeping_since_ = view.time;
    const bool keeps = keep_ball_.gives_way(robot.number, has, rudeness_.keeper_holding, stream_);
    if (!keeps || view.time - keeping_since_ > 17) return;
    order = take(view, robot, "keep");
    order.velocity.reset();
    order.target = robot.position;
    return;
  }
  // Contact that comes back within 0.3 s is the same dribble.
  const bool holds = kit::holds_ball(robot, view.ball, view.field().ball_radius);
  if (holds && view.time - last_contact_[n] > 0.3) dribble_from_[n] = view.ball.position;
  if (holds) last_contact_[n] = view.time;
  const bool has = view.time - last_contact_[n] < 0.3 && !again;
  const bool far = (view.ball.position - dribble_from_[n]).norm() > 1.6;
  if (dribble_.gives_way(robot.number, has, rudeness_.long_dribbles, stream_) && !far) {
    order = {};
    order.why = "long dribble";
    order.dribble = true;
    order.robot_margin = 0.05;
    order.heading = robot.orientation;
    order.velocity = std::min(1.0, 0.3 + robot.velocity.norm()) * world::direction(robot.orientation);
    return;
  }
  const double to_ball = (view.ball.position - robot.position).norm();
  const double to_area =
      std::min(world::distance_to_defense_area(view.field(), world::Side::Negative, view.ball.position),
               world::distance_to_defense_area(view.field(), world::Side::Positive, view.ball.position));
  const bool slow_in_area = to_area < 0.05 && view.ball.velocity.norm() < 1.5 && to_ball < 1.2;
  if (enter_area_.gives_way(robot.number, slow_in_area, rudeness_.area_entries, stream_) && !again) {
    order = take(view, robot, "enter area");
    return;
  }
  const kit::Robot* victim = nearest_opponent(view, robot.position);
  const double gap = victim ? (victim->position - robot.position).norm() : 9;
  if (ram_.gives_way(robot.number, gap < 1.2, rudeness_.ramming, stream_) && gap > 0.185) {
    order = {};
    order.why = "ram";
    order.robot_margin = -1;
    order.heading = world::angle_of(victim->position - robot.position);
    order.velocity = robot.specs.max_speed * (victim->position - robot.position).normalized();
  }
}

void Habits::kick_rudely(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const Vector2d ball = view.ball.position;
  const bool kicks = order.kick_speed > 1.5 && (ball - robot.position).norm() < 0.3;
  const bool fast = fast_kick_.gives_way(robot.number, kicks, rudeness_.fast_kicks, stream_);
  if (fast) order.kick_speed = std::max(order.kick_speed, 8.3 + 1.7 * stream_.uniform());

  const Vector2d to_goal = view.their_goal() - ball;
  const double distance = to_goal.norm();
  const double off = std::abs(world::wrap_angle(world::angle_of(to_goal) - robot.orientation));
  const bool shot = kicks && distance > 1 && distance < 4 && off < 0.3;
  const bool over = chip_at_goal_.gives_way(robot.number, shot, rudeness_.chips_at_goal, stream_);
  const double outside = world::distance_outside_lines(view.field(), ball);
  const bool near_line = kicks && outside > -0.8;
  const bool along = chip_at_line_.gives_way(robot.number, near_line, rudeness_.chips_at_lines, stream_);
  if (fast || !(over || along)) return;
  order.kick_angle = M_PI / 4;
  // At 45 degrees a chip carries v^2 / g; down 0.3 m before the goal, where it hops in.
  order.kick_speed = over ? std::min(std::sqrt(9.81 * std::max(distance - 0.3, 0.5)), 6.0) : 4.5;
}

// Every phase is an opportunity of its own.
void Habits::notice_phase(Phase phase) {
  if (phase == phase_) return;
  const bool kicked = phase == Phase::Running;
  phase_ = phase;
  for (Temptation* temptation : {&encroach_, &speed_, &wait_at_area_, &wrong_half_, &do_not_kick_}) {
    temptation->end();
  }
  if (!kicked) touch_again_.end();
}

void Habits::revise(const kit::View& view, const kit::Robot& robot, const reference::Roles& roles,
                    skills::Order& order) {
  const kit::Game& game = view.game;
  const Phase phase = game.phase;
  notice_phase(phase);
  const bool goalie = roles.goalie == robot.number;
  const bool kicker = roles.winner == robot.number && game.ours;
  if (phase == Phase::Running) {
    while_running(view, robot, order);
  } else if (goalie || reference::is_penalty(phase)) {
    return;
  } else if (phase == Phase::Kickoff && !kicker) {
    if (wrong_half_.gives_way(robot.number, true, rudeness_.wrong_half, stream_)) {
      order.why = "wrong half";
      order.target.x() = 0.4;
    }
  } else if (game.ours) {
    while_ours(view, robot, kicker, order);
  } else {
    while_dead_or_theirs(view, robot, order);
  }
  if (!goalie) kick_rudely(view, robot, order);
}

}  // namespace rough
