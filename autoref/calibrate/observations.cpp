#include "autoref/calibrate/observations.h"

#include <algorithm>
#include <cmath>

#include "autoref/calibrate/statistics.h"
#include "sim/world/time.h"

namespace calibrate {
namespace {

using world::Vector2d;

constexpr double edge = 0.15;  // [m] of a camera's view: a robot's radius and a little

// A number is a robot's when it was once seen for about a second without much
// interruption; misreadings are not.
constexpr std::size_t images_of_a_robot = 50;
constexpr double least_density = 0.2;

// Images that a frame counter skipped, whether it counts by one or over all cameras.
std::int64_t skipped(const std::vector<std::uint32_t>& numbers) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i] > numbers[i - 1]) steps.push_back(numbers[i] - numbers[i - 1]);
  }
  if (steps.empty()) return 0;
  std::vector<double> copy = steps;
  const double usual = median(copy);
  std::int64_t lost = 0;
  for (const double step : steps) {
    const auto missing = static_cast<std::int64_t>(std::lround(step / usual)) - 1;
    if (missing > 0 && missing < 1000) lost += missing;  // more is a restart of the counter
  }
  return lost;
}

bool is_robot(const std::vector<Track>& tracks) {
  return std::ranges::any_of(tracks, [](const Track& track) {
    const std::size_t images = track.sightings.back().image - track.sightings.front().image + 1;
    return track.sightings.size() >= images_of_a_robot &&
           static_cast<double>(track.sightings.size()) >= least_density * static_cast<double>(images);
  });
}

void append(std::vector<Track>& to, std::vector<Track> from) {
  std::ranges::move(from, std::back_inserter(to));
}

}  // namespace

double CameraImages::inside(const Vector2d& point) const {
  return std::min((point - low).minCoeff(), (high - point).minCoeff()) - edge;
}

std::optional<Vector2d> Observations::position_of(const Robot& robot, double time) {
  const auto after = std::ranges::lower_bound(robot.path, time, {}, &Fix::time);
  const Fix* best = after != robot.path.end() ? &*after : nullptr;
  if (after != robot.path.begin()) {
    const Fix& before = *(after - 1);
    if (best == nullptr || time - before.time < best->time - time) best = &before;
  }
  if (best == nullptr || std::abs(best->time - time) > 0.1) return std::nullopt;
  return best->position;
}

bool Observations::robot_near(const Vector2d& point, double time, double distance) const {
  return std::ranges::any_of(robots, [&](const Robot& robot) {
    const auto position = position_of(robot, time);
    return position && (*position - point).norm() < distance;
  });
}

void Observer::add(const world::Detection& image) {
  kept_ += 1 + image.balls.size() + image.robots.size();
  full_ = full_ || kept_ > most_;
  if (full_) return;
  const auto [entry, is_new] = index_.try_emplace(image.camera, eyes_.size());
  if (is_new) {
    eyes_.emplace_back(entry->second);
    eyes_.back().images.id = image.camera;
  }
  Eye& eye = eyes_[entry->second];
  const double time = world::seconds(image.t_capture);
  if (!eye.images.times.empty() && time <= eye.images.times.back()) return;  // recorded twice
  const auto number = static_cast<std::uint32_t>(eye.images.times.size());
  eye.images.times.push_back(time);
  eye.images.delays.push_back(world::seconds(image.t_sent - image.t_capture));
  eye.frame_numbers.push_back(image.frame_number);

  std::vector<Sighting> balls;
  for (const world::DetectedBall& ball : image.balls) {
    Sighting& s = balls.emplace_back();
    s.time = time;
    s.position = ball.position;
    s.image = number;
    s.area = ball.area;
  }
  eye.balls.add(balls);

  std::map<world::RobotId, std::vector<Sighting>> robots;
  for (const world::DetectedRobot& robot : image.robots) {
    if (!robot.number) {
      eye.unread.push_back({entry->second, number, robot.team, false, robot.position});
      continue;
    }
    Sighting& s = robots[{robot.team, *robot.number}].emplace_back();
    s.time = time;
    s.position = robot.position;
    s.image = number;
    if (robot.orientation) s.orientation = *robot.orientation;
  }
  for (const auto& [id, sightings] : robots) {
    eye.robots.try_emplace(id, entry->second, robot_gate).first->second.add(sightings);
  }
}

Observations Observer::finish() {
  Observations seen;
  std::vector<Track> balls;
  std::map<world::RobotId, std::vector<Track>> robots;
  for (Eye& eye : eyes_) {
    eye.images.frames_lost = skipped(eye.frame_numbers);
    append(balls, eye.balls.finish());
    for (auto& [id, linker] : eye.robots) append(robots[id], linker.finish());
    std::ranges::copy(eye.unread, std::back_inserter(seen.strays));
    seen.cameras.push_back(std::move(eye.images));
  }
  eyes_.clear();
  index_.clear();

  Identity ball = identify(std::move(balls), 3);
  seen.ball = std::move(ball.object);
  seen.false_balls = std::move(ball.impostors);

  const auto stray = [&](world::Team team, const std::vector<Track>& tracks) {
    for (const Track& track : tracks) {
      for (const Sighting& s : track.sightings) {
        seen.strays.push_back({track.camera, s.image, team, true, s.position});
      }
    }
  };
  for (auto& [id, tracks] : robots) {
    if (!is_robot(tracks)) {
      stray(id.team, tracks);
      continue;
    }
    Identity identity = identify(std::move(tracks), 10);
    stray(id.team, identity.impostors);
    stray(id.team, identity.unclear);
    Robot& robot = seen.robots.emplace_back();
    robot.id = id;
    robot.tracks = std::move(identity.object);
    for (const Track& track : robot.tracks) {
      for (const Sighting& s : track.sightings) robot.path.push_back({s.time, s.position});
    }
    std::ranges::sort(robot.path, {}, &Fix::time);
  }
  std::ranges::stable_sort(seen.strays, [](const Stray& a, const Stray& b) {
    return a.camera != b.camera ? a.camera < b.camera : a.image < b.image;
  });

  std::vector<bool> begun(seen.cameras.size());
  const auto widen = [&](const Track& track) {
    CameraImages& camera = seen.cameras[track.camera];
    if (!begun[track.camera]) camera.low = camera.high = track.sightings.front().position;
    begun[track.camera] = true;
    for (const Sighting& s : track.sightings) {
      camera.low = camera.low.cwiseMin(s.position);
      camera.high = camera.high.cwiseMax(s.position);
    }
  };
  for (const Track& track : seen.ball) widen(track);
  for (const Robot& robot : seen.robots) {
    for (const Track& track : robot.tracks) widen(track);
  }
  return seen;
}

}  // namespace calibrate
