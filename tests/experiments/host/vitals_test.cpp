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
    for (int i = 0; i < times; ++i) {
      vitals_.note(commands_, state_);
      vitals_.add(truth_, message_, state_);
    }
  }
  std::string complaint() const { return vitals_.complaint().sentence; }
  std::optional<Team> to_blame() const { return vitals_.complaint().team; }
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
  EXPECT_EQ(complaint(), "");
}

TEST_F(VitalsTest, ARefereeThatGivesNoCommandIsNotHeard) {
  look(100);
  EXPECT_THAT(complaint(), HasSubstr("the referee was not heard"));
}

TEST_F(VitalsTest, AGameThatIsNeverInPlayIsNone) {
  look();
  ++message_.command_counter;
  for (const Team team : world::both_teams) {
    drive(team);
    move(team, 1);
  }
  look(100);
  EXPECT_EQ(complaint(), "the ball was never in play");
}

TEST_F(VitalsTest, ATeamThatCommandsNothingIsNamedThoughItIsPushedAbout) {
  look();
  ++message_.command_counter;
  state_.location = Location::GameOn;
  drive(Team::Blue);
  move(Team::Blue, 1);
  move(Team::Yellow, 1);
  look();
  EXPECT_EQ(complaint(), "never told a robot to move");
  EXPECT_EQ(to_blame(), Team::Yellow);
}

TEST_F(VitalsTest, ATeamWhoseRobotsStayIsNamedThoughItCommands) {
  look();
  ++message_.command_counter;
  state_.location = Location::GameOn;
  drive(Team::Yellow);
  drive(Team::Blue);
  move(Team::Yellow, 1);
  move(Team::Blue, 0.9 * Vitals::least_way);
  look();
  EXPECT_EQ(complaint(), "did not move: no robot came further than 0.27 m");
  EXPECT_EQ(to_blame(), Team::Blue);
}

TEST_F(VitalsTest, WhereNobodyMovesNoTeamIsToBlame) {
  look();
  ++message_.command_counter;
  state_.location = Location::GameOn;
  drive(Team::Blue);
  look(100);
  EXPECT_EQ(complaint(),
            "yellow never told a robot to move, and blue did not move: no robot came further than 0.00 m");
  EXPECT_EQ(to_blame(), std::nullopt);
}

TEST_F(VitalsTest, ATeamThatStandsStillIsNotToBlameWhereTheHarnessIs) {
  drive(Team::Blue);
  look();
  move(Team::Blue, 1);
  look();
  EXPECT_THAT(complaint(), HasSubstr("the referee was not heard"));
  EXPECT_EQ(to_blame(), std::nullopt);
  ++message_.command_counter;
  look();
  EXPECT_EQ(complaint(), "the ball was never in play");
  EXPECT_EQ(to_blame(), std::nullopt);
  message_.command.kind = world::CommandKind::Ready;
  look();
  EXPECT_EQ(to_blame(), Team::Yellow) << "also when nobody took the kick";
  state_.location = Location::GameOn;
  look();
  EXPECT_EQ(to_blame(), Team::Yellow);
  state_.location = Location::GameOff;
  message_.teams.blue.max_robots = 1;
  look(Vitals::longest_miscount + 1);
  EXPECT_THAT(complaint(), HasSubstr("blue had 2 robots on the field"));
  EXPECT_EQ(to_blame(), std::nullopt);
}

TEST_F(VitalsTest, WhatIsOverWithinASecondIsSeen) {
  look();
  ++message_.command_counter;
  for (const Team team : world::both_teams) {
    drive(team);
    move(team, 1);
  }
  state_.location = Location::GameOn;
  vitals_.note(commands_, state_);
  state_.location = Location::GameOff;
  commands_ = {};
  look();
  EXPECT_EQ(complaint(), "");
}

TEST_F(VitalsTest, ARobotTooManyForLongIsNoticed) {
  play();
  state_.location = Location::GameOff;
  message_.teams.blue.max_robots = 1;
  look(Vitals::longest_miscount);
  EXPECT_EQ(complaint(), "");
  look();
  EXPECT_THAT(complaint(), HasSubstr("blue had 2 robots on the field where 1 should be"));
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
  EXPECT_EQ(complaint(), "");
}

TEST_F(VitalsTest, TheLastRobotStaysWhateverTheCards) {
  play();
  state_.location = Location::GameOff;
  std::erase_if(truth_.robots, [](const truth::Robot& robot) {
    return robot.id == world::RobotId{Team::Blue, 2};
  });
  message_.teams.blue.max_robots = 0;
  look(1000);
  EXPECT_EQ(complaint(), "");
}

}  // namespace
}  // namespace host
