#include "autoref/tracker/tracker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace tracker {
namespace {

using namespace std::chrono_literals;

constexpr world::Duration max_step = 1s;  // a longer step is a jump of the clock; ours
constexpr int batches_of_a_restart = 3;   // one late packet is not a restart; ours
constexpr double far_away = 50.0;         // [m] no field is so large; ours
constexpr std::size_t max_cameras = 64;   // ids beyond are nonsense; the league had 4 to 8
constexpr std::size_t max_balls = 64;     // of one image; ours
constexpr std::int64_t max_time = 3'000'000'000'000'000'000;  // [ns] differences must not overflow

constexpr world::Duration same_frame = 17ms;      // two cameras' images so near show one instant; ours
constexpr world::Duration compare_every = 100ms;  // offsets drift by millimetres a minute; ours
constexpr double one_thing = 0.15;  // [m] farther apart, two cameras do not show one thing; ours

constexpr int numbers = world::max_robot_number + 1;

std::size_t index_of(world::Team team, int number) {
  return static_cast<std::size_t>((team == world::Team::Yellow ? 0 : numbers) + number);
}

bool is_plausible(const world::Vector2d& position) {
  return std::abs(position.x()) < far_away && std::abs(position.y()) < far_away;  // false for NaN
}

bool has_usable_time(const world::Detection& detection) {
  const std::int64_t t = detection.t_capture.time_since_epoch().count();
  return -max_time < t && t < max_time;
}

}  // namespace

Tracker::Tracker(world::Geometry geometry, Params params)
    : params_(params), ball_(geometry, params), bias_(params) {
  robot_sightings_.resize(2 * numbers);
  robots_.reserve(2 * numbers);
  for (const world::Team team : world::both_teams) {
    for (int number = 0; number < numbers; ++number) {
      robots_.emplace_back(world::RobotId{team, static_cast<std::uint8_t>(number)}, params);
    }
  }
}

void Tracker::reset() {
  for (RobotTrack& robot : robots_) robot.reset();
  ball_.reset();
  bias_.reset();
  std::ranges::fill(robot_sightings_, std::nullopt);
  ball_sighting_.reset();
  cameras_.clear();
  started_ = false;
  batches_from_the_past_ = 0;
}

void Tracker::choose(std::span<const world::Detection> detections) {
  images_.clear();
  for (const world::Detection& detection : detections) {
    if (has_usable_time(detection)) images_.push_back(&detection);
  }
  if (images_.empty()) return;
  // Of equals the one that arrived first: they lie in one array. (std::stable_sort would allocate.)
  const auto earlier = [](const world::Detection* a, const world::Detection* b) {
    return std::tuple(a->t_capture, a->camera, a) < std::tuple(b->t_capture, b->camera, b);
  };
  std::ranges::sort(images_, earlier);
  if (!started_) return;

  // Images far from the present are mistakes as long as others of the batch are near.
  const auto is_far = [this](const world::Detection* image) {
    return image->t_capture > frame_.time + max_step || image->t_capture < frame_.time - max_step;
  };
  if (!std::ranges::all_of(images_, is_far)) {
    std::erase_if(images_, is_far);
    batches_from_the_past_ = 0;
    return;
  }
  const world::Time newest = images_.back()->t_capture;
  if (newest > frame_.time) {
    std::erase_if(images_, [this](const world::Detection* image) { return image->t_capture < frame_.time; });
    batches_from_the_past_ = 0;
    return;
  }
  if (++batches_from_the_past_ < batches_of_a_restart) {
    images_.clear();
    return;
  }
  reset();
  ++restarts_;
}

bool Tracker::repeats(const world::Detection& detection) {
  for (CameraClock& clock : cameras_) {
    if (clock.camera != detection.camera) continue;
    if (detection.t_capture <= clock.last) return true;
    clock.last = detection.t_capture;
    return false;
  }
  if (cameras_.size() >= max_cameras) return true;
  cameras_.push_back({detection.camera, detection.t_capture});
  return false;
}

const world::TrackedFrame* Tracker::update(std::span<const world::Detection> detections,
                                           std::span<const CommandedVelocity> commands) {
  if (!commands.empty() || commanded_) {
    for (RobotTrack& robot : robots_) robot.command(std::nullopt);
    for (const CommandedVelocity& command : commands) {
      if (command.id.number > world::max_robot_number || !command.velocity.allFinite()) continue;
      robots_[index_of(command.id.team, command.id.number)].command(command.velocity);
    }
    commanded_ = !commands.empty();
  }
  choose(detections);
  if (images_.empty()) return nullptr;
  const world::Time newest = images_.back()->t_capture;
  const world::Time before = started_ ? frame_.time : images_.front()->t_capture - 1ns;
  comparing_ = newest >= compared_ + compare_every || newest < compared_;
  if (comparing_) compared_ = newest;
  for (const world::Detection* image : images_) {
    if (!repeats(*image)) take_in(*image);
  }
  if (started_ && newest <= frame_.time) return nullptr;
  started_ = true;
  publish(newest, before);
  return &frame_;
}

