// SimulatorConfig: geometry, robot specs, realism, vision port; what each field does and what is refused.
#include <gmock/gmock.h>

#include <functional>
#include <numbers>
#include <set>
#include <stdexcept>

#include "sim/proto/simulation_custom.pb.h"
#include "sim/wire/vision.h"
#include "tests/sim/server/bench.h"

namespace {

using bench::Bench;
using testing::HasSubstr;
namespace proto = bench::proto;
using world::Team;

/// The field of division B as SSL-Vision publishes it.
world::Geometry division_b() {
  world::Geometry geometry;
  geometry.field.boundary_width = 0.3;
  geometry.field.defense_area = {.shape = world::DefenseArea::Shape::Rectangle, .depth = 1, .width = 2};
  geometry.cameras = {{.id = 3, .position = {-2, 0, 5}}, {.id = 8, .position = {2, 0, 5}}};
  return geometry;
}

proto::SimulatorCommand with_geometry(const world::Geometry& geometry) {
  proto::SimulatorCommand command;
  wire::encode(geometry, *command.mutable_config()->mutable_geometry());
  return command;
}

matchday::vision::SSL_GeometryData published(const Bench& bench) {
  matchday::vision::SSL_WrapperPacket packet;
  EXPECT_TRUE(packet.ParseFromString(bench.server.geometry()));
  return packet.geometry();
}

proto::RobotSpecs specs_of(unsigned number, Team team = Team::Blue) {
  proto::RobotSpecs specs;
  specs.mutable_id()->set_id(number);
  specs.mutable_id()->set_team(bench::colour(team));
  return specs;
}

proto::SimulatorCommand with_specs(const proto::RobotSpecs& specs) {
  proto::SimulatorCommand command;
  *command.mutable_config()->add_robot_specs() = specs;
  return command;
}

const world::RobotSpecs& specs_in(const Bench& bench, unsigned number, Team team = Team::Blue) {
  return bench.server.simulation().setup().specs[team][number];
}

template <class Payload>
proto::SimulatorCommand with_realism(const Payload& payload, const std::string& name) {
  proto::SimulatorCommand command;
  auto& any = *command.mutable_config()->mutable_realism_config()->add_custom();
  any.set_type_url("type.googleapis.com/" + name);
  any.set_value(payload.SerializeAsString());
  return command;
}

proto::SimulatorCommand ours(const std::string& preset,
                             const std::vector<std::pair<std::string, double>>& values) {
  proto::RealismMatchday message;
  if (!preset.empty()) message.set_preset(preset);
  for (const auto& [key, value] : values) {
    message.add_values()->set_key(key);
    message.mutable_values(message.values_size() - 1)->set_value(value);
  }
  return with_realism(message, "matchday.simulation.RealismMatchday");
}

const engine::Realism& realism_in(const Bench& bench) { return bench.server.simulation().setup().realism; }

}  // namespace

TEST(Geometry, ReplacesFieldAndCamerasAndGoesOn) {
  Bench b;
  proto::SimulatorCommand motion;
  auto& ball = *motion.mutable_control()->mutable_teleport_ball();
  ball.set_x(1);
  ball.set_y(1);
  ball.set_vx(1);
  ball.set_roll(true);
  b.control(motion);
  b.robots(Team::Blue, bench::local(1, 1));
  b.steps(5);
  const truth::Frame before = b.server.simulation().truth();

  EXPECT_EQ(b.codes(with_geometry(division_b())), "");
  const truth::Frame& after = b.server.simulation().truth();
  EXPECT_EQ(after.ball.position, before.ball.position);
  EXPECT_EQ(after.ball.velocity, before.ball.velocity);
  EXPECT_EQ(after.ball.spin, before.ball.spin);
  ASSERT_EQ(after.robots.size(), before.robots.size());
  for (std::size_t i = 0; i < after.robots.size(); ++i) {
    EXPECT_EQ(after.robots[i].id, before.robots[i].id);
    EXPECT_EQ(after.robots[i].position, before.robots[i].position);
    // One float of Bullet's from and to an angle: 1e-6.
    EXPECT_NEAR(after.robots[i].orientation, before.robots[i].orientation, 1e-6);
    EXPECT_EQ(after.robots[i].velocity, before.robots[i].velocity);
  }
  EXPECT_EQ(published(b).field().boundary_width(), 300);
  EXPECT_EQ(published(b).field().penalty_area_width(), 2000);
  ASSERT_EQ(published(b).calib_size(), 2);
  EXPECT_EQ(published(b).calib(1).camera_id(), 8U);
  EXPECT_EQ(published(b).calib(1).derived_camera_world_tz(), 5000);
  EXPECT_EQ(b.server.step().size(), 2U) << "two cameras now";
  EXPECT_EQ(b.server.time(), world::tick_time(6)) << "time went on";
}

