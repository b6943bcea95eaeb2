#include "autoref/tracker/ball_track.h"

#include <algorithm>
#include <cmath>

#include "autoref/optics/partly_hidden.h"

namespace tracker {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t max_candidates = 16;  // a swarm of false balls must not cost time; ours
constexpr double same_ball = 0.05;          // [m] two reports so near are one ball seen twice; a ball's width
constexpr double wall_reach = 0.15;         // [m] a ball within this of a line may meet a post or wall; ours
constexpr double start_sigma = 1.0;         // [m/s] of a velocity from two sightings; ours
constexpr double held_tolerance = 0.02;     // [m] a hidden ball re-appears this near to its place; ours
constexpr double least_gate = 0.01;  // [m] slack of the greatest speed, for noise and calibration; ours
constexpr double half_frame =
    world::tick_length / 2;           // [s] two cameras' offset must not look like a speed; ours
constexpr double disagreement = 0.1;  // [m] between badly calibrated cameras (football.md 5: up to 0.1 m)
constexpr double rival_speed = 2.0;   // [m/s] distance over this is how long a rival must wait; ours
constexpr world::Duration rival_least = 50ms;  // three frames
constexpr world::Duration rival_most = 1s;
constexpr world::Duration one_frame = 17ms;
constexpr world::Duration two_frames = 34ms;
constexpr double most_height = 2.0;              // [m] of a chipped ball: 1.8 m for 6 m/s straight up
constexpr world::Duration before_seen = 4ms;     // a kick shows little so soon after it; ours
constexpr world::Duration after_seen = 8ms;      // it may touch the robot first and be kicked then; ours
constexpr world::Duration out_of_hiding = 50ms;  // a kicked ball comes into view within this; ours
constexpr double kick_place_sigma = 0.010;       // [m] ours
constexpr double hidden_kick_sigma = 0.025;      // [m] ours
constexpr int kicked_away = 3;         // sightings after which a kicked ball has left the dribbler; ours
constexpr double landing_sigma = 0.5;  // [m/s] ours
// [m] a ball beside a robot may be partly hidden; ours, from the errors
constexpr double beside_sigma = 0.004;
constexpr double partly_sigma = 0.003;  // [m] of the centre of a partly hidden ball; ours
constexpr double hidden_drift = 0.06;   // [m/s] a hidden ball may be moved about; ours, from the errors
constexpr double hidden_sigma = 0.010;  // [m] at least, of a hidden ball (football.md 3.2)
constexpr double robot_height = 0.15;   // [m] laws of 2015
constexpr double least_flight = 0.03;   // [m] lower a struck ball is on the ground at once; ours
constexpr double pressed = 0.005;       // [m] a ball this deep in a hull has met it; ours

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
    : geometry_(geometry),
      field_(geometry.field),
      params_(params),
      filter_(geometry, params),
      hidden_(geometry) {
  candidates_.reserve(max_candidates);
}

void BallTrack::reset() {
  known_ = false;
  held_ = false;
  hidden_.clear();
  study_.reset();
  match_.reset();
  candidates_.clear();
}

void BallTrack::age(world::Time now, std::span<const world::TrackedRobot> robots) {
  if (known_ && now - seen_ > (hidden_.active() ? params_.hidden_memory : params_.ball_memory)) {
    known_ = false;
    held_ = false;
    hidden_.clear();
    study_.reset();
  }
  if (known_ && now - seen_ > two_frames) hide(now, robots);
  std::erase_if(candidates_, [now](const Candidate& candidate) { return candidate.stale(now); });
}

void BallTrack::see(std::span<const world::DetectedBall> balls, world::Time time, int camera,
                    std::span<const world::TrackedRobot> robots) {
  match_.reset();
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

std::optional<world::RobotId> BallTrack::robot_below(world::Time time,
                                                     std::span<const world::TrackedRobot> robots) const {
  const Vector2d ball = study_->filter_at(time).position().head<2>();
  const auto is_below = [&](const world::TrackedRobot& robot) {
    return (robot.position - ball).norm() < field_.robot_radius;
  };
  const auto below = std::ranges::find_if(robots, is_below);
  return below == robots.end() ? std::nullopt : std::optional(below->id);
}

// A ball that flies meets robots that are higher than it is, and the goal and the walls behind the lines.
BallTrack::Strike BallTrack::struck_in_the_air(world::Time time,
                                               std::span<const world::TrackedRobot> robots) const {
  const Vector3d from = study_->filter_at(seen_).position();
  const Vector3d to = study_->filter_at(time).position();
  const double height = std::min(from.z(), to.z());
  Strike strike;
  if (height < least_flight) return strike;
  strike.possible = world::distance_outside_lines(field_, to.head<2>()) > -wall_reach;
  if (height > robot_height + params_.near_gap) return strike;
  const world::Segment path{from.head<2>(), to.head<2>()};
  double nearest = params_.near_gap;
  for (const world::TrackedRobot& robot : robots) {
    const double gap = hull_gap(field_, robot, path);
    if (gap >= nearest) continue;
    nearest = gap;
    strike = {true, robot.id};
  }
  return strike;
}

bool BallTrack::follow(std::span<const world::DetectedBall> balls, world::Time time, int camera,
                       std::span<const world::TrackedRobot> robots) {
  const bool flies = study_ && study_->airborne() > 0.5;
  const bool out_of_sight = !flies && time - seen_ > two_frames;
  const auto hidden = out_of_sight ? concealed(balls, time, robots) : std::nullopt;
  const world::Camera* const eye = params_.ball_in_space ? camera_of(camera) : nullptr;

  // A ball that was hidden lies where it is believed to be, however long ago that was seen.
  BallFilter ahead = filter_;
  double dt = world::seconds(time - seen_);
  if (hidden) {
    ahead.start(hidden->position, hidden->velocity, start_sigma);
    dt = std::min(dt, world::seconds(two_frames));
  }
  const Vector2d from = ahead.position();
  const world::Segment path{from, from + ahead.velocity() * dt};
  const double near =
      ahead.velocity().norm() * dt + field_.robot_radius + field_.ball_radius + params_.near_gap;
  const bool near_robot = std::ranges::any_of(robots, [&](const world::TrackedRobot& robot) {
    // Most are farther than the whole path is long.
    return (robot.position - from).squaredNorm() < near * near * (1 + 1e-9) &&
           hull_gap(field_, robot, path) < params_.near_gap;
  });
  if (!hidden) ahead.predict(dt, near_robot);

  const Vector2d expected =
      flies && eye ? study_->filter_at(time).seen_from(eye->position) : ahead.position();
  const world::DetectedBall* nearest = nullptr;
  double nearest_distance = 0;
  for (const world::DetectedBall& ball : balls) {
    const double distance = (ball.position - expected).norm();
    if (nearest && distance >= nearest_distance) continue;
    nearest = &ball;
    nearest_distance = distance;
  }
  if (!nearest) return false;

  Vector2d measured = nearest->position;
  if (eye && !flies) measured = whole(measured, *eye, robots);
  const bool moved = measured != nearest->position;
  ahead.doubt(moved ? partly_sigma : 0);
  if (moved) nearest_distance = (measured - expected).norm();
  const KickStudy::Surroundings around{near_robot, flies ? robot_below(time, robots) : std::nullopt};
  const bool explained = study_ && eye && study_->explains(measured, time, eye->position, around);
  const bool expected_by_some = ahead.best_nis(measured) < params_.nis_gate;
  const bool agrees = expected_by_some && nearest_distance < CameraPreference::agreement;
  if (!flies && !moved && nearest_distance < disagreement) {
    match_ = Match{measured, ahead.velocity(), ahead.velocity_variance()};
  }
  if (!study_ && !agrees && eye) {
    if (const auto place = lifted(measured, time, *eye)) {
      study_.emplace(geometry_, *place, time, params_.ball_sigma);
      return true;
    }
  }
  if (!agrees && nearest_distance < disagreement && camera_.distrusts(camera, time)) {
    if (explained) study(measured, time, eye, around);
    return true;
  }
  if (hidden && nearest_distance < held_tolerance) {
    ahead.start(measured, hidden->velocity, start_sigma);
    filter_ = ahead;
    seen_ = time;
    camera_.used(camera, time);
    remember_hold(robots);
    if (near_robot && eye) {  // it comes into view by itself, or because it was kicked just now
      const Vector2d place = hidden->position - hidden->velocity * world::seconds(one_frame);
      const KickPoint kick{time - one_frame, time + one_frame, place, hidden->velocity, hidden_kick_sigma};
      study_.emplace(geometry_, kick, params_.ball_sigma);
      study(measured, time, eye, around);
    }
    return true;
  }
  const double travelled = (measured - from).norm();
  if (!explained && travelled > params_.max_ball_speed * dt + least_gate) return false;
  bool kicked = false;
  const Strike strike = flies && eye && !explained ? struck_in_the_air(time, robots) : Strike{};
  if (strike.possible) {
    ahead.start(measured, (measured - from) / std::max(dt, half_frame), params_.kick_sigma);
  } else if (expected_by_some) {
    ahead.update(measured);
  } else if (explained) {
    ahead.start(measured, filter_.velocity(), params_.kick_sigma);
  } else if (dt > 0 && could_be_struck(from, measured, robots)) {
    ahead.start(measured, (measured - from) / std::max(dt, half_frame), params_.kick_sigma);
    kicked = true;
  } else if (nearest_distance < params_.ball_gate) {
    ahead.update(measured);
  } else {
    return false;
  }
  if (strike.possible) study_ = KickStudy(*study_, time, from, strike.by);
  if (kicked) {
    study_.reset();
    const bool by_robot = std::ranges::any_of(robots, [&](const world::TrackedRobot& robot) {
      return hull_gap(field_, robot, {from, from}) < params_.near_gap;
    });
    if (by_robot && eye) {
      KickPoint kick;
      kick.earliest = hidden ? time - out_of_hiding : seen_ - before_seen;
      kick.latest = time + (hidden ? world::Duration{} : after_seen);
      kick.place = from;
      kick.carried = hidden ? hidden->velocity : filter_.velocity();
      kick.sigma = hidden ? hidden_kick_sigma : kick_place_sigma;
      study_.emplace(geometry_, kick, params_.ball_sigma);
    }
  }
  filter_ = ahead;
  seen_ = time;
  camera_.used(camera, time);
  measured_ = measured;
  measured_by_ = camera;
  beside_robot_ = near_robot;
  study(measured, time, eye, around);
  remember_hold(robots);
  if (study_ && held_ && study_->sightings() >= kicked_away) study_.reset();
  return true;
}

Vector2d BallTrack::whole(const Vector2d& seen, const world::Camera& camera,
                          std::span<const world::TrackedRobot> robots) const {
  optics::PartlyHidden ball(field_, camera, seen);
  for (const world::TrackedRobot& robot : robots) ball.beside(robot.position, robot.orientation);
  return ball.whole().position;
}

// Where a ball is that nobody sees because a robot has it or hides it; nothing when it should be in view.
// Of several places the one near which a ball has come into view.
std::optional<BallFilter::Motion> BallTrack::concealed(std::span<const world::DetectedBall> balls,
                                                       world::Time now,
                                                       std::span<const world::TrackedRobot> robots) const {
  if (!hidden_.active()) return std::nullopt;
  for (const world::DetectedBall& ball : balls) {
    if (const auto place = hidden_.nearest(ball.position, held_tolerance, now, robots)) return place;
  }
  return hidden_.best(now, robots);
}

// Two cameras show one ball so far apart, and so much in the direction of height, that it cannot have rolled:
// p + z a = g for both, with a = (g - c) / H of each camera (air_filter.h).
std::optional<Vector3d> BallTrack::lifted(const Vector2d& seen, world::Time time,
                                          const world::Camera& camera) const {
  const world::Camera* const other = camera_of(measured_by_);
  if (!other || other == &camera || time - seen_ > one_frame) return std::nullopt;
  const auto slant = [](const Vector2d& place, const world::Camera& c) -> Vector2d {
    return (place - c.position.head<2>()) / c.position.z();
  };
  const Vector2d apart = seen - measured_;
  const Vector2d per_height = slant(seen, camera) - slant(measured_, *other);
  const double height = apart.dot(per_height) / per_height.squaredNorm();
  const double reach = params_.max_ball_speed * world::seconds(time - seen_) + least_gate;
  const double beside = (apart - height * per_height).norm();
  if (!(height > 0) || height > most_height || apart.norm() < reach || beside > apart.norm() / 3) {
    return std::nullopt;
  }
  const Vector2d place = seen - height * slant(seen, camera);
  return Vector3d(place.x(), place.y(), height);
}

void BallTrack::study(const Vector2d& measured, world::Time time, const world::Camera* camera,
                      const KickStudy::Surroundings& around) {
  if (!study_ || !camera) return;
  study_->see(measured, time, camera->position, around);
  if (study_->over()) {
    study_.reset();
  } else if (study_->landed()) {
    const AirFilter landed = study_->filter_at(time);
    filter_.start(landed.position().head<2>(), landed.velocity().head<2>(), landing_sigma);
    study_.reset();
  }
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
  held_ = false;
  hidden_.clear();
  study_.reset();
  candidates_.clear();
}

void BallTrack::remember_hold(std::span<const world::TrackedRobot> robots) {
  held_ = false;
  hidden_.clear();
  // Where a ball above the robots is seen on the ground it only seems to be at a dribbler.
  if (study_ && study_->airborne() > 0.5 && study_->filter_at(seen_).position().z() > robot_height) return;
  const Vector2d ball = filter_.position();
  for (const world::TrackedRobot& robot : robots) {
    held_ = held_ || in_dribbler_zone(robot, ball);
  }
}

const world::Camera* BallTrack::camera_of(int id) const {
  const auto found = std::ranges::find(geometry_.cameras, id, &world::Camera::id);
  return found == geometry_.cameras.end() || !(found->position.z() > robot_height) ? nullptr : &*found;
}

// A ball that nobody sees has rolled into a robot, or lies or rolls where one hides it, or was at a dribbler:
// then robots are why. Else it only was not reported.
void BallTrack::hide(world::Time now, std::span<const world::TrackedRobot> robots) {
  if (hidden_.active()) {
    hidden_.advance(now, robots);
    return;
  }
  BallFilter::Motion lost{filter_.position(), filter_.velocity()};
  Vector2d there = filter_.foretell(world::seconds(now - seen_)).position;
  world::Time lost_at = seen_;
  const bool flew = study_ && study_->airborne() > 0.5;
  if (flew) {
    const AirFilter air = study_->filter_at(now);
    if (air.position().z() > robot_height) return;
    lost_at = now - one_frame;
    const AirFilter before = study_->filter_at(lost_at);
    lost = {before.position().head<2>(), before.velocity().head<2>()};
    there = air.position().head<2>();
  }
  const double contact = field_.robot_radius + field_.ball_radius - pressed;
  const bool met = std::ranges::any_of(robots, [&](const world::TrackedRobot& robot) {
    return world::distance({lost.position, there}, robot.position) < contact;
  });
  if (!met && (flew || (!held_ && !hidden_.hider(there, robots)))) return;
  study_.reset();
  hidden_.start(lost, lost_at, robots);
  hidden_.advance(now, robots);
}

world::TrackedBall BallTrack::foretell(world::Time time, std::span<const world::TrackedRobot> robots) const {
  world::TrackedBall ball;
  ball.unseen = std::max(world::Duration{}, time - seen_);
  if (study_) {
    ball.airborne = study_->airborne();
    ball.may_fly = study_->in_doubt();
  }
  if (ball.airborne > 0.5) {
    const AirFilter air = study_->filter_at(time);
    if (!air.rolls()) {
      ball.position = air.position();
      ball.velocity = air.velocity();
      ball.sigma = air.sigma();
      ball.flight = study_->flight_at(time);
      return ball;
    }
    ball.airborne = 0;
  }
  const bool hidden = ball.unseen > two_frames && hidden_.active();
  const BallFilter::Motion state =
      hidden ? hidden_.best(time, robots) : filter_.foretell(world::seconds(ball.unseen));
  ball.position.head<2>() = state.position;
  ball.velocity.head<2>() = state.velocity;
  const double unsure =
      hidden ? hidden_sigma + hidden_drift * world::seconds(ball.unseen) : (beside_robot_ ? beside_sigma : 0);
  ball.sigma = std::hypot(state.sigma, unsure);
  if (hidden) ball.outside = hidden_.outside(time, robots);
  return ball;
}

}  // namespace tracker
