#include "autoref/touch/views.h"

#include <algorithm>
#include <cmath>

namespace touch {
namespace {

using namespace std::chrono_literals;

// a hidden ball is judged by both its courses; longer is another story
constexpr world::Duration longest_gap = 400ms;
constexpr double fastest = 12;       // [m/s] of a ball (football.md 4.2); faster is a teleport
constexpr double slack = 0.1;        // [m] of it, for noise and what two robots do within an image
constexpr double same_ball = 0.15;   // [m] of the tracked one: what 8 m/s do in a frame
constexpr double near_robot = 0.40;  // [m] centre to centre: 0.1 m of gap, and 8 m/s for a frame
constexpr double clear_gap = 0.1;  // [m] nearer, the robot may hide a part of it, or touch it between images
constexpr double front = 0.073;    // [m] centre to front plate (world::RobotSpecs)

}  // namespace

double hull_gap(const Vector2d& p, const world::Field& field) {
  const double half_width = std::sqrt(field.robot_radius * field.robot_radius - front * front);
  if (p.x() > 0 && std::abs(p.y()) * front < p.x() * half_width) return p.x() - front - field.ball_radius;
  return p.norm() - field.robot_radius - field.ball_radius;
}

void View::finish(const world::Field& field) {
  Sighting& now = ring_[static_cast<std::size_t>(newest_)];
  now.gap = 1;
  for (std::size_t n = 0; n < now.robot_count; ++n) {
    const Sighting::Robot& robot = now.robots[n];
    const double gap = hull_gap(world::rotated(now.ball - robot.position, -robot.orientation), field);
    if (gap >= now.gap) continue;
    now.gap = gap;
    now.nearest = robot.slot;
  }
  clear = now.gap > clear_gap ? clear + 1 : 0;
  if (clear < Course::samples) return;
  Course fitted;
  double mean = 0;
  for (int n = 0; n < Course::samples; ++n) {
    mean += world::seconds((*this)[n].time - now.time) / Course::samples;
    fitted.middle += (*this)[n].ball / Course::samples;
  }
  for (int n = 0; n < Course::samples; ++n) {
    const double t = world::seconds((*this)[n].time - now.time) - mean;
    fitted.spread += t * t;
    fitted.velocity += t * (*this)[n].ball;
  }
  fitted.velocity /= fitted.spread;
  fitted.time = now.time + world::from_seconds(mean);
  course = fitted;
}

Sighting& View::push(world::Time time, const Vector2d& ball) {
  const Sighting& last = ring_[static_cast<std::size_t>(newest_)];
  const world::Duration step = time - last.time;
  const bool jumped = (ball - last.ball).norm() > fastest * world::seconds(step) + slack;
  if (followed > 0 && (jumped || step > longest_gap)) {
    followed = clear = 0;
    course.reset();
  }
  newest_ = (newest_ + memory - 1) % memory;
  ++followed;
  Sighting& sighting = ring_[static_cast<std::size_t>(newest_)];
  sighting.time = time;
  sighting.ball = ball;
  sighting.robot_count = 0;
  return sighting;
}

void Views::reset() { count_ = 0; }

View* Views::view(int camera) {
  for (std::size_t n = 0; n < count_; ++n) {
    if (views_[n].camera == camera) return &views_[n];
  }
  if (count_ == most) return nullptr;
  views_[count_] = View{};
  views_[count_].camera = camera;
  return &views_[count_++];
}

View* Views::add(const world::TrackedFrame& frame, const world::Detection& image) {
  const Vector2d here = frame.ball->position.head<2>();
  const Vector2d velocity = frame.ball->velocity.head<2>();
  const Vector2d expected = here + velocity * world::seconds(image.t_capture - frame.time);
  const world::DetectedBall* ball = nullptr;
  double least = same_ball;
  for (const world::DetectedBall& seen : image.balls) {
    const double distance = (seen.position - expected).norm();
    if (!(distance < least)) continue;
    ball = &seen;
    least = distance;
  }
  if (!ball) return nullptr;
  View* view = this->view(image.camera);
  if (!view || (view->followed > 0 && image.t_capture <= (*view)[0].time)) return nullptr;
  Sighting& sighting = view->push(image.t_capture, ball->position);
  for (const world::DetectedRobot& robot : image.robots) {
    if (!robot.number || *robot.number > world::max_robot_number || !robot.orientation) continue;
    if (!((robot.position - ball->position).squaredNorm() < near_robot * near_robot)) continue;
    if (sighting.robot_count == Sighting::most_robots) break;
    sighting.robots[sighting.robot_count++] = {slot({robot.team, *robot.number}), robot.position,
                                               *robot.orientation};
  }
  // Out of this camera's sight, or missed in this image: where the tracker believes it.
  const double ago = world::seconds(image.t_capture - frame.time);
  for (const world::TrackedRobot& robot : frame.robots) {
    if (sighting.robot_count == Sighting::most_robots || robot.id.number > world::max_robot_number) break;
    const Vector2d there = robot.position + robot.velocity * ago;
    if (!((there - ball->position).squaredNorm() < near_robot * near_robot) || sighting.find(slot(robot.id)))
      continue;
    sighting.robots[sighting.robot_count++] = {slot(robot.id), there, robot.orientation};
  }
  return view;
}

View* Views::add(const world::TrackedFrame& frame) {
  if (!frame.ball->observed) return nullptr;
  View* view = this->view(-1);
  if (!view || (view->followed > 0 && frame.time <= (*view)[0].time)) return nullptr;
  Sighting& sighting = view->push(frame.time, frame.ball->position.head<2>());
  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.id.number > world::max_robot_number) continue;
    if ((robot.position - sighting.ball).squaredNorm() > near_robot * near_robot) continue;
    if (sighting.robot_count == Sighting::most_robots) break;
    sighting.robots[sighting.robot_count++] = {slot(robot.id), robot.position, robot.orientation};
  }
  return view;
}

const View* Views::add(const world::TrackedFrame& frame, std::span<const world::Detection> images,
                       const world::Field& field) {
  if (!frame.ball) return nullptr;
  const View* best = nullptr;
  const auto consider = [&](View* view) {
    if (!view) return;
    view->finish(field);
    if (!view->full()) return;
    learn(*view);
    if (!best || view->followed > best->followed) best = view;
  };
  for (const world::Detection& image : images) consider(add(frame, image));
  View* own = add(frame);
  if (own) own->finish(field);
  if (!best && own && own->full()) best = own;
  return best;
}

void Views::learn(const View& view) {
  if (view[0].robot_count + view[1].robot_count + view[2].robot_count > 0) return;
  // The middle of three off the line between the others, across the course so that friction does not show.
  const Vector2d course = view[0].ball - view[2].ball;
  const double length = course.norm();
  if (length < 0.005) return;
  const Vector2d off = view[1].ball - (view[0].ball + view[2].ball) / 2;
  const double across = (off.x() * course.y() - off.y() * course.x()) / length;
  const double variance =
      std::min(across * across / 1.5, 9 * noise_ * noise_);  // bounded: a wall, a false ball
  constexpr double rate = 1.0 / 300;                         // five seconds
  noise_ = std::sqrt((1 - rate) * noise_ * noise_ + rate * variance);
  noise_ = std::clamp(noise_, 0.0003, 0.005);
}

}  // namespace touch
