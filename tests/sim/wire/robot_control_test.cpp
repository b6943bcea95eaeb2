#include "sim/wire/robot_control.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <numbers>

#include "sim/proto/simulation_custom.pb.h"
#include "sim/world/random.h"
#include "tests/sim/wire/allocations.h"
#include "tests/sim/wire/league_schema.h"

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using wire::proto::RobotControl;

const std::string family = "ssl-simulation-protocol HEAD";
const float nan_value = std::numeric_limits<float>::quiet_NaN();
const float infinity = std::numeric_limits<float>::infinity();

RobotControl encoded(const world::TeamCommands& commands) {
  RobotControl control;
  wire::encode(commands, control);
  return control;
}

/// A good command of robot 1 spoilt in one place.
int bad_commands_after(const std::function<void(wire::proto::RobotCommand&)>& spoil) {
  RobotControl control = encoded({{.number = 1, .velocity_local = {1, 2}, .kick_speed = 3}, {.number = 2}});
  spoil(*control.mutable_robot_commands(0));
  int bad = 0;
  const world::TeamCommands commands = wire::decode(control, bad);
  EXPECT_EQ(commands.size() + static_cast<std::size_t>(bad), 2U);
  EXPECT_EQ(commands.back().number, 2) << "the others are obeyed";
  return bad;
}

}  // namespace

TEST(RobotControl, TravelsInDegreesAndRpm) {
  const RobotControl control = encoded({{.number = 4,
                                         .velocity_local = {1.5, -0.5},
                                         .angular_velocity = 2,
                                         .kick_speed = 6,
                                         .kick_angle = std::numbers::pi / 4,
                                         .dribbler_speed = 100 * std::numbers::pi}});
  ASSERT_EQ(control.robot_commands_size(), 1);
  const wire::proto::RobotCommand& command = control.robot_commands(0);
  EXPECT_EQ(command.id(), 4U);
  EXPECT_EQ(command.move_command().local_velocity().forward(), 1.5F);
  EXPECT_EQ(command.move_command().local_velocity().left(), -0.5F);
  EXPECT_EQ(command.move_command().local_velocity().angular(), 2.0F);
  EXPECT_EQ(command.kick_speed(), 6.0F);
  EXPECT_FLOAT_EQ(command.kick_angle(), 45.0F);
  EXPECT_FLOAT_EQ(command.dribbler_speed(), 3000.0F);  // 100 pi rad/s are 50 turns a second
  EXPECT_THAT(league::missing_required(control, family), IsEmpty());
}

TEST(RobotControl, ASecondTripChangesNothing) {
  world::RandomStream random(1, "commands");
  for (int i = 0; i < 10'000; ++i) {
    const RobotControl first =
        encoded({{.number = static_cast<std::uint8_t>(random.below(16)),
                  .velocity_local = {6 * random.uniform() - 3, 6 * random.uniform() - 3},
                  .angular_velocity = 20 * random.uniform(),
                  .kick_speed = 8 * random.uniform(),
                  .kick_angle = random.uniform(),
                  .dribbler_speed = 500 * random.uniform()}});
    int bad = 0;
    ASSERT_EQ(encoded(wire::decode(first, bad)).SerializeAsString(), first.SerializeAsString());
    ASSERT_EQ(bad, 0);
  }
}

TEST(RobotControl, NoMoveCommandMeansStandingStill) {
  RobotControl control;
  control.add_robot_commands()->set_id(5);
  control.mutable_robot_commands(0)->set_kick_speed(4);
  int bad = 0;
  const world::TeamCommands commands = wire::decode(control, bad);
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(bad, 0);
  EXPECT_EQ(commands[0].velocity_local, world::Vector2d::Zero());
  EXPECT_EQ(commands[0].kick_speed, 4);
}