TEST(Geometry, WithoutCamerasTheRealismsAreBuilt) {
  Bench b;
  b.control(with_geometry(division_b()));
  world::Geometry geometry = division_b();
  geometry.cameras.clear();
  EXPECT_EQ(b.codes(with_geometry(geometry)), "");
  EXPECT_EQ(published(b).calib_size(), 4);
}

TEST(Geometry, OfTheSimulatorItselfIsTakenBack) {
  Bench b("measured");
  const std::string before = b.server.geometry();
  proto::SimulatorCommand command;
  *command.mutable_config()->mutable_geometry() = published(b);
  EXPECT_EQ(b.codes(command), "");
  EXPECT_EQ(b.server.geometry(), before);
}

TEST(Geometry, PutsWhatIsOutsideNowAtTheWall) {
  Bench b;
  b.put(Team::Blue, 1, 5, -3.5);
  b.put_ball(-5, 3.5);
  world::Geometry small;
  small.field.length = 6;
  small.field.width = 4;
  EXPECT_EQ(b.codes(with_geometry(small)), "");
  const truth::Robot& robot = *b.robot(Team::Blue, 1);
  // Half of 6 m, 0.7 m of run-off, the robot's radius; a float in Bullet.
  EXPECT_NEAR(robot.position.x(), 3.7 - 0.09, 1e-6);
  EXPECT_NEAR(robot.position.y(), -2.7 + 0.09, 1e-6);
  EXPECT_NEAR(b.ball().position.x(), -3.7 + 0.0215, 1e-6);
  b.steps(60);
  EXPECT_LT(b.robot(Team::Blue, 1)->position.cwiseAbs().maxCoeff(), 3.7);
}

TEST(Geometry, TheBallModelSetsTheDecelerations) {
  Bench b;
  proto::SimulatorCommand command = with_geometry(division_b());
  auto& models = *command.mutable_config()->mutable_geometry()->mutable_models();
  models.mutable_straight_two_phase()->set_acc_slide(-4);
  models.mutable_straight_two_phase()->set_acc_roll(-0.5);
  EXPECT_EQ(b.codes(command), "");
  EXPECT_EQ(realism_in(b).physics.ball.slide_deceleration, 4);
  EXPECT_EQ(published(b).models().straight_two_phase().acc_roll(), -0.5);

  models.mutable_straight_two_phase()->set_acc_roll(0.5);
  EXPECT_EQ(b.codes(command), "INVALID_GEOMETRY ");
  models.mutable_straight_two_phase()->set_acc_roll(-0.25);
  models.mutable_straight_two_phase()->set_k_switch(0.64);
  models.mutable_chip_fixed_loss()->set_damping_z(0.5);
  EXPECT_EQ(b.codes(command), "UNSUPPORTED UNSUPPORTED ") << "the rest is done";
  EXPECT_EQ(realism_in(b).physics.ball.roll_deceleration, 0.25);
}

