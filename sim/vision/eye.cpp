#include "sim/vision/eye.h"

#include <algorithm>
#include <cmath>

#include "sim/vision/optics.h"

namespace vision {
namespace {

using world::Vector2d;
using world::Vector3d;

Vector2d drawn_bias(double sigma, world::RandomStream stream) {
  const double x = stream.gaussian(), y = stream.gaussian();
  return {sigma * x, sigma * y};
}

Vector2d as_float(const Vector2d& value) { return {world::as_float(value.x()), world::as_float(value.y())}; }

// A blob has at least one pixel.
std::uint32_t whole_area(double area) {
  constexpr double largest = 1e9;
  return static_cast<std::uint32_t>(std::lround(std::clamp(area, 1.0, largest)));
}

void report_blob(double area, world::DetectedBall& out) {
  out.area = whole_area(area);
  out.confidence = world::as_float(ball_confidence(out.area));
}

const double sent_robot_confidence = world::as_float(robot_confidence);

// What is drawn about a robot's pattern.
enum Purpose : unsigned { Unread, Misread, Instead };

}  // namespace

Eye::Eye(const world::Geometry& geometry, const world::Camera& camera, const Area& area, const Params& params,
         const world::RobotSpecs& body, std::uint64_t seed, const std::string& name)
    : camera_(camera),
      area_(area),
      params_(params),
      ball_radius_(geometry.field.ball_radius),
      robot_height_(body.height),
      bias_(drawn_bias(params.bias_sigma, {seed, name + " bias"})),
      regions_(params, inside_walls(area, geometry.field), {seed, name + " regions"}),
      occlusion_(body, ball_radius_),
      bursts_({seed, name + " bursts"}),
      false_balls_(params, inside_walls(area, geometry.field), ball_radius_, body,
                   {seed, name + " false balls"}),
      noise_(seed, name + " noise"),
      loss_(seed, name + " loss"),
      flicker_(seed, name + " flicker"),
      area_noise_(seed, name + " area"),
      ids_(seed, name + " ids"),
      false_ball_noise_(seed, name + " false ball noise") {}

void Eye::see(const truth::Ball& ball, std::span<const truth::Robot> robots, world::Detection& out) {
  const std::uint32_t image = images_++;
  out.camera = camera_.id;
  out.frame_number = image;
  out.balls.clear();
  out.robots.clear();
  see_ball(image, ball, robots, out);
  see_robots(image, robots, out);
  see_false_balls(image, out);
  // SSL-Vision's order: nothing tells the true ball from the others.
  if (out.balls.size() > 1) {
    std::sort(out.balls.begin(), out.balls.end(), [](const auto& a, const auto& b) {
      return a.confidence != b.confidence ? a.confidence > b.confidence : a.pixel.x() < b.pixel.x();
    });
  }
}

// The stream of the noise and the one of the single losses are drawn from for every object in view, whether
// it is then reported or not: so no probability shifts them.
void Eye::see_ball(std::uint32_t image, const truth::Ball& ball, std::span<const truth::Robot> robots,
                   world::Detection& out) {
  bool lost = bursts_.lost(params_.ball_burst_start, params_.ball_burst_length, image, ball_object);
  // The resting ball's height is the radius by which the league's calibration counts heights from zero.
  const Vector2d on_ground = projected_to_ground(camera_.position, ball.position, ball_radius_);
  if (!area_.contains(on_ground)) return;
  const double dx = params_.ball_sigma * noise_.gaussian();
  const double dy = params_.ball_sigma * noise_.gaussian();
  lost |= loss_.uniform() < params_.ball_missing;
  lost |= regions_.contains(on_ground) && flicker_.uniform(image, ball_object) < params_.region_missing;
  if (lost) return;

  double area = ball_area(camera_, ball.position, ball_radius_);
  Vector2d seen = on_ground;
  if (params_.visible_share > 0) {
    const BallView view = occlusion_.view(camera_.position, ball.position, robots);
    if (view.share < params_.visible_share) return;
    if (view.share < 1) {
      area *= view.share;
      seen += on_ball_plane(camera_.position, view.center, ball_radius_) -
              on_ball_plane(camera_.position, ball.position, ball_radius_);
    }
  }
  if (params_.area_sigma > 0) area += params_.area_sigma * area_noise_.gaussian(image, ball_object);
  seen += Vector2d(dx, dy);
  world::DetectedBall& detected = out.balls.emplace_back();
  detected.position = world::as_on_wire(Vector2d(seen + error_at(on_ground)));
  detected.pixel = ball_pixel(seen);
  report_blob(area, detected);
}

void Eye::see_robots(std::uint32_t image, std::span<const truth::Robot> robots, world::Detection& out) {
  in_view_.clear();
  for (const truth::Robot& robot : robots) {
    const unsigned object = object_of(robot.id);
    bool lost = bursts_.lost(params_.robot_burst_start, params_.robot_burst_length, image, object);
    if (!area_.contains(robot.position)) continue;
    in_view_.push_back(&robot);
    const double dx = params_.robot_sigma * noise_.gaussian();
    const double dy = params_.robot_sigma * noise_.gaussian();
    const double turned = params_.orientation_sigma * noise_.gaussian();
    lost |= loss_.uniform() < params_.robot_missing;
    if (lost) continue;

    const Vector2d seen = robot.position + Vector2d(dx, dy);
    world::DetectedRobot& detected = out.robots.emplace_back();
    detected.team = robot.id.team;
    detected.position = world::as_on_wire(Vector2d(seen + error_at(robot.position)));
    detected.confidence = sent_robot_confidence;
    detected.pixel = as_float(pixel_of(camera_, {seen.x(), seen.y(), robot_height_}));
    // Number and orientation come out of one match of the pattern: without it there is neither.
    if (params_.unread_id > 0 && ids_.uniform(image, object, Unread) < params_.unread_id) continue;
    detected.number = robot.id.number;
    detected.orientation = world::as_float(world::wrap_angle(robot.orientation + turned));
    if (params_.misread_id > 0 && ids_.uniform(image, object, Misread) < params_.misread_id) {
      constexpr int others = world::max_robot_number;
      const int further = 1 + static_cast<int>(others * ids_.uniform(image, object, Instead));
      detected.number = static_cast<std::uint8_t>((robot.id.number + further) % (others + 1));
    }
  }
}

void Eye::see_false_balls(std::uint32_t image, world::Detection& out) {
  for (const FalseBalls::Seen& ball : false_balls_.update(image, in_view_)) {
    const auto noise = [&](unsigned purpose) {
      return false_ball_noise_.gaussian(image, ball.age, 2 * purpose);
    };
    const Vector2d on_ground = projected_to_ground(camera_.position, ball.place, ball_radius_);
    const Vector2d seen = on_ground + params_.ball_sigma * Vector2d(noise(0), noise(1));
    world::DetectedBall& detected = out.balls.emplace_back();
    detected.position = world::as_on_wire(Vector2d(seen + error_at(on_ground)));
    detected.pixel = ball_pixel(seen);
    report_blob(ball.size * ball_area(camera_, ball.place, ball_radius_) + params_.area_sigma * noise(2),
                detected);
  }
}

// What a wrong calibration makes of a place: the pixel is right, the position is not.
Vector2d Eye::error_at(const Vector2d& place) const { return bias_ + regions_.offset(place); }

Vector2d Eye::ball_pixel(const Vector2d& place) const {
  return as_float(pixel_of(camera_, {place.x(), place.y(), ball_radius_}));
}

}  // namespace vision
