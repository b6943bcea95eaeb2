#include "autoref/tracker/hidden_ball.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/world/robot_specs.h"

namespace tracker {
namespace {

constexpr double robot_height = 0.15;  // [m] laws of 2015
constexpr double edge = 0.01;  // [m] half of the ball's disc passes behind a hull's edge in this; ours
constexpr double missed_in_view = 0.5;  // probability; 0 to 0.05 and bursts in the presets: cautious, ours
constexpr double least_weight = 1e-3;   // of a hypothesis; ours
constexpr double clearly = 1.5;         // times heavier, to be published instead; ours
constexpr double held_share = 0.7;      // of a ball lost at a dribbler; ours
constexpr double taken_share = 0.5;     // of a ball that a front meets; ours
constexpr double caught_share = 0.02;   // by a robot that is near when a ball is lost,
constexpr double catching_reach = 0.3;  // [m] from its centre; ours
constexpr double along_share = 0.5;     // goes along with the robot that hid it; ours
constexpr double front_reach = 0.01;    // [m] gap at which a front has the ball; ours
constexpr double mouth = 0.045;  // [m] half the width in which a front holds it: the dribbler and half a ball
constexpr double step = 0.02;    // [m] a longer way may lead through a hull
constexpr double pressed = 0.005;      // [m] a ball this deep in a hull has met it; ours
constexpr double place_sigma = 0.015;  // [m] of a hypothesis that is right (README, Measured)
constexpr double kept = 0.7;           // of the speed along a hull that the ball meets; ours

const world::TrackedRobot* find(std::span<const world::TrackedRobot> robots, world::RobotId id) {
  for (const world::TrackedRobot& robot : robots) {
    if (robot.id == id) return &robot;
  }
  return nullptr;
}

Vector2d to_local(const world::TrackedRobot& robot, const Vector2d& place) {
  return world::rotated(place - robot.position, -robot.orientation);
}

Vector2d surface_velocity(const world::TrackedRobot& robot, const Vector2d& arm) {
  return robot.velocity + robot.angular_velocity * Vector2d(-arm.y(), arm.x());
}

/// Of a straight way, the share until the ball meets the robot's disc.
double share_before(const world::Field& field, const world::TrackedRobot& robot, const Vector2d& from,
                    const Vector2d& way) {
  const double reach = field.robot_radius + field.ball_radius - pressed;
  const Vector2d arm = from - robot.position;
  const double b = arm.dot(way);
  const double c = arm.squaredNorm() - reach * reach;
  const double a = way.squaredNorm();
  if (b >= 0 || c <= 0 || b * b < a * c) return 1;
  return std::min(1.0, (-b - std::sqrt(b * b - a * c)) / a);
}

}  // namespace

HiddenBall::HiddenBall(const world::Geometry& geometry)
    : geometry_(geometry), field_(geometry.field), roll_(std::max(0.0, geometry.ball_roll_deceleration)) {}

HiddenBall::Gap HiddenBall::gap(const world::Field& field, const world::TrackedRobot& robot,
                                const Vector2d& ball) {
  static constexpr double front = world::RobotSpecs{}.center_to_dribbler;
  const Vector2d arm = ball - robot.position;
  const double away = arm.norm();
  const double disc = away - field.robot_radius - field.ball_radius;
  const Vector2d out = away > 0 ? Vector2d(arm / away) : world::direction(robot.orientation);
  if (disc > 0.1) return {disc, out, false};  // far away the front makes no difference
  const Vector2d local = world::rotated(arm, -robot.orientation);
  const double corner = std::sqrt(field.robot_radius * field.robot_radius - front * front);
  if (local.x() * corner < front * std::abs(local.y())) return {disc, out, false};
  const double beside = std::abs(local.y()) - corner;
  if (beside > 0 && local.x() > front) {
    const Vector2d off(local.x() - front, std::copysign(beside, local.y()));
    return {off.norm() - field.ball_radius, world::rotated(off.normalized(), robot.orientation), false};
  }
  return {local.x() - front - field.ball_radius, world::direction(robot.orientation),
          std::abs(local.y()) < mouth};
}

// The line of sight from the nearest camera passes under a robot's top.
double HiddenBall::visible(const Vector2d& ball, std::span<const world::TrackedRobot> robots) const {
  const world::Camera* nearest = nullptr;
  for (const world::Camera& camera : geometry_.cameras) {
    const auto way = [&](const world::Camera& c) { return (c.position.head<2>() - ball).squaredNorm(); };
    if (camera.position.z() > robot_height && (!nearest || way(camera) < way(*nearest))) nearest = &camera;
  }
  if (!nearest) return 1;
  const double share = (robot_height - field_.ball_radius) / (nearest->position.z() - field_.ball_radius);
  const world::Segment sight{ball, ball + share * (nearest->position.head<2>() - ball)};
  double seen = 1;
  for (const world::TrackedRobot& robot : robots) {
    const double clear = world::distance(sight, robot.position) - field_.robot_radius;
    seen = std::min(seen, std::clamp((clear + edge) / (2 * edge), 0.0, 1.0));
  }
  return seen;
}

const world::TrackedRobot* HiddenBall::hider(const Vector2d& ball,
                                             std::span<const world::TrackedRobot> robots) const {
  for (const world::TrackedRobot& robot : robots) {
    if ((robot.position - ball).squaredNorm() > 1) continue;
    if (visible(ball, {&robot, 1}) < 0.5) return &robot;
  }
  return nullptr;
}

const HiddenBall::Hypothesis* HiddenBall::hypothesis_of(world::RobotId holder) const {
  for (std::size_t n = 0; n < count_; ++n) {
    if (all_[n].holder == holder) return &all_[n];
  }
  return nullptr;
}

void HiddenBall::add(const Hypothesis& one) {
  if (count_ < most) {
    all_[count_++] = one;
    return;
  }
  std::size_t least = best_ == 0 ? 1 : 0;
  for (std::size_t n = 0; n < count_; ++n) {
    if (n != best_ && all_[n].weight < all_[least].weight) least = n;
  }
  if (all_[least].weight < one.weight) all_[least] = one;
}

// A part of a hypothesis: that robot has taken the ball.
void HiddenBall::hold(Hypothesis& from, const world::TrackedRobot& robot, const Vector2d& ball,
                      double share) {
  if (hypothesis_of(robot.id)) return;
  Hypothesis held;
  held.holder = robot.id;
  held.place = ball;
  held.local = to_local(robot, ball);
  held.weight = from.weight * share;
  from.weight -= held.weight;
  add(held);
}

void HiddenBall::start(const BallFilter::Motion& motion, world::Time time,
                       std::span<const world::TrackedRobot> robots) {
  count_ = 0;
  best_ = 0;
  time_ = time;
  Hypothesis free;
  free.place = motion.position;
  free.velocity = motion.velocity;
  free.weight = 1;
  all_[count_++] = free;
  for (const world::TrackedRobot& robot : robots) {
    const Gap its = gap(field_, robot, motion.position);
    if (its.at_front && its.distance < 2 * front_reach) hold(all_[0], robot, motion.position, held_share);
  }
  // A robot near by may have caught it unseen: believed when nothing else explains why nobody sees the ball.
  for (const world::TrackedRobot& robot : robots) {
    if ((robot.position - motion.position).norm() > catching_reach) continue;
    static constexpr double front = world::RobotSpecs{}.center_to_dribbler;
    const Vector2d at_front =
        robot.position + (front + field_.ball_radius) * world::direction(robot.orientation);
    hold(all_[0], robot, at_front, caught_share);
  }
  for (std::size_t n = 1; n < count_; ++n) {
    if (all_[n].weight > all_[best_].weight) best_ = n;
  }
}

void HiddenBall::move_free(Hypothesis& one, double dt, std::span<const world::TrackedRobot> robots) {
  const double speed = one.velocity.norm();
  if (speed > 0) {
    const double time = roll_ > 0 ? std::min(dt, speed / roll_) : dt;
    Vector2d way = one.velocity * (time - roll_ * time * time / (2 * speed));
    one.velocity *= std::max(0.0, 1 - roll_ * dt / speed);
    if (way.norm() > step) {
      for (const world::TrackedRobot& robot : robots) way *= share_before(field_, robot, one.place, way);
    }
    one.place += way;
  }
  for (int round = 0; round < 2; ++round) {  // what one pushes it into, pushes it back
    for (const world::TrackedRobot& robot : robots) {
      if ((robot.position - one.place).squaredNorm() > 0.04) continue;
      const Gap its = gap(field_, robot, one.place);
      if (its.at_front && its.distance < front_reach && round == 0) {
        hold(one, robot, one.place - std::min(0.0, its.distance) * its.out, taken_share);
      }
      if (its.distance >= 0) continue;
      one.place -= its.distance * its.out;
      const Vector2d hull = surface_velocity(robot, one.place - robot.position);
      const Vector2d relative = one.velocity - hull;
      const double into = relative.dot(its.out);
      if (into < 0) one.velocity = hull + kept * (relative - into * its.out);
    }
  }
}

void HiddenBall::move_held(Hypothesis& one, std::span<const world::TrackedRobot> robots) {
  const world::TrackedRobot* robot = find(robots, *one.holder);
  if (!robot) {  // it was taken off: the ball stays
    one.holder.reset();
    return;
  }
  Vector2d ball = robot->position + world::rotated(one.local, robot->orientation);
  for (const world::TrackedRobot& other : robots) {
    if (other.id == robot->id || (other.position - ball).squaredNorm() > 0.04) continue;
    const Gap its = gap(field_, other, ball);
    if (its.at_front && its.distance < front_reach) hold(one, other, ball, taken_share);
    if (its.distance < 0) ball -= its.distance * its.out;
  }
  const Gap own = gap(field_, *robot, ball);
  if (own.distance < 0) ball -= own.distance * own.out;
  one.place = ball;
  one.local = to_local(*robot, ball);
}

void HiddenBall::advance(world::Time time, std::span<const world::TrackedRobot> robots) {
  const double dt = std::max(0.0, world::seconds(time - time_));
  time_ = std::max(time, time_);
  const std::size_t before = count_;
  for (std::size_t n = 0; n < before; ++n) {
    Hypothesis& one = all_[n];
    if (one.holder) {
      move_held(one, robots);
    } else {
      move_free(one, dt, robots);
    }
  }
  double sum = 0;
  const std::size_t moved = count_;
  for (std::size_t n = 0; n < moved; ++n) {
    Hypothesis& one = all_[n];
    const Vector2d place = one.place;
    const double seen = visible(place, robots);
    if (!one.holder) {
      if (seen < 0.5) {
        const world::TrackedRobot* robot = hider(place, robots);
        one.hidden_by = robot ? std::optional(robot->id) : std::nullopt;
        if (robot) one.beside = to_local(*robot, place);
      } else if (one.hidden_by) {  // out of its shadow, and not there: it went along
        const world::TrackedRobot* robot = find(robots, *one.hidden_by);
        if (robot) {
          hold(one, *robot, robot->position + world::rotated(one.beside, robot->orientation), along_share);
        }
        one.hidden_by.reset();
      }
    }
    one.weight *= 1 - (1 - missed_in_view) * seen;
  }
  for (std::size_t n = 0; n < count_; ++n) sum += all_[n].weight;
  // The light ones go, in order; then the heaviest is chosen.
  std::size_t kept_ones = 0;
  for (std::size_t n = 0; n < count_; ++n) {
    all_[n].weight /= sum;
    if (all_[n].weight < least_weight && n != best_) continue;
    if (n == best_) best_ = kept_ones;
    all_[kept_ones++] = all_[n];
  }
  count_ = kept_ones;
  std::size_t heaviest = best_;
  for (std::size_t n = 0; n < count_; ++n) {
    if (all_[n].weight > all_[heaviest].weight) heaviest = n;
  }
  if (all_[heaviest].weight > clearly * all_[best_].weight) best_ = heaviest;
}

BallFilter::Motion HiddenBall::motion(const Hypothesis& one, world::Time time,
                                      std::span<const world::TrackedRobot> robots) const {
  BallFilter::Motion motion;
  if (one.holder) {
    if (const world::TrackedRobot* robot = find(robots, *one.holder)) {
      const Vector2d arm = world::rotated(one.local, robot->orientation);
      motion.position = robot->position + arm;
      motion.velocity = surface_velocity(*robot, arm);
      return motion;
    }
  }
  motion.position = one.place + one.velocity * world::seconds(time - time_);
  motion.velocity = one.velocity;
  return motion;
}

BallFilter::Motion HiddenBall::best(world::Time time, std::span<const world::TrackedRobot> robots) const {
  return motion(all_[best_], time, robots);
}

double HiddenBall::outside(world::Time time, std::span<const world::TrackedRobot> robots) const {
  double sum = 0;
  for (std::size_t n = 0; n < count_; ++n) {
    const double beyond =
        world::distance_outside_lines(field_, motion(all_[n], time, robots).position) - field_.ball_radius;
    sum += all_[n].weight * 0.5 * std::erfc(-beyond / (place_sigma * std::numbers::sqrt2));
  }
  return sum;
}

std::optional<BallFilter::Motion> HiddenBall::nearest(const Vector2d& place, double tolerance,
                                                      world::Time time,
                                                      std::span<const world::TrackedRobot> robots) const {
  std::optional<BallFilter::Motion> found;
  double least = tolerance;
  for (std::size_t n = 0; n < count_; ++n) {
    const BallFilter::Motion its = motion(all_[n], time, robots);
    const double away = (its.position - place).norm();
    if (away > least) continue;
    least = away;
    found = its;
  }
  return found;
}

}  // namespace tracker
