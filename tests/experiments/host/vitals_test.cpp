#include "experiments/host/vitals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace host {
namespace {

using testing::HasSubstr;
using world::Location;
using world::Team;

/// Two robots a team, and looks at them once a simulated second.
class VitalsTest : public testing::Test {
 protected:
  VitalsTest() {
    for (const Team team : world::both_teams) {
      message_.teams[team].max_robots = 2;
      for (const std::uint8_t number : {std::uint8_t{1}, std::uint8_t{2}}) {
        truth::Robot robot;
        robot.id = {team, number};
        robot.position = {team == Team::Yellow ? -1.0 : 1.0, number};
        truth_.robots.push_back(robot);
      }
    }
    state_.location = Location::GameOff;
  }
  void look(int times = 1) {
    for (int i = 0; i < times; ++i) vitals_.add(truth_, commands_, message_, state_);
  }
  void drive(Team team) {
    world::RobotCommand command;
    command.number = 1;
    command.velocity_local = {1, 0};
    commands_[team] = {command};
  }
  void move(Team team, double metres) {
    for (truth::Robot& robot : truth_.robots) {
      if (robot.id.team == team) robot.position.x() += metres;
    }
  }
  /// A game as it should be, up to the look after it.
  void play() {
    look();
    ++message_.command_counter;
    state_.location = Location::GameOn;
    for (const Team team : world::both_teams) {
      drive(team);
      move(team, 0.5);
    }
    look();
  }

  truth::Frame truth_;
  world::PerTeam<world::TeamCommands> commands_;
  world::RefereeMessage message_;
  world::GameState state_;
  Vitals vitals_;
};

TEST_F(VitalsTest, AGameHasNothingToComplainOf) {
  play();
  EXPECT_EQ(vitals_.complaint(), "");
}

TEST_F(VitalsTest, ARefereeThatGivesNoCommandIsNotHeard) {
  look(100);
  EXPECT_THAT(vitals_.complaint(), HasSubstr("the referee was not heard"));
}

TEST_F(VitalsTest, AGameThatIsNeverInPlayIsNone) {
  look();
  ++message_.command_counter;
  for (const Team team : world::both_teams) {
    drive(team);
    move(team, 1);
  }
  look(100);
  EXPECT_EQ(vitals_.complaint(), "the ball was never in play");
}

TEST_F(VitalsTest, ATeamThatCommandsNothingIsNamedThoughItIsPushedAbout) {
  look();
  ++message_.command_counter;
  state_.location = Location::GameOn;
  drive(Team::Blue);
  move(Team::Blue, 1);
  move(Team::Yellow, 1);
  look();
  EXPECT_EQ(vitals_.complaint(), "yellow never told a robot to move");
}

TEST_F(VitalsTest, ATeamWhoseRobotsStayIsNamedThoughItCommands) {
  play();
  Vitals other;
  std::swap(vitals_, other);
  commands_ = {};
  look();
  ++message_.command_counter;
  drive(Team::Yellow);
  drive(Team::Blue);
  move(Team::Yellow, 1);
  move(Team::Blue, 0.9 * Vitals::least_way);
  look();
  EXPECT_EQ(vitals_.complaint(), "blue did not move: no robot came further than 0.27 m");
}

TEST_F(VitalsTest, ARobotTooManyForLongIsNoticed) {
  play();
  state_.location = Location::GameOff;
  message_.teams.blue.max_robots = 1;
  look(Vitals::longest_miscount);
  EXPECT_EQ(vitals_.complaint(), "");
  look();
  EXPECT_THAT(vitals_.complaint(), HasSubstr("blue had 2 robots on the field where 1 should be"));
}

TEST_F(VitalsTest, ACardTakesEffectAtTheNextStopAndThatIsInOrder) {
  play();
  message_.teams.blue.max_robots = 1;
  look(1000);  // in play
  state_.location = Location::GameOff;
  look(Vitals::longest_miscount);
  std::erase_if(truth_.robots, [](const truth::Robot& robot) {
    return robot.id == world::RobotId{Team::Blue, 2};
  });
  look(1000);
  EXPECT_EQ(vitals_.complaint(), "");
}

TEST_F(VitalsTest, TheLastRobotStaysWhateverTheCards) {
  play();
  state_.location = Location::GameOff;
  std::erase_if(truth_.robots, [](const truth::Robot& robot) {
    return robot.id == world::RobotId{Team::Blue, 2};
  });
  message_.teams.blue.max_robots = 0;
  look(1000);
  EXPECT_EQ(vitals_.complaint(), "");
}

}  // namespace
}  // namespace host
