#include "sim/wire/robot_control.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <numbers>

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
