// One test per row of the paper's Tables 10 to 18: command, new location, what changes,
// and that nothing else does.
#include "tests/autoref/automaton/rows.h"

#include <set>

#include "autoref/automaton/transitions.h"

namespace automaton {
namespace {

TEST_F(Rows, T10BeginsTheMatch) {
  GameState& state = given(Location::Init);
  state.first_kickoff = Team::Blue;
  state.stage = Stage::Post;
  state.kicker = yellow_3;
  state.goal_allowed = false;
  expect("T10", Command{Stop}, Location::GameOff, {}, [](GameState& s) {
    next(s, Kickoff, Team::Blue, {0, 0});
    s.stage = Stage::PreFirst;
    s.kicker.reset();
    s.goal_allowed = true;
  });
}

TEST_F(Rows, T11_1GoalIsAKickoffForTheTeamThatConceded) {
  expect("T11.1", Command{Goal, Team::Yellow}, Location::GameOff,
         {seen(world::PossibleGoal{Team::Blue, {}, {4.52, 0}})}, [](GameState& s) {
           next(s, Kickoff, Team::Blue, {0, 0});
           s.score.yellow = 1;
         });
}

TEST_F(Rows, T11_2StuckBallIsANeutralStart) {
  expect("T11.2", Command{Stop}, Location::GameOff, {seen(world::NoProgressInGame{{1.5, -2}, 12s})},
         [](GameState& s) {
           next(s, Start, s.kick_team, {1.5, -2});
         });
}

TEST_F(Rows, T11_3MinorFoulIsAnIndirectFreeKick) {
  expect("T11.3", Command{Stop}, Location::GameOff,
         {seen(world::BotDribbledBallTooFar{yellow_3, {0, 0}, {1, 0}})}, [](GameState& s) {
           next(s, Indirect, Team::Blue, {1, 0});
         });
}

TEST_F(Rows, T11_3TooFastBallIsKickedFromWhereItWasKicked) {
  expect("T11.3", Command{Stop}, Location::GameOff, {seen(world::BotKickedBallTooFast{blue_2, {-1, 2}, 9})},
         [](GameState& s) {
           next(s, Indirect, Team::Yellow, {-1, 2});
         });
}

TEST_F(Rows, T11_4SeriousFoulIsADirectFreeKick) {
  expect("T11.4", Command{Stop}, Location::GameOff,
         {{std::nullopt, Foul{blue_2, {1, 0}, Severity::Serious}, {}}}, [](GameState& s) {
           next(s, Direct, Team::Yellow, {1, 0});
         });
}

TEST_F(Rows, T11_5SeriousFoulInOwnAreaIsAPenalty) {
  expect("T11.5", Command{Stop}, Location::GameOff,
         {{std::nullopt, Foul{blue_2, {4.2, 0}, Severity::Serious}, {}}}, [](GameState& s) {
           next(s, Penalty, Team::Yellow, {3.5, 0});
         });
}

TEST_F(Rows, T11_6DoubleTouchIsAnIndirectFreeKick) {
  given(Location::GameOn).kicker = yellow_3;
  expect("T11.6", Command{Stop}, Location::GameOff,
         {seen(world::AttackerDoubleTouchedBall{yellow_3, {0.5, 1}})}, [](GameState& s) {
           next(s, Indirect, Team::Blue, {0.5, 1});
         });
}

TEST_F(Rows, T11_7TouchLineIsAnIndirectFreeKickFromInside) {
  expect("T11.7", Command{Stop}, Location::GameOff, {seen(world::BallLeftFieldTouchLine{{}, {1.2, 3.0215}})},
         [](GameState& s) {
           next(s, Indirect, Team::Yellow, {1.2, 2.9});
         });
}

TEST_F(Rows, T11_7GoalLineAfterTheDefenderIsACorner) {
  expect("T11.7", Command{Stop}, Location::GameOff, {seen(world::BallLeftFieldGoalLine{{}, {4.5215, -1}})},
         [](GameState& s) {
           next(s, Direct, Team::Yellow, {4.4, -2.9});
         });
}

TEST_F(Rows, T11_7GoalLineAfterTheAttackerIsAGoalKick) {
  expect("T11.7", Command{Stop}, Location::GameOff, {seen(world::BallLeftFieldGoalLine{{}, {-4.5215, 1}})},
         [](GameState& s) {
           next(s, Direct, Team::Yellow, {-4.0, 2.9});
         });
}

TEST_F(Rows, T11_7GoalStraightFromAnIndirectKickIsAnExit) {
  given(Location::GameOn).goal_allowed = false;
  expect("T11.7", Command{Stop}, Location::GameOff,
         {seen(world::PossibleGoal{Team::Yellow, {}, {-4.5215, 0.2}})}, [](GameState& s) {
           next(s, Direct, Team::Yellow, {-4.0, 2.9});
         });
}

TEST_F(Rows, T12_1ReadyBeforeAHalfBeginsIt) {
  GameState& state = given(Location::GameOff);
  state.call = Ready;
  state.stage = Stage::PreSecond;
  state.stage_end.reset();
  state.goal_allowed = false;
  expect("T12.1", Command{Ready}, Location::Setup, {seen(world::RobotsSettled{})}, [](GameState& s) {
    s.stage = Stage::Second;
    s.stage_end = now + 10min;
    s.goal_allowed = true;
    s.kick_deadline = now + 10s;
    s.kick_position = Vector2d{1.5, -2.0};
  });
}

TEST_F(Rows, T12_2ReadyInAHalf) {
  given(Location::GameOff).call = Ready;
  automaton_.state().goal_allowed = false;
  expect("T12.2", Command{Ready}, Location::Setup, {seen(world::RobotsSettled{})}, [](GameState& s) {
    s.goal_allowed = true;
    s.kick_deadline = now + 10s;
    s.kick_position = Vector2d{1.5, -2.0};
  });
}

TEST_F(Rows, T12_3DirectAllowsAGoal) {
  given(Location::GameOff).call = Direct;
  automaton_.state().goal_allowed = false;
  automaton_.state().kick_team = Team::Blue;
  expect("T12.3", Command{Direct, Team::Blue}, Location::Setup, {seen(world::RobotsSettled{})},
         [](GameState& s) {
           s.goal_allowed = true;
           s.kick_deadline = now + 10s;
           s.kick_position = Vector2d{1.5, -2.0};
         });
}

TEST_F(Rows, T12_4IndirectAllowsNoGoal) {
  given(Location::GameOff).call = Indirect;
  expect("T12.4", Command{Indirect, Team::Yellow}, Location::Setup, {seen(world::RobotsSettled{})},
         [](GameState& s) {
           s.goal_allowed = false;
           s.kick_deadline = now + 10s;
           s.kick_position = Vector2d{1.5, -2.0};
         });
}

TEST_F(Rows, I1NeutralStart) {
  GameState& state = given(Location::GameOff);
  state.call = Start;
  state.goal_allowed = false;
  state.kicker = yellow_3;
  state.is_kickoff = true;
  expect("I-1", Command{Start}, Location::GameOn, {seen(world::RobotsSettled{})}, [](GameState& s) {
    s.goal_allowed = true;
    s.kicker.reset();
    s.is_kickoff = false;
  });
}

TEST_F(Rows, T13KickTaken) {
  given(Location::Setup).is_kickoff = true;
  expect("T13", std::nullopt, Location::GameOn, {seen(world::KickTaken{yellow_3, {0, 0}, {}, {}, {}})},
         [](GameState& s) {
           s.kicker = yellow_3;
           s.touch_team = Team::Yellow;
           s.last_touch = world::Touch{yellow_3, now, {0, 0}, 1.0};
           s.is_kickoff = false;
         });
}

TEST_F(Rows, T14AnotherRobotTouches) {
  GameState& state = given(Location::GameOn);
  state.kicker = blue_2;
  state.goal_allowed = false;
  const world::Touch touch{yellow_3, now, {2, 2}, 1.0};
  expect(
      "T14", std::nullopt, Location::GameOn, {seen(world::BallTouched{touch})},
      [&](GameState& s) {
        s.kicker.reset();
        s.goal_allowed = true;
        s.touch_team = Team::Yellow;
        s.last_touch = touch;
      },
      false);
}

TEST_F(Rows, T14IsNotForTheKickerItself) {
  given(Location::GameOn).kicker = yellow_3;
  const std::vector<Occurrence> touch = {seen(world::BallTouched{{yellow_3, now, {2, 2}, 1.0}})};
  EXPECT_TRUE(automaton_.take(frame_, touch).empty());
}

TEST_F(Rows, T15_aAnnouncesTheKickoff) {
  given(Location::GameOff).call = Kickoff;
  expect("T15.a", Command{Kickoff, Team::Yellow}, Location::GameOff, {seen(world::RobotsSettled{})},
         [](GameState& s) { s.call = Ready; });
}

TEST_F(Rows, T15_aAnnouncesThePenalty) {
  given(Location::GameOff).call = Penalty;
  expect("T15.a", Command{Penalty, Team::Yellow}, Location::GameOff, {seen(world::RobotsSettled{})},
         [](GameState& s) { s.call = Ready; });
}

TEST_F(Rows, T15_bRemovesTheCardThatRanOut) {
  given(Location::GameOff).yellow_times.blue = {5s, -1ns, 90s};
  expect(
      "T15.b", std::nullopt, Location::GameOff, {},
      [](GameState& s) {
        s.yellow_times.blue = {5s, 90s};
      },
      false);
}

TEST_F(Rows, T16_aEndsTheFirstHalf) {
  given(Location::GameOff).stage_end = now - 1ns;
  expect("T16.a", Command{Halt}, Location::Break, {}, [](GameState& s) {
    s.stage = Stage::HalfTime;
    s.stage_end = now;
  });
}

TEST_F(Rows, T16_aEndsTheGame) {
  GameState& state = given(Location::GameOff);
  state.stage = Stage::Second;
  state.stage_end = now - 1ns;
  expect("T16.a", Command{Halt}, Location::Break, {}, [](GameState& s) {
    s.stage = Stage::Post;
    s.stage_end.reset();
  });
}

TEST_F(Rows, T16_bGrantsATimeout) {
  given(Location::GameOff);
  expect("T16.b", Command{Timeout, Team::Blue}, Location::Break,
         {request(Request::Kind::BeginTimeout, Team::Blue)}, [](GameState& s) {
           s.timeout_team = Team::Blue;
           s.timeout_num.blue = 3;
         });
}

TEST_F(Rows, T16_bRefusesWhenNoneIsLeft) {
  given(Location::GameOff).timeout_num.blue = 0;
  const std::vector<Occurrence> wish = {request(Request::Kind::BeginTimeout, Team::Blue)};
  EXPECT_TRUE(automaton_.take(frame_, wish).empty());
}

TEST_F(Rows, T17_aBeginsTheSecondHalfWithEndsChanged) {
  GameState& state = given(Location::Break);
  state.stage = Stage::HalfTime;
  state.stage_end = now - 1ns;
  expect("T17.a", Command{Kickoff, Team::Blue}, Location::GameOff, {}, [](GameState& s) {
    next(s, Kickoff, Team::Blue, {0, 0});
    s.call = Ready;
    s.stage = Stage::PreSecond;
    s.stage_end.reset();
    s.blue_on_positive_half = false;
  });
}

TEST_F(Rows, T17_bEndsATimeoutThatIsUsedUp) {
  GameState& state = given(Location::Break);
  state.timeout_team = Team::Yellow;
  state.timeout_time.yellow = 0s;
  state.restart = Direct;
  expect("T17.b", Command{Stop}, Location::GameOff, {}, [](GameState& s) {
    s.timeout_team.reset();
    s.call = Direct;
  });
}

TEST_F(Rows, T17_cEndsATimeoutOnRequest) {
  GameState& state = given(Location::Break);
  state.timeout_team = Team::Yellow;
  state.restart = Kickoff;
  expect("T17.c", Command{Stop}, Location::GameOff, {request(Request::Kind::EndTimeout, Team::Yellow)},
         [](GameState& s) {
           s.timeout_team.reset();
           s.call = Kickoff;
         });
}

TEST_F(Rows, T17_cIsForTheTeamThatCalledIt) {
  given(Location::Break).timeout_team = Team::Yellow;
  const std::vector<Occurrence> wish = {request(Request::Kind::EndTimeout, Team::Blue)};
  EXPECT_TRUE(automaton_.take(frame_, wish).empty());
}

TEST_F(Rows, PostIsTheEnd) {
  given(Location::Break).stage = Stage::Post;
  automaton_.state().stage_end.reset();
  frame_.time = now + 1000s;
  EXPECT_TRUE(automaton_.take(frame_, {}).empty());
}

TEST_F(Rows, T18_aLateKickIsANeutralStart) {
  given(Location::Setup).kick_deadline = now - 1ns;
  expect("T18.a", Command{Stop}, Location::GameOff, {}, [](GameState& s) {
    next(s, Start, Team::Yellow, {1.5, -2});
  });
}

TEST_F(Rows, T18_bTeamMateNearTheAreaGivesTheKickAway) {
  given(Location::Setup);
  expect("T18.b", Command{Stop}, Location::GameOff,
         {seen(world::KickTaken{yellow_3, {1, 1}, yellow_3, {}, {}})}, [](GameState& s) {
           next(s, Indirect, Team::Blue, {1, 1});
         });
}

TEST_F(Rows, T18_cOpponentNearTheBallMeansAgain) {
  given(Location::Setup).restart = Direct;
  expect("T18.c", Command{Stop}, Location::GameOff,
         {seen(world::KickTaken{yellow_3, {1, 1}, {}, blue_2, {}})}, [](GameState& s) { s.call = Direct; });
}

TEST_F(Rows, T18_dWrongHalfMeansTheKickoffAgain) {
  GameState& state = given(Location::Setup);
  state.restart = Kickoff;
  state.call = Ready;
  state.is_kickoff = true;
  expect("T18.d", Command{Stop}, Location::GameOff,
         {seen(world::KickTaken{yellow_3, {0, 0}, {}, {}, blue_2})}, [](GameState& s) { s.call = Kickoff; });
}

TEST_F(Rows, I18AnOverdueHalfIsStoppedAndEnded) {
  for (const Location location : {Location::GameOn, Location::Setup}) {
    GameState& state = given(location);
    state.stage = Stage::First;
    state.stage_end = now - 60s - 1ns;
    const auto taken = automaton_.take(frame_, {});
    ASSERT_EQ(taken.size(), 2u);
    EXPECT_EQ(taken[0].row->name, location == Location::GameOn ? "I-18.on" : "I-18.setup");
    EXPECT_EQ(taken[1].row->name, "T16.a");
  }
}

TEST(PaperRows, T18_cIsAlwaysIndirectAsPrinted) {
  Automaton automaton(world::rule_set("paper"), {});
  automaton.state().location = Location::Setup;
  automaton.state().restart = Kickoff;
  automaton.state().is_kickoff = true;
  world::TrackedFrame frame;
  frame.time = now;
  const std::vector<Occurrence> kick = {seen(world::KickTaken{yellow_3, {0, 0}, {}, blue_2, {}})};
  automaton.take(frame, kick);
  EXPECT_EQ(automaton.state().call, Indirect);
  EXPECT_FALSE(automaton.state().is_kickoff);
}

// R-6.4-2: a touch, the exit it explains, and the end of the half that was waiting for a
// stoppage, in one tick.
TEST_F(Rows, ThreeTransitionsHappenInOneTick) {
  given(Location::GameOn).stage_end = now - 1s;
  const std::vector<Occurrence> what = {seen(world::BallLeftFieldTouchLine{{}, {1, 3.0215}}),
                                        seen(world::BallTouched{{yellow_3, now, {1, 2.9}, 1.0}})};
  const auto taken = automaton_.take(frame_, what);
  ASSERT_EQ(taken.size(), 3u);
  EXPECT_EQ(taken[0].row->name, "T14");  // first, although it was reported second
  EXPECT_EQ(taken[1].row->name, "T11.7");
  EXPECT_EQ(taken[1].after.kick_team, Team::Blue);
  EXPECT_EQ(taken[2].row->name, "T16.a");
  EXPECT_EQ(automaton_.loop_defects(), 0);
}

// R-6.2-7: the edges of Figure 6, with OFF -> ON.
TEST(Transitions, HaveExactlyTheEdgesOfFigure6) {
  using enum Location;
  std::set<std::pair<Location, Location>> edges;
  for (const Row& row : transitions()) edges.insert({row.from, row.to});
  const std::set<std::pair<Location, Location>> expected = {
      {Init, GameOff},    {GameOn, GameOff}, {GameOff, Setup}, {Setup, GameOn},  {GameOn, GameOn},
      {GameOff, GameOff}, {GameOff, Break},  {Break, GameOff}, {Setup, GameOff}, {GameOff, GameOn}};
  EXPECT_EQ(edges, expected);
}

// Names are cited in calls, tests and the picture.
TEST(Transitions, HaveNamesOfTheirOwnAndConditionsInWords) {
  std::set<std::string_view> names;
  for (const Row& row : transitions()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " is there twice";
    EXPECT_FALSE(row.condition.empty()) << row.name;
  }
  // Every row of the normative list: none was lost.
  for (const char* name : {"T10",   "T11.1", "T11.2", "T11.3", "T11.4", "T11.5", "T11.6", "T11.7", "T12.1",
                           "T12.2", "T12.3", "T12.4", "I-1",   "T13",   "T14",   "T15.a", "T15.b", "T16.a",
                           "T16.b", "T17.a", "T17.b", "T17.c", "T18.a", "T18.b", "T18.c", "T18.d"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

// R-6.2-2: the flows of Table 4.
TEST_F(Rows, TimeoutsAndCardsRunDownWhereTheyShould) {
  GameState& state = given(Location::Break);
  state.timeout_team = Team::Blue;
  state.yellow_times.blue = {60s};
  frame_.time = now + 2s;
  automaton_.take(frame_, {});
  EXPECT_EQ(state.timeout_time.blue, 5min - 2s);
  EXPECT_EQ(state.timeout_time.yellow, 5min);
  EXPECT_EQ(state.stage_end, Time{602s});  // the half is not shortened by a time-out
  EXPECT_EQ(state.yellow_times.blue[0], 60s);
  given(Location::GameOn);
  frame_.time = now + 3s;
  automaton_.take(frame_, {});
  EXPECT_EQ(state.yellow_times.blue[0], 59s);
  EXPECT_EQ(state.timeout_time.blue, 5min - 2s);
}

}  // namespace
}  // namespace automaton
