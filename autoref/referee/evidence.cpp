#include "autoref/referee/evidence.h"

#include <fmt/format.h>

#include <map>
#include <utility>
#include <vector>

#include "autoref/referee/explain.h"

namespace referee {
namespace {

using Thresholds = std::vector<std::pair<const char*, double>>;

// The numbers of the rule set that decide about an event.
struct ThresholdsOf {
  const world::RuleSet& rules;

  Thresholds exit() const {
    return {{"exit_frames", rules.exit_frames},
            {"exit_frames_mouth", rules.exit_frames_mouth},
            {"exit_frames_jump", rules.exit_frames_jump},
            {"exit_frames_hidden", rules.exit_frames_hidden},
            {"ball_radius", rules.field.ball_radius}};
  }
  Thresholds operator()(const world::BallLeftFieldTouchLine&) const { return exit(); }
  Thresholds operator()(const world::BallLeftFieldGoalLine&) const { return exit(); }
  Thresholds operator()(const world::PossibleGoal&) const {
    return {{"goal_width", rules.field.goal_width}, {"goal_height", rules.field.goal_height}};
  }
  Thresholds operator()(const world::BotKickedBallTooFast&) const {
    return {{"max_ball_speed", rules.max_ball_speed}};
  }
  Thresholds operator()(const world::BotDribbledBallTooFar&) const {
    return {{"max_dribble", rules.max_dribble}};
  }
  Thresholds operator()(const world::AttackerDoubleTouchedBall&) const {
    return {{"kick_travel", rules.kick_travel}};
  }
  Thresholds operator()(const world::AimlessKick&) const { return {{"icing_margin", rules.icing_margin}}; }
  Thresholds operator()(const world::ChippedGoal&) const {
    return {{"chip_height", rules.chip_height}, {"chip_rolling", world::seconds(rules.chip_rolling)}};
  }
  Thresholds crash() const {
    return {{"crash_speed", rules.crash_speed},
            {"crash_speed_difference", rules.crash_speed_difference},
            {"crash_braking", rules.crash_braking}};
  }
  Thresholds operator()(const world::BotCrashUnique&) const { return crash(); }
  Thresholds operator()(const world::BotCrashDrawn&) const { return crash(); }
  Thresholds operator()(const world::DefenderInDefenseArea&) const {
    return {{"sure_touch", rules.sure_touch}};
  }
  Thresholds operator()(const world::AttackerTouchedBallInDefenseArea&) const {
    return {{"sure_touch", rules.sure_touch}};
  }
  Thresholds operator()(const world::KeeperHeldBall&) const {
    return {{"keeper_hold", world::seconds(rules.keeper_hold)}};
  }
  Thresholds operator()(const world::BotTooFastInStop&) const {
    return {{"stop_speed", rules.stop_speed},
            {"stop_speed_margin", rules.stop_speed_margin},
            {"stop_grace", world::seconds(rules.stop_grace)},
            {"stop_violation", world::seconds(rules.stop_violation)}};
  }
  Thresholds operator()(const world::BotTooNearInStop&) const {
    return {{"stop_distance", rules.stop_distance},
            {"distance_margin", rules.distance_margin},
            {"stop_grace", world::seconds(rules.stop_grace)}};
  }
  Thresholds operator()(const world::BotLeftField&) const {
    return {{"run_off", rules.run_off}, {"run_off_time", world::seconds(rules.run_off_time)}};
  }
  Thresholds operator()(const world::TooManyRobots&) const {
    return {{"surplus_robot_time", world::seconds(rules.surplus_robot_time)}};
  }
  Thresholds operator()(const world::NoProgressInGame&) const {
    return {{"stuck_distance", rules.stuck_distance}, {"stuck_time", world::seconds(rules.stuck_time)}};
  }
  Thresholds operator()(const world::KickTaken&) const {
    return {{"kick_travel", rules.kick_travel},
            {"opponent_distance", rules.opponent_distance},
            {"attacker_area_distance", rules.attacker_area_distance},
            {"distance_margin", rules.distance_margin}};
  }
  Thresholds operator()(const world::RobotsSettled&) const {
    return {{"ball_settled_speed", rules.ball_settled_speed},
            {"robot_settled_speed", rules.robot_settled_speed},
            {"settled_for", world::seconds(rules.settled_for)},
            {"placement_tolerance", rules.placement_tolerance},
            {"settle_limit", world::seconds(rules.settle_limit)}};
  }
  template <class Other>
  Thresholds operator()(const Other&) const {
    return {};
  }
};

std::string json_text(std::string_view text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    result += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
  }
  return result + '"';
}

std::string touch_json(const world::Touch& touch) {
  return fmt::format(R"({{"t":{:.3f},"robot":{},"x":{:.3f},"y":{:.3f},"probability":{:.3f},"rival":{}}})",
                     world::seconds(touch.time), json_text(text(touch.robot)), touch.position.x(),
                     touch.position.y(), touch.probability,
                     touch.rival ? json_text(text(*touch.rival)) : "null");
}

std::string joined(const std::vector<std::string>& items) {
  std::string result = "[";
  for (const std::string& item : items) result += (result.size() > 1 ? "," : "") + item;
  return result + "]";
}

constexpr std::size_t every = 6;  // frames between two samples
constexpr double reach = 1.0;     // [m] robot to ball

}  // namespace