TEST(RobotControl, LeavesOutAndCountsBadCommands) {
  using Command = wire::proto::RobotCommand;
  EXPECT_EQ(bad_commands_after([](Command&) {}), 0);
  EXPECT_EQ(bad_commands_after([](Command& c) { c.clear_id(); }), 1);
  EXPECT_EQ(bad_commands_after([](Command& c) { c.set_id(16); }), 1);
  EXPECT_EQ(bad_commands_after([](Command& c) { c.set_id(4'000'000'000U); }), 1);
  for (const float value : {nan_value, infinity, -infinity, 1e9F}) {
    EXPECT_EQ(bad_commands_after(
                  [&](Command& c) { c.mutable_move_command()->mutable_local_velocity()->set_left(value); }),
              1);
    EXPECT_EQ(bad_commands_after([&](Command& c) {
                c.mutable_move_command()->mutable_local_velocity()->set_angular(value);
              }),
              1);
    EXPECT_EQ(bad_commands_after([&](Command& c) { c.set_kick_speed(value); }), 1);
    EXPECT_EQ(bad_commands_after([&](Command& c) { c.set_kick_angle(value); }), 1);
    EXPECT_EQ(bad_commands_after([&](Command& c) { c.set_dribbler_speed(value); }), 1);
  }
  EXPECT_EQ(bad_commands_after([](Command& c) { c.set_kick_speed(-1); }), 1);
  EXPECT_EQ(bad_commands_after([](Command& c) { c.set_kick_angle(-10); }), 1);
  EXPECT_EQ(bad_commands_after([](Command& c) { c.mutable_move_command()->mutable_wheel_velocity(); }), 1);
  EXPECT_EQ(bad_commands_after([](Command& c) { c.mutable_move_command()->mutable_global_velocity(); }), 1);
}

TEST(RobotControl, TheFirstOfTwoCommandsForOneRobotCounts) {
  RobotControl control = encoded({{.number = 1, .kick_speed = 1}, {.number = 1, .kick_speed = 2}});
  int bad = 0;
  const world::TeamCommands commands = wire::decode(control, bad);
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(commands[0].kick_speed, 1);
  EXPECT_EQ(bad, 1);
}

TEST(RobotControl, DecodingReusesMemory) {
  world::TeamCommands commands;
  for (std::uint8_t number = 0; number < 6; ++number) commands.push_back({.number = number, .kick_speed = 1});
  const RobotControl control = encoded(commands);
  world::TeamCommands out;
  int bad = 0;
  wire::decode(control, out, bad);
  const std::size_t before = allocations();
  wire::decode(control, out, bad);
  EXPECT_EQ(allocations(), before);
  EXPECT_EQ(out.size(), 6U);
}

TEST(RobotOrder, KeepsAllThreeWaysToMoveAsTheyAre) {
  wire::proto::RobotCommand command;
  command.set_id(7);
  command.set_kick_speed(5);
  auto& global = *command.mutable_move_command()->mutable_global_velocity();
  global.set_x(1);
  global.set_y(-2);
  global.set_angular(3);
  auto result = wire::decode_order(command);
  const auto* order = std::get_if<wire::RobotOrder>(&result);
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(order->command.number, 7);
  EXPECT_EQ(order->command.kick_speed, 5);
  const auto* in_field = std::get_if<wire::GlobalVelocity>(&order->move);
  ASSERT_NE(in_field, nullptr);
  EXPECT_EQ(in_field->velocity, world::Vector2d(1, -2));
  EXPECT_EQ(in_field->angular_velocity, 3);

  auto& wheels = *command.mutable_move_command()->mutable_wheel_velocity();
  wheels.set_front_right(1);
  wheels.set_back_right(2);
  wheels.set_back_left(3);
  wheels.set_front_left(4);
  result = wire::decode_order(command);
  order = std::get_if<wire::RobotOrder>(&result);
  ASSERT_NE(order, nullptr);
  const auto* rims = std::get_if<wire::WheelSpeeds>(&order->move);
  ASSERT_NE(rims, nullptr);
  EXPECT_EQ(rims->front_right, 1);
  EXPECT_EQ(rims->back_right, 2);
  EXPECT_EQ(rims->back_left, 3);
  EXPECT_EQ(rims->front_left, 4);
}

TEST(RobotOrder, SaysWhatIsWrong) {
  const auto problem_of = [](const std::function<void(wire::proto::RobotCommand&)>& spoil) {
    wire::proto::RobotCommand command;
    command.set_id(2);
    spoil(command);
    const auto result = wire::decode_order(command);
    const auto* problem = std::get_if<wire::Problem>(&result);
    return problem ? std::string(problem->code) + ": " + problem->message : "";
  };
  using Command = wire::proto::RobotCommand;
  EXPECT_EQ(problem_of([](Command&) {}), "");
  EXPECT_EQ(problem_of([](Command& c) { c.clear_id(); }), "ROBOT_ID: a robot command has no id");
  EXPECT_EQ(problem_of([](Command& c) { c.set_id(16); }), "ROBOT_ID: robot 16: numbers go from 0 to 15");
  EXPECT_EQ(problem_of([](Command& c) { c.set_kick_angle(91); }),
            "INVALID_VALUE: robot 2: kick_angle = 91 must be from 0 to 90");
  EXPECT_EQ(problem_of([](Command& c) { c.mutable_move_command()->mutable_global_velocity()->set_y(-101); }),
            "INVALID_VALUE: robot 2: y = -101 must be from -100 to 100");
  EXPECT_EQ(problem_of([](Command& c) {
              c.mutable_move_command()->mutable_wheel_velocity()->set_back_left(nan_value);
            }),
            "INVALID_VALUE: robot 2: back_left = nan must be from -100 to 100");
}

TEST(RobotSpecs, BringEveryLimitAlong) {
  // Different numbers everywhere, all of them exact as floats.
  const world::RobotSpecs specs = {.id = {world::Team::Yellow, 3},
                                   .radius = 0.0625,
                                   .height = 0.125,
                                   .mass = 2.25,
                                   .center_to_dribbler = 0.046875,
                                   .dribbler_width = 0.03125,
                                   .max_speed = 1,
                                   .max_speed_sideways = 2,
                                   .max_acceleration = 3,
                                   .max_acceleration_sideways = 4,
                                   .max_brake = 5,
                                   .max_brake_sideways = 6,
                                   .max_angular_speed = 7,
                                   .max_angular_acceleration = 8,
                                   .max_angular_brake = 9,
                                   .max_kick_speed = 6.5,
                                   .max_chip_speed = 5.5};
  wire::proto::RobotSpecs message;
  wire::encode(specs, message);
  const auto back = wire::decode(message);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->id, specs.id);
  EXPECT_EQ(back->radius, specs.radius);
  EXPECT_EQ(back->height, specs.height);
  EXPECT_EQ(back->mass, specs.mass);
  EXPECT_EQ(back->center_to_dribbler, specs.center_to_dribbler);
  EXPECT_EQ(back->dribbler_width, specs.dribbler_width);
  EXPECT_EQ(back->max_speed, specs.max_speed);
  EXPECT_EQ(back->max_speed_sideways, specs.max_speed_sideways);
  EXPECT_EQ(back->max_acceleration, specs.max_acceleration);
  EXPECT_EQ(back->max_acceleration_sideways, specs.max_acceleration_sideways);
  EXPECT_EQ(back->max_brake, specs.max_brake);
  EXPECT_EQ(back->max_brake_sideways, specs.max_brake_sideways);
  EXPECT_EQ(back->max_angular_speed, specs.max_angular_speed);
  EXPECT_EQ(back->max_angular_acceleration, specs.max_angular_acceleration);
  EXPECT_EQ(back->max_angular_brake, specs.max_angular_brake);
  EXPECT_EQ(back->max_kick_speed, specs.max_kick_speed);
  EXPECT_EQ(back->max_chip_speed, specs.max_chip_speed);
}

TEST(RobotSpecs, WithTheLeaguesFieldsOnlySidewaysIsAsForward) {
  wire::proto::RobotSpecs message;
  message.mutable_id()->set_id(1);
  message.mutable_id()->set_team(matchday::simulation::BLUE);
  message.mutable_limits()->set_vel_absolute_max(1.5);
  message.mutable_limits()->set_acc_speedup_absolute_max(2.5);
  message.mutable_limits()->set_acc_brake_absolute_max(3.5);
  const auto specs = wire::decode(message);
  ASSERT_TRUE(specs);
  EXPECT_EQ(specs->max_speed_sideways, 1.5);
  EXPECT_EQ(specs->max_acceleration_sideways, 2.5);
  EXPECT_EQ(specs->max_brake_sideways, 3.5);
  EXPECT_EQ(specs->max_angular_brake, world::RobotSpecs{}.max_angular_brake);
}

TEST(RobotSpecs, ApplyingChangesOnlyWhatIsSaid) {
  world::RobotSpecs specs;
  specs.max_speed_sideways = 1;
  wire::WheelAngles wheels;
  wire::proto::RobotSpecs message;
  message.set_mass(2);
  EXPECT_THAT(wire::apply(message, specs, wheels), IsEmpty());
  EXPECT_EQ(specs.mass, 2);
  EXPECT_EQ(specs.max_speed, 3);
  EXPECT_EQ(specs.max_speed_sideways, 1);
  EXPECT_EQ(wheels.front_right, wire::WheelAngles{}.front_right);

  auto& angles = *message.mutable_wheel_angles();
  angles.set_front_right(0.5F);
  angles.set_back_right(2);
  angles.set_back_left(4);
  angles.set_front_left(5.5F);
  EXPECT_THAT(wire::apply(message, specs, wheels), IsEmpty());
  EXPECT_EQ(wheels.front_right, 0.5);
  EXPECT_EQ(wheels.back_right, 2);
  EXPECT_EQ(wheels.back_left, 4);
  EXPECT_EQ(wheels.front_left, 5.5);
}

TEST(RobotSpecs, NamesBadFieldsAndPayloadsOfOthers) {
  world::RobotSpecs specs;
  wire::WheelAngles wheels;
  const auto codes = [&](const std::function<void(wire::proto::RobotSpecs&)>& fill) {
    wire::proto::RobotSpecs message;
    fill(message);
    std::string result;
    for (const wire::Problem& problem : wire::apply(message, specs, wheels)) {
      result += std::string(problem.code) + " ";
    }
    return result;
  };
  using Specs = wire::proto::RobotSpecs;
  EXPECT_EQ(codes([](Specs& s) { s.set_radius(-1); }), "INVALID_SPEC ");
  EXPECT_EQ(codes([](Specs& s) { s.mutable_limits()->set_vel_angular_max(infinity); }), "INVALID_SPEC ");
  EXPECT_EQ(codes([](Specs& s) { s.mutable_wheel_angles()->set_back_left(1); }), "INVALID_SPEC ");
  EXPECT_EQ(codes([](Specs& s) { s.add_custom()->set_type_url("x/sslsim.RobotSpecOthers"); }),
            "UNSUPPORTED ");
  EXPECT_EQ(codes([](Specs& s) {
              s.add_custom()->set_type_url("type.googleapis.com/sslsim.RobotSpecErForce");
              s.mutable_custom(0)->set_value("\xff");
            }),
            "UNSUPPORTED ");
  EXPECT_EQ(specs.radius, world::RobotSpecs{}.radius);

  // The league's copy has no package, ER-Force's program has one; both are meant.
  for (const char* url :
       {"type.googleapis.com/sslsim.RobotSpecErForce", "type.googleapis.com/RobotSpecErForce"}) {
    matchday::simulation::RobotSpecErForce theirs;
    theirs.set_dribbler_width(0.0625);
    EXPECT_EQ(codes([&](Specs& s) {
                s.add_custom()->set_type_url(url);
                s.mutable_custom(0)->set_value(theirs.SerializeAsString());
              }),
              "");
    EXPECT_EQ(specs.dribbler_width, 0.0625);
    theirs.set_shoot_radius(0.1F);
    EXPECT_EQ(codes([&](Specs& s) {
                s.add_custom()->set_type_url(url);
                s.mutable_custom(0)->set_value(theirs.SerializeAsString());
              }),
              "UNSUPPORTED ");
  }
}

TEST(RobotSpecs, ComeBackAsFloats) {
  world::RobotSpecs specs;
  specs.id = {world::Team::Blue, 11};
  specs = world::slowed(specs, 0.5);
  wire::proto::RobotSpecs message;
  wire::encode(specs, message);
  EXPECT_THAT(league::missing_required(message, family), IsEmpty());
  const std::optional<world::RobotSpecs> back = wire::decode(message);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->id, specs.id);
  EXPECT_EQ(back->max_speed, 1.5);  // a float holds it exactly
  EXPECT_EQ(back->max_acceleration, 1.5);
  EXPECT_EQ(back->max_brake, 3.0);
  EXPECT_FLOAT_EQ(static_cast<float>(back->radius), 0.09F);
  EXPECT_FLOAT_EQ(static_cast<float>(back->center_to_dribbler), 0.073F);
  wire::proto::RobotSpecs again;
  wire::encode(*back, again);
  EXPECT_EQ(again.SerializeAsString(), message.SerializeAsString());
}

TEST(RobotSpecs, NeedATeamAndANumber) {
  wire::proto::RobotSpecs message;
  EXPECT_FALSE(wire::decode(message).has_value());
  message.mutable_id()->set_id(3);
  EXPECT_FALSE(wire::decode(message).has_value());
  message.mutable_id()->set_team(matchday::simulation::YELLOW);
  message.set_mass(nan_value);
  message.mutable_limits()->set_vel_absolute_max(-1);
  const std::optional<world::RobotSpecs> specs = wire::decode(message);
  ASSERT_TRUE(specs.has_value());
  EXPECT_EQ(specs->mass, world::RobotSpecs{}.mass);
  EXPECT_EQ(specs->max_speed, world::RobotSpecs{}.max_speed);
  EXPECT_EQ(specs->radius, world::RobotSpecs{}.radius);
}

TEST(Feedback, ComesBackBesideErrors) {
  const std::vector<wire::Feedback> sent = {{0, false}, {15, true}};
  wire::proto::RobotControlResponse response;
  wire::add_error("REFUSED", "no time-out left", response);
  wire::encode(sent, response);
  wire::encode(sent, response);
  EXPECT_EQ(wire::decode(response), sent);
  ASSERT_EQ(response.errors_size(), 1);
  EXPECT_EQ(response.errors(0).code(), "REFUSED");
  EXPECT_THAT(league::missing_required(response, family), IsEmpty());
  response.add_feedback()->set_id(16);
  EXPECT_EQ(wire::decode(response), sent);
}
