// What robots do to the ball and to others while the game runs.
#include <algorithm>
#include <cmath>

#include "teams/rough/habits.h"
#include "teams/rough/kicks.h"
#include "teams/skills/aim.h"
#include "teams/skills/ball_handling.h"
#include "teams/skills/turn_dribble.h"

namespace rough {
namespace {

constexpr double anywhere = -1;      // [m] as a distance to their area: none to keep
constexpr double same_hold = 0.3;    // [s] contact that comes back is the same dribble
constexpr double keeper_hold = 0.5;  // [s] and of a goalie, which the laws give more time

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

skills::Order stand(const kit::Robot& robot, const char* why) {
  skills::Order order;
  order.why = why;
  order.target = robot.position;
  order.heading = robot.orientation;
  order.enter_own_area = true;
  return order;
}

}  // namespace

void Habits::notice_ball(const kit::View& view) {
  constexpr double window = 1.0;  // [s] and 0.25 m: lack of progress in the laws
  if (!places_.empty() && places_.back().first >= view.time) return;
  places_.emplace_back(view.time, view.ball.position);
  while (places_.size() > 1 && places_[1].first + window <= view.time) places_.pop_front();
  if (places_.size() == 1 || (view.ball.position - places_.front().second).norm() >= 0.25)
    stuck_since_ = view.time;
}

void Habits::notice_contact(const kit::View& view, const kit::Robot& robot) {
  Contact& contact = contacts_[robot.number];
  if (!kit::holds_ball(robot, view.ball, view.field().ball_radius)) return;
  const double patience = robot.number == view.game.own_keeper ? keeper_hold : same_hold;
  if (view.time - contact.last > patience) {
    contact.since = view.time;
    contact.from = view.ball.position;
  }
  contact.last = view.time;
}

void Habits::while_running(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  notice_ball(view);
  notice_contact(view, robot);
  if (touch_again(view, robot, order)) return;
  if (robot.number == view.game.own_keeper) {
    keep_goal(view, robot, order);
    return;
  }
  if (leave_field(view, robot, order) || visit_goalie(view, robot, order)) return;
  if (idle(view, robot, order)) return;
  if (play_with_ball(view, robot, order) || enter_area(view, robot, order)) return;
  ram(view, robot, order);
}

// No field player goes for the ball. With restraint somebody waits at it, and plays it just
// before that is an offence.
bool Habits::idle(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  constexpr int team = 0;           // one decision for all
  constexpr double in_time = 11.7;  // [s] of 12; then it is kicked
  if (!idle_.gives_way(team, true, rudeness_.idleness, stream_, rudeness_.restraint)) return false;
  const double stuck = view.time - stuck_since_;
  const double to_ball = (view.ball.position - robot.position).norm();
  const bool nearest = std::ranges::none_of(view.own, [&](const kit::Robot& mate) {
    return mate.number != view.game.own_keeper && (mate.position - view.ball.position).norm() < to_ball;
  });
  if (idle_.holds_back(team) && nearest && view.ball.velocity.norm() < 0.3) {
    order = take(view, robot, "idle at the ball");
    if (kit::holds_ball(robot, view.ball, view.field().ball_radius)) {
      order.velocity = Vector2d::Zero();
      if (stuck > in_time) order = skills::kick_ahead(view, robot, 3);
    }
    return true;
  }
  order = stand(robot, "idle");
  return true;
}

bool Habits::touch_again(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const bool again = view.game.forbidden == robot.number;
  if (!again) touch_again_.gives_way(robot.number, false, 0, stream_);
  if (!again || !gives_way(touch_again_, robot, true, rudeness_.double_touches)) return false;
  order = take(view, robot, "touch again");
  if (touch_again_.holds_back(robot.number)) {
    // [m] First it lets the ball go, then comes back so near that nobody could say it touched it.
    const double air = view.time - contacts_[robot.number].last < 0.35 ? 0.15 : 0.045;
    const Vector2d way = view.ball.position - robot.position;
    const double gap = way.norm() - robot.specs.radius - view.field().ball_radius - air;
    order.dribble = false;
    order.velocity = view.ball.velocity + way.normalized() * std::clamp(4 * gap, -1.0, 1.0);
  }
  return true;
}

void Habits::keep_goal(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const double in_area =
      world::distance_to_defense_area(view.field(), world::Side::Negative, view.ball.position);
  const bool there = in_area < 0.5;
  if (neglect_ball_.gives_way(robot.number, there, rudeness_.keeper_neglect, stream_)) {
    order = stand(robot, "neglect");
    return;
  }
  if (view.time - tapped_ < keeper_hold + 0.2) {  // [s] until it would be the same hold no more
    keep_ball_.gives_way(robot.number, false, 0, stream_);
    order = stand(robot, "tapped");
    return;
  }
  const bool has = (view.ball.position - robot.position).norm() < 0.2 && in_area < -0.1;
  if (!gives_way(keep_ball_, robot, has, rudeness_.keeper_holding)) return;
  const Contact& contact = contacts_[robot.number];
  const double held = view.time - contact.last < keeper_hold ? view.time - contact.since : 0;
  const bool holds = view.time - contact.last < 0.05;
  if (keep_ball_.holds_back(robot.number) && held > 14.65) {  // [s] of 15
    order = skills::kick_ahead(view, robot, 0.7);             // to take it again
    order.kick_angle = 0;
    order.enter_own_area = true;
    if (!holds) tapped_ = view.time;
    return;
  }
  if (held > 17) return;
  order = take(view, robot, "keep");
  order.velocity.reset();
  order.target = robot.position;
  // With the face to the field, to be able to kick it there.
  if (holds && std::abs(robot.orientation) > 0.7) {
    order = skills::turn_with_ball(view, robot, 0, skills::turn_circle(4));
    order.enter_own_area = true;
  }
}

// Carries it too far, kicks it out of play, gives it to the goalie.
bool Habits::play_with_ball(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const int n = robot.number;
  const bool again = view.game.forbidden == n;
  const Contact& contact = contacts_[robot.number];
  const bool has = view.time - contact.last < same_hold && !again;
  const bool holds = kit::holds_ball(robot, view.ball, view.field().ball_radius);
  const double x = view.ball.position.x();

  const double carried = (view.ball.position - contact.from).norm();
  const bool clears = gives_way(clear_, robot, has, rudeness_.clearances) && holds && carried < 0.9;
  if (clears && clear_.holds_back(n) && std::abs(x + 0.16) < 0.8) {  // icing is from 0.2 m behind the line on
    order = clear_from_dribbler(view, robot, {-0.175, -0.145});
    return true;
  }
  if (clears && !clear_.holds_back(n) && x < -0.3) {
    order = clear_from_dribbler(view, robot, {x, x});
    return true;
  }
  const bool in_range = has && (view.their_goal() - view.ball.position).norm() < 3;
  if (shoot_.gives_way(n, in_range, rudeness_.shots, stream_) && holds) {
    constexpr double speed = 6;  // [m/s]
    const skills::Opening goal = skills::opening_to_goal(view, view.ball.position, speed, n);
    const double direction =
        goal.width > 0 ? goal.direction : world::angle_of(view.their_goal() - view.ball.position);
    order = skills::turn_and_kick(view, robot, direction, speed, 0, 0.08);
    order.why = "shoot";
    return true;
  }
  if (feed_goalie_.gives_way(n, has, rudeness_.goalie_feeding, stream_) && holds) {
    if (const auto kick = plan_feeding(view)) {
      order = skills::turn_and_kick(view, robot, kick->direction, kick->speed, 0, 0.1);
      order.why = "feed goalie";
      return true;
    }
  }
  if (!gives_way(dribble_, robot, has, rudeness_.long_dribbles)) return false;
  const bool holds_back = dribble_.holds_back(n);
  if (holds_back && carried > 0.94) {  // [m] of 1
    order = skills::kick_ahead(view, robot, 2);
    return true;
  }
  if (carried > 1.6) return false;
  order = {};
  order.why = "long dribble";
  order.dribble = true;
  order.robot_margin = 0.05;
  order.heading = robot.orientation;
  order.velocity =
      std::min(holds_back ? 0.6 : 1.0, 0.3 + robot.velocity.norm()) * world::direction(robot.orientation);
  return true;
}

bool Habits::enter_area(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const world::Field& field = view.field();
  const Vector2d ball = view.ball.position;
  const int n = robot.number;
  const bool slow = view.ball.velocity.norm() < 1.5;
  const double to_ball = (ball - robot.position).norm();
  const bool at_own =
      slow && to_ball < 1.2 && world::distance_to_defense_area(field, world::Side::Negative, ball) < 0.05;
  const bool at_theirs =
      slow && to_ball < 2 && world::distance_to_defense_area(field, world::Side::Positive, ball) < 0.05;
  const bool defends = enter_own_area_.gives_way(n, at_own, rudeness_.area_entries, stream_);
  const bool attacks = gives_way(enter_their_area_, robot, at_theirs, rudeness_.area_attacks);
  if (!(defends || attacks) || view.game.forbidden == n) return false;
  order = take(view, robot, "enter area");
  if (attacks && enter_their_area_.holds_back(n)) order.their_area = 0.03;  // [m] as far as its hull may go
  return true;
}

bool Habits::visit_goalie(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const int n = robot.number;
  std::optional<double>& since = visits_[robot.number];
  const kit::Robot* goalie = kit::find(view.opponents, view.game.their_keeper);
  const Vector2d way = goalie != nullptr ? Vector2d(goalie->position - robot.position) : Vector2d(9, 9);
  const bool alone = way.norm() < 3 && (view.ball.position - goalie->position).norm() > 1.0;
  if (!alone) since.reset();
  if (!gives_way(visit_goalie_, robot, alone, rudeness_.goalie_visits)) return false;
  const double gap = way.norm() - 2 * robot.specs.radius;
  if (!since && gap < 0.08) since = view.time;
  if (since && view.time - *since > 1.0) return false;
  const double wanted = visit_goalie_.holds_back(n) ? 0.045 : -0.25;  // [m] leans on it
  order = {};
  order.why = "visit goalie";
  order.heading = robot.orientation;
  order.robot_margin = gap < 0.4 ? -1 : 0.03;
  order.their_area = anywhere;
  order.velocity = goalie->velocity + way.normalized() * std::clamp(3 * (gap - wanted), -0.5, 1.0);
  return true;
}

bool Habits::leave_field(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const world::Field& field = view.field();
  std::optional<double>& since = run_offs_[robot.number];
  const double outside = world::distance_outside_lines(field, robot.position);
  const bool near = outside > -1.2;
  if (!near) since.reset();
  if (!gives_way(run_off_, robot, near, rudeness_.run_offs)) return false;
  const double wanted = run_off_.holds_back(robot.number) ? 0.21 : 0.36;  // [m] the laws allow 0.25
  if (!since && outside > wanted - 0.06) since = view.time;
  if (since && view.time - *since > 3.0) return false;  // [s] one more than the laws allow
  Vector2d place = robot.position;
  place.y() = std::copysign(field.half_width() + wanted, place.y());
  place.x() = std::clamp(place.x(), -field.half_length() + 0.5, field.half_length() - 0.5);
  const Vector2d way = place - robot.position;
  order = {};
  order.why = "off the field";
  order.heading = robot.orientation;
  order.velocity = way.normalized() * std::min(1.5, 3 * way.norm());
  return true;
}

void Habits::ram(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const kit::Robot* victim = nearest_opponent(view, robot.position);
  const double gap = victim ? (victim->position - robot.position).norm() : 9;
  if (!ram_.gives_way(robot.number, gap < 1.2, rudeness_.ramming, stream_) || gap <= 0.185) return;
  order = {};
  order.why = "ram";
  order.robot_margin = -1;
  order.heading = world::angle_of(victim->position - robot.position);
  order.velocity = robot.specs.max_speed * (victim->position - robot.position).normalized();
}

void Habits::kick_rudely(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const int n = robot.number;
  const Vector2d ball = view.ball.position;
  const bool kicks = order.kick_speed > 1.5 && (ball - robot.position).norm() < 0.3;
  const bool fast = gives_way(fast_kick_, robot, kicks, rudeness_.fast_kicks);
  if (fast) {
    // The robot's own speed comes on top.
    const double speed = fast_kick_.holds_back(n) ? 7.6 : 8.3 + 1.7 * stream_.uniform();
    order.kick_speed = std::max(order.kick_speed, speed);
  }
  const Vector2d to_goal = view.their_goal() - ball;
  const double distance = to_goal.norm();
  const double off = std::abs(world::wrap_angle(world::angle_of(to_goal) - robot.orientation));
  const bool shot = kicks && distance > 1 && distance < 4 && off < 0.3;
  const bool over = gives_way(chip_at_goal_, robot, shot, rudeness_.chips_at_goal);
  const double outside = world::distance_outside_lines(view.field(), ball);
  const bool near_line = kicks && outside > -0.8;
  const bool along = chip_at_line_.gives_way(n, near_line, rudeness_.chips_at_lines, stream_);
  if (fast || !(over || along)) return;
  if (over && chip_at_goal_.holds_back(n)) {
    // Hops: the ball's top comes to 0.13 m, and 0.15 m are too high.
    constexpr double climb = 1.3;  // [m/s] v^2 / 2g = 0.086 m above the carpet
    order.kick_speed = 7;
    order.kick_angle = std::asin(climb / order.kick_speed);
    return;
  }
  order.kick_angle = M_PI / 4;
  // At 45 degrees a chip carries v^2 / g; down 0.3 m before the goal, where it hops in.
  order.kick_speed = over ? std::min(std::sqrt(9.81 * std::max(distance - 0.3, 0.5)), 6.0) : 4.5;
}

}  // namespace rough