void Evidence::remember(const world::TrackedFrame& frame) {
  if (!frames_.empty() && frame.time <= frames_.back().time) frames_.clear();  // a clock that started anew
  frames_.push_back(frame);
  while (frame.time - frames_.front().time > span) frames_.pop_front();
}

std::string Evidence::record(const Call& call, const world::RuleSet& rules, const world::GameState& state,
                             std::span<const automaton::Occurrence> occurrences) const {
  std::vector<std::string> alternatives;
  for (const automaton::Occurrence& other : occurrences) {
    if (!other.event) continue;
    if (call.event && kind_of(*call.event) == kind_of(*other.event)) continue;
    alternatives.push_back(fmt::format(R"({{"detector":{},"what":{}}})", json_text(kind_of(*other.event)),
                                       json_text(describe(*other.event))));
  }

  std::vector<std::string> ball;
  std::vector<std::string> touches;
  std::map<std::string, std::vector<std::string>> robots;
  std::map<std::string, bool> came_near;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const world::TrackedFrame& frame = frames_[i];
    for (const world::Touch& touch : frame.touches) touches.push_back(touch_json(touch));
    if ((frames_.size() - 1 - i) % every != 0) continue;
    if (frame.ball) {
      const world::Vector3d& p = frame.ball->position;
      const world::Vector3d& v = frame.ball->velocity;
      ball.push_back(fmt::format("[{:.3f},{:.3f},{:.3f},{:.3f},{:.2f},{:.2f},{:.2f},{}]",
                                 world::seconds(frame.time), p.x(), p.y(), p.z(), v.x(), v.y(), v.z(),
                                 frame.ball->observed ? "true" : "false"));
    }
    for (const world::TrackedRobot& robot : frame.robots) {
      const std::string name = text(robot.id);
      if (frame.ball && (frame.ball->position.head<2>() - robot.position).norm() < reach)
        came_near[name] = true;
      robots[name].push_back(fmt::format("[{:.3f},{:.3f},{:.3f},{:.3f}]", world::seconds(frame.time),
                                         robot.position.x(), robot.position.y(), robot.orientation));
    }
  }
  std::string tracks = "{";
  for (const auto& [name, track] : robots) {
    if (came_near.contains(name))
      tracks += (tracks.size() > 1 ? "," : "") + json_text(name) + ":" + joined(track);
  }
  tracks += "}";

  std::string thresholds = "{";
  if (call.event) {
    for (const auto& [name, value] : std::visit(ThresholdsOf{rules}, call.event->what)) {
      thresholds += fmt::format("{}{}:{}", thresholds.size() > 1 ? "," : "", json_text(name), value);
    }
  }
  thresholds += "}";

  return fmt::format(
      R"({{"time":{:.3f},"row":{},"detector":{},"sentence":{},"thresholds":{},"alternatives":{},"last_touch":{},)"
      R"("touches":{},"ball_columns":["t","x","y","z","vx","vy","vz","seen"],"ball":{},)"
      R"("robot_columns":["t","x","y","orientation"],"robots":{}}})",
      world::seconds(call.time), json_text(call.row), call.event ? json_text(kind_of(*call.event)) : "null",
      json_text(call.sentence), thresholds, joined(alternatives),
      state.last_touch ? touch_json(*state.last_touch) : "null", joined(touches), joined(ball), tracks);
}

}  // namespace referee
