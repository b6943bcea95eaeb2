#include "autoref/tracker/ball_track.h"

#include <algorithm>
#include <cmath>

namespace tracker {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t max_candidates = 16;  // a swarm of false balls must not cost time; ours
constexpr double same_ball = 0.05;          // [m] two reports so near are one ball seen twice; a ball's width
constexpr double wall_reach = 0.15;         // [m] a ball within this of a line may meet a post or wall; ours
constexpr double start_sigma = 1.0;         // [m/s] of a velocity from two sightings; ours
constexpr double held_tolerance = 0.06;     // [m] a held ball re-appears this near to its place; ours
constexpr double least_gate = 0.01;  // [m] slack of the greatest speed, for noise and calibration; ours
constexpr double half_frame =
    world::tick_length / 2;           // [s] two cameras' offset must not look like a speed; ours
constexpr double disagreement = 0.1;  // [m] between badly calibrated cameras (football.md 5: up to 0.1 m)
constexpr double rival_speed = 2.0;   // [m/s] distance over this is how long a rival must wait; ours
constexpr world::Duration rival_least = 50ms;  // three frames
constexpr world::Duration rival_most = 1s;
constexpr world::Duration two_frames = 34ms;

double hull_gap(const world::Field& field, const world::TrackedRobot& robot, const world::Segment& path) {
  return world::distance(path, robot.position) - field.robot_radius - field.ball_radius;
}

}  // namespace

bool in_dribbler_zone(const world::TrackedRobot& robot, const Vector2d& ball) {
  // Requirements 1.10: x in 79..105 mm, |y| < 50 mm; held against the front plate (73 mm) the centre is at
  // 94.5 mm. Widened by 10 to 19 mm for the push of contact and a filter's error in a turn; ours.
  const Vector2d offset = ball - robot.position;
  if (offset.squaredNorm() > 0.13 * 0.13) return false;
  const Vector2d local = world::rotated(offset, -robot.orientation);
  return local.x() > 0.06 && local.x() < 0.115 && std::abs(local.y()) < 0.05;
}

BallTrack::BallTrack(const world::Geometry& geometry, const Params& params)
    : field_(geometry.field), params_(params), filter_(geometry, params) {
  candidates_.reserve(max_candidates);
}

void BallTrack::reset() {
  known_ = false;
  hold_.reset();
  candidates_.clear();
}

void BallTrack::age(world::Time now) {
  if (known_ && now - seen_ > params_.ball_memory) {
    known_ = false;
    hold_.reset();
  }
  std::erase_if(candidates_, [now](const Candidate& candidate) { return candidate.stale(now); });
}

void BallTrack::see(std::span<const world::DetectedBall> balls, world::Time time, int camera,
                    std::span<const world::TrackedRobot> robots) {
  const bool followed = known_ && (time < seen_ || follow(balls, time, camera, robots));
  if (followed && balls.size() == 1) return;
  for (const world::DetectedBall& ball : balls) {
    if (followed && (ball.position - filter_.position()).norm() < same_ball) continue;
    consider(ball.position, time);
  }
  take_over();
  if (known_ && seen_ == time) remember_hold(robots);
}

bool BallTrack::could_be_struck(const Vector2d& from, const Vector2d& to,
                                std::span<const world::TrackedRobot> robots) const {
  if (world::distance_outside_lines(field_, to) > -wall_reach) return true;
  const world::Segment path{from, to};
  return std::ranges::any_of(robots, [&](const world::TrackedRobot& robot) {
    return hull_gap(field_, robot, path) < params_.near_gap;
  });
}

