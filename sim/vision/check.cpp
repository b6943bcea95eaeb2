#include "sim/vision/check.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "sim/world/time.h"

namespace vision {
namespace {

template <class... Values>
void require(bool holds, fmt::format_string<const Values&...> sentence, const Values&... values) {
  if (!holds) throw std::invalid_argument("vision: " + fmt::format(sentence, values...));
}

// A camera has to hang above everything it looks at [m]; robots are 0.15 m high.
constexpr double lowest_camera = 0.5;

void check_cameras(const world::Geometry& geometry, const world::RobotSpecs& body) {
  require(!geometry.cameras.empty(), "there must be at least one camera");
  const double lowest = std::max(lowest_camera, 2 * body.height);
  std::set<int> ids;
  for (const world::Camera& camera : geometry.cameras) {
    require(camera.position.allFinite() && camera.position.z() >= lowest,
            "camera {} must be at least {} m high, is at {} m", camera.id, lowest, camera.position.z());
    require(ids.insert(camera.id).second, "camera {} is there twice", camera.id);
    require(std::isfinite(camera.focal_length) && camera.focal_length > 0,
            "camera {} must have a focal length above 0 px, has {}", camera.id, camera.focal_length);
    require(camera.image_width > 0 && camera.image_height > 0,
            "camera {} must have an image of at least 1 by 1 px, has {} by {}", camera.id, camera.image_width,
            camera.image_height);
  }
}

void check_body(const world::RobotSpecs& body) {
  require(std::isfinite(body.height) && body.height > 0, "a robot must be higher than 0 m, is {}",
          body.height);
  require(std::isfinite(body.radius) && body.center_to_dribbler > 0 && body.center_to_dribbler < body.radius,
          "a robot's front must be between its centre and its radius of {} m, is at {} m", body.radius,
          body.center_to_dribbler);
}

}  // namespace

void check(const world::Geometry& geometry, const Params& params, const world::RobotSpecs& body) {
  check_body(body);
  check_cameras(geometry, body);
  require(std::isfinite(geometry.field.ball_radius) && geometry.field.ball_radius > 0,
          "ball_radius must be above 0 m, is {}", geometry.field.ball_radius);

  const auto between = [](const char* name, double value, double least, double most) {
    require(value >= least && value <= most, "{} must be from {} to {}, is {}", name, least, most, value);
  };
  const auto not_negative = [](const char* name, double value) {
    require(std::isfinite(value) && value >= 0, "{} must be 0 or more, is {}", name, value);
  };
  not_negative("overlap", params.overlap);
  between("delay", params.delay, 0, 60);
  not_negative("ball_sigma", params.ball_sigma);
  not_negative("robot_sigma", params.robot_sigma);
  not_negative("orientation_sigma", params.orientation_sigma);
  not_negative("bias_sigma", params.bias_sigma);
  not_negative("area_sigma", params.area_sigma);
  between("ball_missing", params.ball_missing, 0, 1);
  between("robot_missing", params.robot_missing, 0, 1);
  between("visible_share", params.visible_share, 0, 1);
  between("ball_burst_start", params.ball_burst_start, 0, 1);
  between("ball_burst_length", params.ball_burst_length, 1, 1e6);
  between("robot_burst_start", params.robot_burst_start, 0, 1);
  between("robot_burst_length", params.robot_burst_length, 1, 1e6);
  between("regions", params.regions, 0, 1000);
  require(std::isfinite(params.region_radius) && params.region_radius > 0,
          "region_radius must be above 0 m, is {}", params.region_radius);
  between("region_missing", params.region_missing, 0, 1);
  not_negative("region_offset", params.region_offset);
  between("false_ball_rate", params.false_ball_rate, 0, world::ticks_per_second);  // one an image
  between("false_ball_shortest", params.false_ball_shortest, 1, 1000);
  between("false_ball_longest", params.false_ball_longest, 1, 1000);
  require(params.false_ball_shortest <= params.false_ball_longest,
          "false_ball_shortest must be at most false_ball_longest, {}, is {}", params.false_ball_longest,
          params.false_ball_shortest);
  between("misread_id", params.misread_id, 0, 1);
  between("unread_id", params.unread_id, 0, 1);
}

}  // namespace vision
