#include <cmath>

#include "sim/wire/units.h"
#include "sim/wire/vision.h"

namespace wire {

namespace {

constexpr std::uint32_t max_camera_id = 255;  // ours: no set-up has more than 8 cameras
// Ours: at most 160 false balls, the worst that a realism can ask for; and each of the 32
// patterns seen twice is 64.
constexpr std::size_t max_balls = 256;
constexpr std::size_t max_robots = 64;

void encode_robot(const world::DetectedRobot& robot, proto::SSL_DetectionRobot& out) {
  out.set_confidence(static_cast<float>(robot.confidence));
  if (robot.number) out.set_robot_id(*robot.number);
  out.set_x(to_mm(robot.position.x()));
  out.set_y(to_mm(robot.position.y()));
  if (robot.orientation) out.set_orientation(static_cast<float>(*robot.orientation));
  out.set_pixel_x(static_cast<float>(robot.pixel.x()));
  out.set_pixel_y(static_cast<float>(robot.pixel.y()));
}

double finite_or_zero(float value) { return std::isfinite(value) ? static_cast<double>(value) : 0.0; }

template <class Object>
bool has_position(const Object& object) {
  return object.has_x() && object.has_y() && is_coordinate(object.x()) && is_coordinate(object.y());
}

void decode_robot(const proto::SSL_DetectionRobot& robot, world::Team team, world::Detection& out) {
  if (!has_position(robot) || out.robots.size() == max_robots) return;
  world::DetectedRobot& result = out.robots.emplace_back();
  result.team = team;
  if (robot.has_robot_id() && robot.robot_id() <= world::max_robot_number) {
    result.number = static_cast<std::uint8_t>(robot.robot_id());
  }
  result.position = {from_mm(robot.x()), from_mm(robot.y())};
  if (robot.has_orientation() && std::isfinite(robot.orientation())) result.orientation = robot.orientation();
  result.confidence = finite_or_zero(robot.confidence());
  result.pixel = {finite_or_zero(robot.pixel_x()), finite_or_zero(robot.pixel_y())};
}

}  // namespace

void encode(const world::Detection& detection, Epoch epoch, proto::SSL_DetectionFrame& out) {
  out.Clear();
  out.set_frame_number(detection.frame_number);
  out.set_t_capture(to_unix_seconds(detection.t_capture, epoch));
  out.set_t_sent(to_unix_seconds(detection.t_sent, epoch));
  out.set_camera_id(static_cast<std::uint32_t>(detection.camera));
  for (const world::DetectedBall& ball : detection.balls) {
    proto::SSL_DetectionBall& entry = *out.add_balls();
    entry.set_confidence(static_cast<float>(ball.confidence));
    entry.set_area(ball.area);
    entry.set_x(to_mm(ball.position.x()));
    entry.set_y(to_mm(ball.position.y()));
    entry.set_pixel_x(static_cast<float>(ball.pixel.x()));
    entry.set_pixel_y(static_cast<float>(ball.pixel.y()));
  }
  for (const world::DetectedRobot& robot : detection.robots) {
    encode_robot(robot,
                 robot.team == world::Team::Yellow ? *out.add_robots_yellow() : *out.add_robots_blue());
  }
}

bool usable(const proto::SSL_DetectionFrame& frame) {
  return frame.has_t_capture() && from_unix_seconds(frame.t_capture(), {}).has_value() &&
         frame.has_camera_id() && frame.camera_id() <= max_camera_id;
}

void decode(const proto::SSL_DetectionFrame& frame, Epoch epoch, world::Detection& out) {
  out.camera = 0;
  out.frame_number = frame.frame_number();
  out.t_capture = {};
  out.t_sent = {};
  out.balls.clear();
  out.robots.clear();
  if (!usable(frame)) return;

  out.camera = static_cast<int>(frame.camera_id());
  out.t_capture = *from_unix_seconds(frame.t_capture(), epoch);
  out.t_sent = from_unix_seconds(frame.has_t_sent() ? frame.t_sent() : frame.t_capture(), epoch)
                   .value_or(out.t_capture);
  for (const proto::SSL_DetectionBall& ball : frame.balls()) {
    if (!has_position(ball)) continue;
    if (out.balls.size() == max_balls) break;
    world::DetectedBall& result = out.balls.emplace_back();
    result.position = {from_mm(ball.x()), from_mm(ball.y())};
    result.confidence = finite_or_zero(ball.confidence());
    result.area = ball.area();
    result.pixel = {finite_or_zero(ball.pixel_x()), finite_or_zero(ball.pixel_y())};
  }
  for (const proto::SSL_DetectionRobot& robot : frame.robots_yellow()) {
    decode_robot(robot, world::Team::Yellow, out);
  }
  for (const proto::SSL_DetectionRobot& robot : frame.robots_blue()) {
    decode_robot(robot, world::Team::Blue, out);
  }
}

world::Detection decode(const proto::SSL_DetectionFrame& frame, Epoch epoch) {
  world::Detection result;
  decode(frame, epoch, result);
  return result;
}

}  // namespace wire
