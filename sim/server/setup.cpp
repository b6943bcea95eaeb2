#include "sim/server/setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "sim/server/realism_messages.h"
#include "sim/server/wheels.h"
#include "sim/wire/vision_packet.h"

namespace server {
namespace {

using wire::Problem;
namespace code = wire::code;

constexpr std::size_t most_cameras = 8;  // as the realism's; their geometry is one datagram of 1.5 kB
constexpr double lowest_camera = 0.5;    // [m] sim/vision's

void require(bool holds, const std::string& sentence) {
  if (!holds) throw std::invalid_argument(sentence);
}

/// A number that came as a float, as its sender wrote it: 0.1, not 0.10000000149011612.
float written(double value) { return static_cast<float>(value); }

void check_range(const char* name, double value, double lowest, double highest) {
  require(value >= lowest && value <= highest,
          fmt::format("field: {} must be from {} to {} m, is {}", name, lowest, highest, written(value)));
}

/// The name of a number of the realism's robots in the messages.
std::string_view message_name(std::string_view key) {
  static const std::map<std::string_view, std::string_view> names = {
      {"robots.max_speed", "vel_absolute_max"},
      {"robots.max_speed_sideways", "vel_sideways_max"},
      {"robots.max_acceleration", "acc_speedup_absolute_max"},
      {"robots.max_acceleration_sideways", "acc_speedup_sideways_max"},
      {"robots.max_brake", "acc_brake_absolute_max"},
      {"robots.max_brake_sideways", "acc_brake_sideways_max"},
      {"robots.max_angular_speed", "vel_angular_max"},
      {"robots.max_angular_acceleration", "acc_speedup_angular_max"},
      {"robots.max_angular_brake", "acc_brake_angular_max"},
      {"robots.max_kick_speed", "max_linear_kick_speed"},
      {"robots.max_chip_speed", "max_chip_kick_speed"},
  };
  const auto found = names.find(key);
  return found != names.end() ? found->second : key.substr(key.find('.') + 1);
}

/// The bounds of the realism's keys hold for every single robot too. Only messages can break them here, so
/// the fields have the names of the messages.
void check_robot(const world::RobotSpecs& specs, const wire::WheelAngles& wheels, engine::Realism& scratch) {
  const std::string owner = fmt::format("{} {}: ", name(specs.id.team), specs.id.number);
  const auto within = [&](std::string_view field, double value, double lowest, double highest,
                          std::string_view unit) {
    require(value >= lowest && value <= highest, fmt::format("{}{} = {} must be from {} to {} {}", owner,
                                                             field, written(value), lowest, highest, unit));
  };
  scratch.robots = specs;
  for (const engine::RealismKey& key : engine::realism_keys()) {
    if (!key.name.starts_with("robots.")) continue;
    within(message_name(key.name), key.get(scratch), key.lowest, key.highest, key.unit);
  }
  within("radius", specs.radius, 0.02, 0.5, "m");
  within("height", specs.height, 0.02, 0.5, "m");
  require(specs.center_to_dribbler >= specs.radius / 2 && specs.center_to_dribbler < specs.radius,
          fmt::format("{}radius = {} and center_to_dribbler = {} m do not fit: the front must be at least "
                      "half of the radius before the centre, and less than all of it",
                      owner, written(specs.radius), written(specs.center_to_dribbler)));
  require(specs.dribbler_width <= 2 * specs.radius,
          fmt::format("{}radius = {} and dribbler_width = {} m do not fit: the dribbler must be at most as "
                      "wide as the robot",
                      owner, written(specs.radius), written(specs.dribbler_width)));
  require(motion(wheels, {}, specs.radius).has_value(),
          owner + "wheel_angles leave a direction open: the wheels must not all push the same way");
}

/// Replaces `setup` by `changed` when that is possible; else says why not.
std::vector<Problem> replace(Setup& setup, Setup changed, std::string_view code, const std::string& owner,
                             std::vector<Problem> problems) {
  try {
    check(changed);
    setup = std::move(changed);
  } catch (const std::invalid_argument& error) {
    problems.push_back({code, owner + error.what()});
  }
  return problems;
}

/// Everything that messages can change, as bytes. They came in wire types, so those tell any two apart.
std::string fingerprint(const Setup& setup) {
  std::string bytes;
  wire::encode_packet(model(setup).geometry, bytes);
  for (const engine::RealismKey& key : engine::realism_keys()) {
    bytes += fmt::format("{} ", key.get(setup.realism));
  }
  wire::proto::RobotSpecs message;
  for (const world::Team team : world::both_teams) {
    for (std::size_t i = 0; i < robots_per_team; ++i) {
      wire::encode(setup.specs[team][i], message);
      message.AppendToString(&bytes);
      const wire::WheelAngles& wheels = setup.wheels[team][i];
      bytes += fmt::format("{} {} {} {} ", wheels.front_right, wheels.back_right, wheels.back_left,
                           wheels.front_left);
    }
  }
  return bytes;
}

bool has(const std::vector<Problem>& problems, std::string_view code) {
  return std::any_of(problems.begin(), problems.end(), [&](const Problem& p) { return p.code == code; });
}

/// What of a ball model the physics can follow: its two decelerations. The rest follows from the physics.
std::vector<Problem> apply_ball(const matchday::vision::SSL_GeometryModels& models, Setup& setup) {
  std::vector<Problem> problems;
  const auto set = [&](const char* key, const char* name, double value) {
    try {
      engine::set(setup.realism, key, -value);
    } catch (const std::invalid_argument& error) {
      problems.push_back(
          {code::geometry, fmt::format("models.straight_two_phase.{} = {}: {}", name, value, error.what())});
    }
  };
  if (models.has_straight_two_phase()) {
    const auto& ball = models.straight_two_phase();
    set("ball.slide_deceleration", "acc_slide", ball.acc_slide());
    set("ball.roll_deceleration", "acc_roll", ball.acc_roll());
    const double ours = world::Geometry{}.ball_switch_ratio;
    if (!(std::abs(ball.k_switch() - ours) < 0.001)) {  // a message may have rounded it
      problems.push_back(
          {code::unsupported, fmt::format("models.straight_two_phase.k_switch = {} is ignored: a solid ball "
                                          "begins to roll at {:.4f} of its speed",
                                          ball.k_switch(), ours)});
    }
  }
  if (models.has_chip_fixed_loss()) {
    problems.push_back({code::unsupported,
                        "models.chip_fixed_loss is ignored: bounces follow from the realism's "
                        "ball.restitution and ball.bounce_friction"});
  }
  return problems;
}

}  // namespace

Setup make_setup(const world::Field& field, const engine::Realism& realism, std::uint64_t seed) {
  Setup setup;
  setup.field = field;
  setup.realism = realism;
  setup.seed = seed;
  give_bodies(setup);
  return setup;
}

void give_bodies(Setup& setup) {
  for (const world::Team team : world::both_teams) {
    for (std::size_t i = 0; i < robots_per_team; ++i) {
      if (setup.own_specs[team][i]) continue;
      setup.specs[team][i] = setup.realism.robots;
      setup.specs[team][i].id = {team, static_cast<std::uint8_t>(i)};
    }
  }
}

engine::Model model(const Setup& setup) {
  engine::Model model;
  model.geometry.field = setup.field;
  model.geometry.cameras = setup.cameras;
  if (setup.cameras.empty()) {
    const auto& vision = setup.realism.vision;
    model.geometry.cameras = world::camera_grid(setup.field, vision.cameras, vision.camera_height);
  }
  model.geometry.ball_slide_deceleration = setup.realism.physics.ball.slide_deceleration;
  model.geometry.ball_roll_deceleration = setup.realism.physics.ball.roll_deceleration;
  for (const world::Team team : world::both_teams) {
    model.robots[team].assign(setup.specs[team].begin(), setup.specs[team].end());
  }
  model.realism = setup.realism;
  model.seed = setup.seed;
  return model;
}

bool same_world(const Setup& a, const Setup& b) { return fingerprint(a) == fingerprint(b); }

void check(const Setup& setup) {
  engine::Realism scratch;
  for (const world::Team team : world::both_teams) {
    for (std::size_t i = 0; i < robots_per_team; ++i) {
      check_robot(setup.specs[team][i], setup.wheels[team][i], scratch);
    }
  }
  const engine::Model whole = model(setup);
  engine::check(whole);
  check_range("length", setup.field.length, 1, 50);
  check_range("width", setup.field.width, 1, 50);
  check_range("boundary_width", setup.field.boundary_width, 0, 10);
  check_range("goal_height", setup.field.goal_height, 0.05, 2);
  check_range("ball_radius", setup.field.ball_radius, 0.01, 0.05);
  const auto& cameras = whole.geometry.cameras;
  require(cameras.size() <= most_cameras,
          fmt::format("cameras: at most {}, there are {}", most_cameras, cameras.size()));
  std::set<int> ids;
  for (const world::Camera& camera : cameras) {
    require(camera.position.z() >= lowest_camera,
            fmt::format("camera {} must be at least {} m high, is at {} m", camera.id, lowest_camera,
                        written(camera.position.z())));
    require(ids.insert(camera.id).second, fmt::format("camera {} is there twice", camera.id));
  }
}

std::vector<Problem> apply(const matchday::vision::SSL_GeometryData& geometry, Setup& setup) {
  const auto decoded = wire::decode(geometry);
  if (!decoded) {
    return {
        {code::geometry, fmt::format("geometry: field_length = {} and field_width = {} must be lengths in "
                                     "millimetres, up to 100 m",
                                     geometry.field().field_length(), geometry.field().field_width())}};
  }
  if (decoded->cameras.size() != static_cast<std::size_t>(geometry.calib_size())) {
    return {{code::geometry,
             fmt::format("geometry: of {} calibrations {} have no usable camera_id and place",
                         geometry.calib_size(),
                         static_cast<std::size_t>(geometry.calib_size()) - decoded->cameras.size())}};
  }
  Setup changed = setup;
  changed.field = decoded->field;
  changed.cameras = decoded->cameras;
  std::vector<Problem> problems = apply_ball(geometry.models(), changed);
  return replace(setup, std::move(changed), code::geometry, "geometry: ", std::move(problems));
}

std::vector<Problem> apply(const matchday::simulation::RobotSpecs& message, Setup& setup) {
  const auto id = wire::decode(message.id());
  if (!id) {
    return {wire::not_a_robot("robot_specs", message.id())};
  }
  const std::string owner = fmt::format("robot_specs, {} {}: ", name(id->team), id->number);
  Setup changed = setup;
  changed.own_specs[id->team].set(id->number);
  std::vector<Problem> problems =
      wire::apply(message, changed.specs[id->team][id->number], changed.wheels[id->team][id->number]);
  for (Problem& problem : problems) problem.message.insert(0, owner);
  if (has(problems, code::spec)) return problems;  // half a robot is nobody's wish
  return replace(setup, std::move(changed), code::spec, "robot_specs, ", std::move(problems));
}

std::vector<Problem> apply(const matchday::simulation::RealismConfig& message, std::size_t robots,
                           Setup& setup) {
  Setup changed = setup;
  const std::size_t cameras = model(setup).geometry.cameras.size();
  std::vector<Problem> problems = apply(message, robots, cameras, changed.realism);
  give_bodies(changed);
  const auto& before = setup.realism.vision;
  const auto& now = changed.realism.vision;
  if (before.cameras != now.cameras || before.camera_height != now.camera_height) changed.cameras.clear();
  return replace(setup, std::move(changed), code::realism, "", std::move(problems));
}

}  // namespace server