void Tracker::take_in(const world::Detection& detection) {
  const world::Time time = detection.t_capture;
  const Vector2d bias = bias_.applied(detection.camera);

  // The nearest to expectation of those that claim one id.
  std::array<const world::DetectedRobot*, 2 * numbers> claims{};
  std::uint32_t claimed = 0;
  for (const world::DetectedRobot& robot : detection.robots) {
    if (!robot.number || *robot.number > world::max_robot_number || !is_plausible(robot.position)) continue;
    if (robot.team != world::Team::Yellow && robot.team != world::Team::Blue) continue;
    const std::size_t index = index_of(robot.team, *robot.number);
    const RobotTrack& track = robots_[index];
    const world::DetectedRobot*& claim = claims[index];
    if (claim &&
        track.surprise(robot.position - bias, time) >= track.surprise(claim->position - bias, time)) {
      continue;
    }
    claim = &robot;
    claimed |= 1u << index;
  }
  for (std::size_t index = 0; claimed != 0; ++index, claimed >>= 1) {
    if ((claimed & 1u) == 0) continue;
    const world::DetectedRobot& robot = *claims[index];
    const bool has_heading = robot.orientation && std::abs(*robot.orientation) < 1e6;  // false for NaN
    RobotTrack& track = robots_[index];
    track.see(robot.position - bias, has_heading ? robot.orientation : std::nullopt, time, detection.camera);
    if (!track.known()) continue;
    compare(robot_sightings_[index], {detection.camera, time, robot.position}, track.velocity(),
            track.velocity_variance(), params_.robot_sigma);
  }

  see_balls(detection, bias);

  // In an order that knows nothing of colours and directions, so that they do not matter.
  const auto size = [](const Comparison& c) { return c.difference.squaredNorm(); };
  std::ranges::sort(comparisons_, {}, size);
  for (const Comparison& c : comparisons_) bias_.compare(c.camera, c.other, c.difference, c.variance, time);
  comparisons_.clear();
}

void Tracker::see_balls(const world::Detection& detection, const Vector2d& bias) {
  const world::Time time = detection.t_capture;
  balls_.clear();
  for (const world::DetectedBall& ball : detection.balls) {
    if (!is_plausible(ball.position) || balls_.size() >= max_balls) continue;
    balls_.push_back(ball);
    balls_.back().position -= bias;
  }
  if (balls_.empty()) return;
  foretell_robots(time, foretold_);
  ball_.see(balls_, time, detection.camera, foretold_);
  if (const auto& match = ball_.match()) {
    compare(ball_sighting_, {detection.camera, time, match->position + bias}, match->velocity,
            match->velocity_variance, params_.ball_sigma);
  }
}

void Tracker::compare(std::optional<Sighting>& last, const Sighting& now, const Vector2d& velocity,
                      double velocity_variance, double sigma) {
  const std::optional<Sighting> before = std::exchange(last, now);
  if (!comparing_ || !before || before->camera == now.camera) return;
  const world::Duration apart = now.time - before->time;
  if (apart < world::Duration{} || apart > same_frame) return;
  const double dt = world::seconds(apart);
  const Vector2d difference = now.position - before->position - velocity * dt;
  if (difference.norm() > one_thing) return;
  comparisons_.push_back(
      {now.camera, before->camera, difference, 2 * sigma * sigma + velocity_variance * dt * dt});
}

void Tracker::foretell_robots(world::Time time, std::vector<world::TrackedRobot>& out) const {
  out.clear();
  for (const RobotTrack& robot : robots_) {
    if (!robot.known()) continue;
    robot.foretell(time, out.emplace_back());
  }
}

void Tracker::publish(world::Time time, world::Time before) {
  for (RobotTrack& robot : robots_) robot.age(time);
  bias_.advance();

  frame_.time = time;
  frame_.touches.clear();
  foretell_robots(time, frame_.robots);
  ball_.age(time, frame_.robots);
  frame_.ball.reset();
  if (ball_.known()) {
    frame_.ball = ball_.foretell(time, frame_.robots);
    frame_.ball->observed = ball_.seen_since(before);
    if (frame_.ball->observed) frame_.ball->unseen = {};
  }
  for (world::TrackedRobot& robot : frame_.robots) {
    robot.observed = robots_[index_of(robot.id.team, robot.id.number)].seen_since(before);
    robot.ball_in_reach = frame_.ball && in_dribbler_zone(robot, frame_.ball->position.head<2>());
  }
}

}  // namespace tracker