bool BallTrack::follow(std::span<const world::DetectedBall> balls, world::Time time, int camera,
                       std::span<const world::TrackedRobot> robots) {
  const double dt = world::seconds(time - seen_);
  const Vector2d from = filter_.position();

  if (time - seen_ > two_frames) {  // unseen for a while, perhaps carried
    if (const auto state = held(robots)) {
      for (const world::DetectedBall& ball : balls) {
        if ((ball.position - state->position).norm() > held_tolerance) continue;
        filter_.start(ball.position, state->velocity, start_sigma);
        seen_ = time;
        camera_.used(camera, time);
        remember_hold(robots);
        return true;
      }
    }
  }

  BallFilter ahead = filter_;
  const world::Segment path{from, from + filter_.velocity() * dt};
  const bool near_robot = std::ranges::any_of(robots, [&](const world::TrackedRobot& robot) {
    return hull_gap(field_, robot, path) < params_.near_gap;
  });
  ahead.predict(dt, near_robot);

  const Vector2d expected = ahead.position();
  const world::DetectedBall* nearest = nullptr;
  double nearest_distance = 0;
  for (const world::DetectedBall& ball : balls) {
    const double distance = (ball.position - expected).norm();
    if (nearest && distance >= nearest_distance) continue;
    nearest = &ball;
    nearest_distance = distance;
  }
  if (!nearest) return false;

  const Vector2d& measured = nearest->position;
  const bool expected_by_some = ahead.best_nis(measured) < params_.nis_gate;
  const bool agrees = expected_by_some && nearest_distance < CameraPreference::agreement;
  if (!agrees && nearest_distance < disagreement && camera_.distrusts(camera, time)) return true;
  const double travelled = (measured - from).norm();
  if (travelled > params_.max_ball_speed * dt + least_gate) return false;
  if (expected_by_some) {
    ahead.update(measured);
  } else if (dt > 0 && could_be_struck(from, measured, robots)) {
    ahead.start(measured, (measured - from) / std::max(dt, half_frame), params_.kick_sigma);
  } else if (nearest_distance < params_.ball_gate) {
    ahead.update(measured);
  } else {
    return false;
  }
  filter_ = ahead;
  seen_ = time;
  camera_.used(camera, time);
  remember_hold(robots);
  return true;
}

void BallTrack::consider(const Vector2d& position, world::Time time) {
  for (Candidate& candidate : candidates_) {
    if (!candidate.continues(position, time, params_.max_ball_speed)) continue;
    candidate.add(position, time);
    return;
  }
  std::erase_if(candidates_, [time](const Candidate& candidate) { return candidate.stale(time); });
  if (candidates_.size() < max_candidates) candidates_.emplace_back(position, time);
}

void BallTrack::take_over() {
  const Candidate* best = nullptr;
  for (const Candidate& candidate : candidates_) {
    if (!candidate.confirmed(params_.confirmations)) continue;
    if (known_) {
      const world::Duration unseen = candidate.last_seen() - seen_;
      // A rival was there while the ball was still seen elsewhere: a second ball rather than this one moved.
      const bool rival = candidate.first_seen() <= seen_;
      const double distance = (candidate.position() - filter_.position()).norm();
      const world::Duration wait =
          rival ? std::clamp(world::from_seconds(distance / rival_speed), rival_least, rival_most)
                : world::Duration{};
      if (unseen <= wait) continue;
    }
    if (!best || candidate.count() > best->count()) best = &candidate;
  }
  if (!best) return;
  filter_.start(best->position(), best->velocity(), start_sigma);
  known_ = true;
  seen_ = best->last_seen();
  camera_ = {};
  hold_.reset();
  candidates_.clear();
}

void BallTrack::remember_hold(std::span<const world::TrackedRobot> robots) {
  hold_.reset();
  const Vector2d ball = filter_.position();
  for (const world::TrackedRobot& robot : robots) {
    if (!in_dribbler_zone(robot, ball)) continue;
    hold_ = Hold{robot.id, world::rotated(ball - robot.position, -robot.orientation)};
    return;
  }
}

std::optional<BallFilter::Motion> BallTrack::held(std::span<const world::TrackedRobot> robots) const {
  if (!hold_) return std::nullopt;
  for (const world::TrackedRobot& robot : robots) {
    if (robot.id != hold_->robot) continue;
    const Vector2d arm = world::rotated(hold_->ball_local, robot.orientation);
    return BallFilter::Motion{robot.position + arm,
                              robot.velocity + robot.angular_velocity * Vector2d(-arm.y(), arm.x())};
  }
  return std::nullopt;
}

world::TrackedBall BallTrack::foretell(world::Time time, std::span<const world::TrackedRobot> robots) const {
  const world::Duration unseen = std::max(world::Duration{}, time - seen_);
  const auto carried = unseen > two_frames ? held(robots) : std::nullopt;
  const BallFilter::Motion state = carried ? *carried : filter_.foretell(world::seconds(unseen));
  world::TrackedBall ball;
  ball.position.head<2>() = state.position;
  ball.velocity.head<2>() = state.velocity;
  ball.unseen = unseen;
  return ball;
}

}  // namespace tracker