TEST(Geometry, AnImpossibleOneChangesNothing) {
  Bench b;
  const std::string before = b.server.geometry();
  const auto message = [&](const std::function<void(matchday::vision::SSL_GeometryData&)>& spoil) {
    proto::SimulatorCommand command = with_geometry(division_b());
    spoil(*command.mutable_config()->mutable_geometry());
    const auto response = b.control(command);
    EXPECT_EQ(response.errors_size(), 1);
    EXPECT_EQ(response.errors(0).code(), "INVALID_GEOMETRY");
    EXPECT_EQ(b.server.geometry(), before);
    return response.errors(0).message();
  };
  using Data = matchday::vision::SSL_GeometryData;
  EXPECT_THAT(message([](Data& g) { g.clear_field(); }), HasSubstr("field_length = 0"));
  EXPECT_THAT(message([](Data& g) { g.mutable_field()->set_field_length(60'000); }), HasSubstr("50 m"));
  EXPECT_THAT(message([](Data& g) { g.mutable_field()->set_field_width(900); }), HasSubstr("goal_width"));
  EXPECT_THAT(message([](Data& g) { g.mutable_field()->set_boundary_width(100); }),
              HasSubstr("boundary_width"));
  EXPECT_THAT(message([](Data& g) { g.mutable_field()->set_ball_radius(2000); }), HasSubstr("ball_radius"));
  EXPECT_THAT(message([](Data& g) { g.mutable_calib(0)->clear_camera_id(); }),
              HasSubstr("of 2 calibrations 1"));
  EXPECT_THAT(message([](Data& g) { g.mutable_calib(0)->set_camera_id(8); }),
              HasSubstr("camera 8 is there twice"));
  EXPECT_THAT(message([](Data& g) { g.mutable_calib(0)->set_derived_camera_world_tz(100); }),
              HasSubstr("at least 0.5 m high"));
  EXPECT_THAT(message([](Data& g) {
                for (unsigned i = 20; i < 30; ++i) {
                  *g.add_calib() = g.calib(0);
                  g.mutable_calib(g.calib_size() - 1)->set_camera_id(i);
                }
              }),
              HasSubstr("at most 8, there are 12"));
}

TEST(RobotSpecs, ChangeOneRobotAndOnlyWhatIsSaid) {
  Bench b;
  proto::RobotSpecs specs = specs_of(1);
  specs.mutable_limits()->set_vel_absolute_max(0.5);
  EXPECT_EQ(b.codes(with_specs(specs)), "");
  EXPECT_EQ(specs_in(b, 1).max_speed, 0.5);
  EXPECT_EQ(specs_in(b, 1).mass, 2.5);
  EXPECT_EQ(specs_in(b, 0).max_speed, 3);
  EXPECT_EQ(specs_in(b, 1, Team::Yellow).max_speed, 3);

  b.put(Team::Blue, 1, 0, 2);
  for (int i = 0; i < 60; ++i) {
    b.robots(Team::Blue, bench::local(1, 3));
    b.steps(1);
  }
  EXPECT_NEAR(b.robot(Team::Blue, 1)->velocity.x(), 0.5, 1e-4) << "it drives so";
}

TEST(RobotSpecs, WheelAnglesChangeWhatWheelSpeedsMean) {
  Bench b;
  proto::RobotSpecs specs = specs_of(1);
  auto& angles = *specs.mutable_wheel_angles();
  const float degree = std::numbers::pi_v<float> / 180;
  angles.set_front_right(60 * degree);
  angles.set_back_right(135 * degree);
  angles.set_back_left(225 * degree);
  angles.set_front_left(300 * degree);
  EXPECT_EQ(b.codes(with_specs(specs)), "");
  b.put(Team::Blue, 1, 0, 2);
  proto::RobotControl message = bench::order(1);
  auto& rims = *message.mutable_robot_commands(0)->mutable_move_command()->mutable_wheel_velocity();
  rims.set_front_right(0.5F * std::sin(60 * degree));
  rims.set_back_right(0.5F * std::sin(135 * degree));
  rims.set_back_left(0.5F * std::sin(225 * degree));
  rims.set_front_left(0.5F * std::sin(300 * degree));
  for (int i = 0; i < 60; ++i) {
    b.robots(Team::Blue, message);
    b.steps(1);
  }
  EXPECT_NEAR(b.robot(Team::Blue, 1)->velocity.x(), 0.5, 1e-3);
  EXPECT_NEAR(b.robot(Team::Blue, 1)->velocity.y(), 0, 1e-3);
  EXPECT_NEAR(b.robot(Team::Blue, 1)->angular_velocity, 0, 1e-3);

  angles.set_back_right(60 * degree);
  angles.set_back_left(60 * degree);
  angles.set_front_left(60 * degree);
  EXPECT_EQ(b.codes(with_specs(specs)), "INVALID_SPEC ");
}

TEST(RobotSpecs, ABadFieldLeavesTheWholeRobotAsItWas) {
  Bench b;
  proto::RobotSpecs specs = specs_of(1);
  specs.set_mass(2);
  specs.set_radius(-1);
  EXPECT_EQ(b.codes(with_specs(specs)), "INVALID_SPEC ");
  EXPECT_EQ(specs_in(b, 1).mass, 2.5);
  specs.set_radius(0.09F);
  specs.set_max_linear_kick_speed(11);  // possible for the robot, not for the walls
  EXPECT_EQ(b.codes(with_specs(specs)), "INVALID_SPEC ");
  specs.set_max_linear_kick_speed(6.5);
  specs.set_center_to_dribbler(0.095F);
  EXPECT_EQ(b.codes(with_specs(specs)), "INVALID_SPEC ");
  specs.set_center_to_dribbler(0.07F);
  specs.set_mass(1e-20F);
  EXPECT_EQ(b.codes(with_specs(specs)), "INVALID_SPEC ");
  EXPECT_EQ(specs_in(b, 1).mass, 2.5);
  specs.clear_id();
  EXPECT_EQ(b.codes(with_specs(specs)), "ROBOT_ID ");
}

TEST(RobotSpecs, ARefusalNamesTheFieldThatWasSentAsItWasWritten) {
  Bench b;
  const auto message = [&](const std::function<void(proto::RobotSpecs&)>& fill) {
    proto::RobotSpecs specs = specs_of(1);
    fill(specs);
    const auto response = b.control(with_specs(specs));
    EXPECT_EQ(response.errors_size(), 1);
    return response.errors(0).message();
  };
  using Specs = proto::RobotSpecs;
  EXPECT_EQ(message([](Specs& s) { s.set_radius(-0.1F); }),
            "robot_specs, blue 1: radius = -0.1: must be positive and finite");
  EXPECT_EQ(message([](Specs& s) { s.set_radius(0.6F); }),
            "robot_specs, blue 1: radius = 0.6 must be from 0.02 to 0.5 m");
  EXPECT_EQ(message([](Specs& s) { s.set_height(0.01F); }),
            "robot_specs, blue 1: height = 0.01 must be from 0.02 to 0.5 m");
  EXPECT_EQ(
      message([](Specs& s) { s.set_radius(0.2F); }),
      "robot_specs, blue 1: radius = 0.2 and center_to_dribbler = 0.073 m do not fit: the front must be at "
      "least half of the radius before the centre, and less than all of it");
  EXPECT_EQ(message([](Specs& s) { s.set_max_linear_kick_speed(10.1F); }),
            "robot_specs, blue 1: max_linear_kick_speed = 10.1 must be from 0.1 to 10 m/s");
  EXPECT_EQ(message([](Specs& s) { s.mutable_limits()->set_vel_absolute_max(0.05F); }),
            "robot_specs, blue 1: vel_absolute_max = 0.05 must be from 0.1 to 10 m/s");
  EXPECT_EQ(message([](Specs& s) { s.mutable_id()->set_id(16); }),
            "robot_specs: the id has team BLUE and number 16; it must have a team, YELLOW or BLUE, and a "
            "number, 0 to 15");
  EXPECT_THAT(message([](Specs& s) { s.clear_id(); }), HasSubstr("the id has no team and no number;"));
}

TEST(RobotSpecs, EveryBoundedNumberHasTheNameOfItsMessageField) {
  const auto fields = [](const google::protobuf::Descriptor* message) {
    std::set<std::string> names;
    for (int i = 0; i < message->field_count(); ++i) names.insert(message->field(i)->name());
    return names;
  };
  std::set<std::string> known = fields(proto::RobotSpecs::descriptor());
  known.merge(fields(proto::RobotLimits::descriptor()));
  known.merge(fields(proto::RobotSpecsMatchday::descriptor()));
  for (const engine::RealismKey& key : engine::realism_keys()) {
    if (!key.name.starts_with("robots.")) continue;
    server::Setup setup = server::make_setup(world::Field{}, engine::realism("none"), 1);
    engine::Realism bad;
    key.put(bad, 2 * key.highest);
    bad.robots.id = setup.specs.blue[1].id;
    setup.specs.blue[1] = bad.robots;
    try {
      server::check(setup);
      ADD_FAILURE() << key.name;
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      const std::string field = text.substr(8, text.find(" = ") - 8);  // behind "blue 1: "
      EXPECT_TRUE(known.contains(field)) << text;
    }
  }
}

TEST(RobotSpecs, ErForcesPayloadGivesTheDribblerWidth) {
  Bench b;
  proto::RobotSpecs specs = specs_of(1);
  proto::RobotSpecErForce theirs;
  theirs.set_shoot_radius(0.067F);
  theirs.set_dribbler_width(0.0625F);
  auto& any = *specs.add_custom();
  any.set_type_url("type.googleapis.com/sslsim.RobotSpecErForce");
  any.set_value(theirs.SerializeAsString());
  EXPECT_EQ(b.codes(with_specs(specs)), "UNSUPPORTED ") << "shoot_radius, and why";
  EXPECT_EQ(specs_in(b, 1).dribbler_width, 0.0625);
}

TEST(RealismMatchday, TakesAPresetAndThenSingleKeys) {
  Bench b;
  EXPECT_EQ(b.codes(ours("harsh", {{"vision.ball_sigma", 0.003}, {"robots.max_speed", 2}})), "");
  EXPECT_EQ(realism_in(b).name, "harsh");
  EXPECT_EQ(realism_in(b).vision.ball_sigma, 0.003);
  EXPECT_EQ(realism_in(b).vision.ball_missing, engine::realism("harsh").vision.ball_missing);
  EXPECT_EQ(specs_in(b, 0).max_speed, 2) << "the body of every robot";
  EXPECT_EQ(b.codes(ours("", {{"radio.loss", 0.5}})), "");
  EXPECT_EQ(realism_in(b).vision.ball_sigma, 0.003) << "without a preset the rest stays";
  EXPECT_EQ(realism_in(b).radio.loss, 0.5);
}

TEST(RealismMatchday, ARobotWithSpecsOfItsOwnKeepsThem) {
  Bench b;
  proto::RobotSpecs specs = specs_of(1);
  specs.set_mass(2);
  b.control(with_specs(specs));
  EXPECT_EQ(b.codes(ours("none", {{"robots.max_speed", 2}})), "");
  EXPECT_EQ(specs_in(b, 1).max_speed, 3);
  EXPECT_EQ(specs_in(b, 0).max_speed, 2);
}

TEST(RealismMatchday, NewCamerasReplaceThoseOfAGeometry) {
  Bench b;
  b.control(with_geometry(division_b()));
  EXPECT_EQ(b.codes(ours("", {{"vision.ball_sigma", 0.001}})), "");
  EXPECT_EQ(published(b).calib_size(), 2);
  EXPECT_EQ(b.codes(ours("", {{"vision.cameras", 8}})), "");
  EXPECT_EQ(published(b).calib_size(), 8);
  EXPECT_EQ(b.codes(ours("", {{"vision.cameras", 3}})), "INVALID_REALISM ");
  EXPECT_EQ(published(b).calib_size(), 8);
}

TEST(RealismMatchday, BadKeysAreRefusedOneByOne) {
  Bench b;
  EXPECT_EQ(b.codes(ours("", {{"vision.bal_sigma", 0.1}, {"radio.loss", 2}, {"radio.latency", 3}})),
            "INVALID_REALISM INVALID_REALISM ");
  EXPECT_EQ(realism_in(b).radio.latency, 3);
  EXPECT_EQ(b.codes(ours("real", {{"radio.latency", 5}})), "INVALID_REALISM ");
  EXPECT_EQ(realism_in(b).radio.latency, 3) << "keys on top of an unknown preset do not count";
  EXPECT_EQ(b.codes(with_realism(proto::RobotId{}, "somebody.Else")), "UNSUPPORTED ");
  proto::SimulatorCommand unreadable = ours("none", {});
  unreadable.mutable_config()->mutable_realism_config()->mutable_custom(0)->set_value("\xff");
  EXPECT_EQ(b.codes(unreadable), "UNSUPPORTED ");
}

TEST(RealismErForce, EachFieldIsOneOfOurKeys) {
  using Message = proto::RealismConfigErForce;
  struct Row {
    const char* field;
    std::function<void(Message&)> fill;
    const char* key;
    double value;
  };
  // 4 robots under 4 cameras; a tick is 16.7 ms. Values that floats hold exactly.
  const std::vector<Row> rows = {
      {"stddev_ball_p", [](Message& m) { m.set_stddev_ball_p(0.03125F); }, "vision.ball_sigma", 0.03125},
      {"stddev_robot_p", [](Message& m) { m.set_stddev_robot_p(0.0625F); }, "vision.robot_sigma", 0.0625},
      {"stddev_robot_phi", [](Message& m) { m.set_stddev_robot_phi(0.25F); }, "vision.orientation_sigma",
       0.25},
      {"stddev_ball_area", [](Message& m) { m.set_stddev_ball_area(6.5F); }, "vision.area_sigma", 6.5},
      {"ball_visibility_threshold",
       [](Message& m) {
         m.set_enable_invisible_ball(true);
         m.set_ball_visibility_threshold(0.75F);
       },
       "vision.visible_share", 0.75},
      {"enable_invisible_ball", [](Message& m) { m.set_enable_invisible_ball(true); }, "vision.visible_share",
       0.4},
      {"camera_overlap", [](Message& m) { m.set_camera_overlap(0.5F); }, "vision.overlap", 0.5},
      {"dribbler_ball_detections", [](Message& m) { m.set_dribbler_ball_detections(0.5F); },
       "vision.false_ball_rate", 0.5},
      {"robot_command_loss", [](Message& m) { m.set_robot_command_loss(0.125F); }, "radio.loss", 0.125},
      {"missing_ball_detections", [](Message& m) { m.set_missing_ball_detections(0.25F); },
       "vision.ball_missing", 0.25},
      {"vision_delay", [](Message& m) { m.set_vision_delay(35'000'000); }, "vision.delay", 2},
      {"object_position_offset", [](Message& m) { m.set_object_position_offset(0.03125F); },
       "vision.bias_sigma", 0.03125},
      {"missing_robot_detections", [](Message& m) { m.set_missing_robot_detections(0.5F); },
       "vision.robot_missing", 0.5},
      {"command_delay", [](Message& m) { m.set_command_delay(50'000'000); }, "radio.latency", 3},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.field);
    Bench b;
    Message message;
    row.fill(message);
    EXPECT_EQ(b.codes(with_realism(message, "RealismConfigErForce")), "");
    engine::Realism expected = engine::realism("none");
    engine::set(expected, row.key, row.value);
    for (const engine::RealismKey& key : engine::realism_keys()) {
      EXPECT_EQ(key.get(realism_in(b)), key.get(expected)) << key.name;
    }
  }
}

TEST(RealismErForce, ANumberIsTheDecimalThatPeopleWrote) {
  Bench b;
  proto::RealismConfigErForce message;
  message.set_robot_command_loss(0.1F);
  EXPECT_EQ(b.codes(with_realism(message, "RealismConfigErForce")), "");
  EXPECT_EQ(realism_in(b).radio.loss, 0.1) << "not 0.10000000149011612";
  message.set_robot_command_loss(1.1F);
  const auto response = b.control(with_realism(message, "RealismConfigErForce"));
  ASSERT_EQ(response.errors_size(), 1);
  EXPECT_EQ(response.errors(0).message(),
            "robot_command_loss: realism radio.loss = 1.1: must be from 0 to 1");
}

TEST(RealismErForce, SaysWhatItCannotFollow) {
  using Message = proto::RealismConfigErForce;
  const auto codes = [](const std::function<void(Message&)>& fill) {
    Bench b;
    Message message;
    fill(message);
    message.set_robot_command_loss(0.5);
    const std::string result = b.codes(with_realism(message, "sslsim.RealismConfigErForce"));
    EXPECT_EQ(realism_in(b).radio.loss, 0.5) << "the rest is done";
    return result;
  };
  EXPECT_EQ(codes([](Message& m) { m.set_camera_position_error(0.1F); }), "UNSUPPORTED ");
  EXPECT_EQ(codes([](Message& m) { m.set_robot_response_loss(0.1F); }), "UNSUPPORTED ");
  EXPECT_EQ(codes([](Message& m) { m.set_vision_processing_time(10'000'000); }), "UNSUPPORTED ");
  EXPECT_EQ(codes([](Message& m) { m.set_simulate_dribbling(false); }), "UNSUPPORTED ");
  EXPECT_EQ(codes([](Message& m) { m.set_stddev_ball_p(-1); }), "INVALID_REALISM ");
  EXPECT_EQ(codes([](Message& m) { m.set_vision_delay(-1'000'000'000); }), "INVALID_REALISM ");
  // Nothing is asked for: no complaint.
  EXPECT_EQ(codes([](Message& m) {
              m.set_camera_position_error(0);
              m.set_robot_response_loss(0);
              m.set_simulate_dribbling(true);
            }),
            "");
}

TEST(VisionPort, IsAPort) {
  Bench b;
  const auto ask = [&](std::uint32_t port) {
    proto::SimulatorCommand command;
    command.mutable_config()->set_vision_port(port);
    return b.codes(command);
  };
  EXPECT_EQ(ask(10006), "");
  EXPECT_EQ(b.server.vision_port(), 10006);
  EXPECT_EQ(ask(0), "INVALID_PORT ");
  EXPECT_EQ(ask(65536), "INVALID_PORT ");
  EXPECT_EQ(b.server.vision_port(), 10006);
}

TEST(Config, IsDoneBeforeControl) {
  Bench b;
  world::Geometry large;
  large.field.length = 12;
  large.field.width = 9;
  proto::SimulatorCommand command = with_geometry(large);
  command.mutable_control()->mutable_teleport_ball()->set_x(6);
  EXPECT_EQ(b.codes(command), "") << "6 m is inside the walls of the new field only";
  EXPECT_EQ(b.ball().position.x(), 6);
}
