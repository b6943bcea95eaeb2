#include "sim/server/realism_messages.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sim/proto/simulation_custom.pb.h"
#include "sim/wire/any.h"
#include "sim/world/time.h"

namespace server {
namespace {

using wire::Problem;
namespace code = wire::code;
using matchday::simulation::RealismConfigErForce;
using matchday::simulation::RealismMatchday;

class Changes {
 public:
  Changes(engine::Realism& realism, std::vector<Problem>& problems)
      : realism_(realism), problems_(problems) {}

  /// @param whose  for the sentence, e.g. the name of a foreign field
  void set(std::string_view key, double value, const std::string& whose = "") {
    try {
      engine::set(realism_, key, value);
    } catch (const std::invalid_argument& error) {
      problems_.push_back({code::realism, whose + error.what()});
    }
  }
  bool preset(const std::string& name) {
    try {
      realism_ = engine::realism(name);
      return true;
    } catch (const std::invalid_argument& error) {
      problems_.push_back({code::realism, wire::printable(error.what())});
      return false;
    }
  }
  void unsupported(std::string sentence) { problems_.push_back({code::unsupported, std::move(sentence)}); }
  const engine::Realism& realism() const { return realism_; }

 private:
  engine::Realism& realism_;
  std::vector<Problem>& problems_;
};

void apply_ours(const RealismMatchday& message, Changes& changes) {
  if (message.has_preset() && !changes.preset(message.preset())) return;  // the keys were meant on top of it
  for (const auto& value : message.values()) changes.set(wire::printable(value.key()), value.value());
}

/// The decimal number that people wrote for a float: 0.1, not 0.10000000149011612.
double as_written(double value) {
  const std::string text = fmt::format("{}", static_cast<float>(value));
  double result = 0;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

double ticks(double nanoseconds) { return std::round(nanoseconds * 1e-9 * world::ticks_per_second); }

void apply_er_force(const RealismConfigErForce& theirs, double robots_per_camera, Changes& changes) {
  const auto take = [&](bool present, const char* field, double value, std::string_view key) {
    if (present) changes.set(key, as_written(value), fmt::format("{}: ", field));
  };
  const auto refuse = [&](bool present, const char* field, double value, const char* reason) {
    if (present) changes.unsupported(fmt::format("{} = {} is ignored: {}", field, as_written(value), reason));
  };
  take(theirs.has_stddev_ball_p(), "stddev_ball_p", theirs.stddev_ball_p(), "vision.ball_sigma");
  take(theirs.has_stddev_robot_p(), "stddev_robot_p", theirs.stddev_robot_p(), "vision.robot_sigma");
  take(theirs.has_stddev_robot_phi(), "stddev_robot_phi", theirs.stddev_robot_phi(),
       "vision.orientation_sigma");
  take(theirs.has_stddev_ball_area(), "stddev_ball_area", theirs.stddev_ball_area(), "vision.area_sigma");
  // One number here for their two: a share of 0 never hides the ball. Without the threshold, theirs is 0.4.
  const double share = theirs.has_ball_visibility_threshold() ? theirs.ball_visibility_threshold() : 0.4;
  const bool hidden = theirs.has_enable_invisible_ball() ? theirs.enable_invisible_ball()
                                                         : changes.realism().vision.visible_share > 0;
  take(theirs.has_ball_visibility_threshold() || theirs.has_enable_invisible_ball(),
       "ball_visibility_threshold", hidden ? share : 0.0, "vision.visible_share");
  take(theirs.has_camera_overlap(), "camera_overlap", theirs.camera_overlap(), "vision.overlap");
  take(theirs.has_dribbler_ball_detections(), "dribbler_ball_detections",
       theirs.dribbler_ball_detections() * robots_per_camera, "vision.false_ball_rate");
  refuse(theirs.has_camera_position_error() && theirs.camera_position_error() != 0, "camera_position_error",
         theirs.camera_position_error(), "the geometry tells where the cameras are");
  take(theirs.has_robot_command_loss(), "robot_command_loss", theirs.robot_command_loss(), "radio.loss");
  refuse(theirs.has_robot_response_loss() && theirs.robot_response_loss() != 0, "robot_response_loss",
         theirs.robot_response_loss(), "every request is answered");
  take(theirs.has_missing_ball_detections(), "missing_ball_detections", theirs.missing_ball_detections(),
       "vision.ball_missing");
  take(theirs.has_vision_delay(), "vision_delay", ticks(static_cast<double>(theirs.vision_delay())),
       "vision.delay");
  refuse(theirs.has_vision_processing_time() && theirs.vision_processing_time() != 0,
         "vision_processing_time", static_cast<double>(theirs.vision_processing_time()),
         "t_capture is the time of the image and t_sent the time of sending, always");
  refuse(theirs.has_simulate_dribbling() && !theirs.simulate_dribbling(), "simulate_dribbling", 0,
         "the dribbler is always simulated, the ball never glued");
  take(theirs.has_object_position_offset(), "object_position_offset", theirs.object_position_offset(),
       "vision.bias_sigma");
  take(theirs.has_missing_robot_detections(), "missing_robot_detections", theirs.missing_robot_detections(),
       "vision.robot_missing");
  take(theirs.has_command_delay(), "command_delay", ticks(static_cast<double>(theirs.command_delay())),
       "radio.latency");
}

}  // namespace

std::vector<Problem> apply(const matchday::simulation::RealismConfig& message, std::size_t robots,
                           std::size_t cameras, engine::Realism& realism) {
  std::vector<Problem> problems;
  Changes changes(realism, problems);
  for (const google::protobuf::Any& custom : message.custom()) {
    if (const auto ours = wire::unpacked<RealismMatchday>(custom, {"matchday.simulation."})) {
      apply_ours(*ours, changes);
    } else if (const auto theirs = wire::unpacked<RealismConfigErForce>(custom, {"", "sslsim."})) {
      apply_er_force(*theirs, static_cast<double>(robots) / static_cast<double>(cameras), changes);
    } else {
      changes.unsupported(
          fmt::format("realism_config: custom \"{}\" is not known or not readable; known are "
                      "matchday.simulation.RealismMatchday and RealismConfigErForce",
                      wire::printable(custom.type_url())));
    }
  }
  return problems;
}

}  // namespace server
