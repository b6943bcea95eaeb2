// One test per row that the paper lacks: penalty kicks (R-R15-15), extra time and shoot-out
// (R-8-10), cards (I-9).
#include "tests/autoref/automaton/rows.h"

namespace automaton {
namespace {

constexpr RobotId blue_0{Team::Blue, 0};

// Yellow takes a penalty at the goal at +x; blue 0 keeps it.
class PenaltyRows : public Rows {
 protected:
  PenaltyRows() {
    GameState& state = automaton_.state();
    state.restart = Penalty;
    state.call = Ready;
    state.kick_team = Team::Yellow;
    state.reset_position = mark;
    state.kick_position = mark;
    frame_.ball->position << mark.x(), mark.y(), 0.0;
    frame_.ball->velocity << 3.0, 0.0, 0.0;
    frame_.robots.push_back({.id = yellow_3, .position = {3.39, 0}});
    frame_.robots.push_back({.id = {Team::Yellow, 4}, .position = {2.9, 1}});
    frame_.robots.push_back({.id = blue_0, .position = {4.5, 0.2}});
    frame_.robots.push_back({.id = blue_2, .position = {2.9, -1}});
  }

  // The kick was taken a second ago.
  GameState& after_kick() {
    GameState& state = given(Location::GameOn);
    state.kick_team = Team::Yellow;
    state.kicker = yellow_3;
    state.touch_team = Team::Yellow;
    state.last_touch = world::Touch{yellow_3, now - 1s, mark, 1.0};
    state.penalty = world::PenaltyKick{now - 1s, {}, {}};
    return state;
  }

  GameState& in_shootout(GameState& state) {
    state.stage = Stage::Shootout;
    state.stage_end.reset();
    state.shootout_kicks = {2, 2};
    state.shootout_goals = {1, 2};
    state.score = {4, 5};
    return state;
  }

  static Occurrence goal() { return seen(world::PossibleGoal{Team::Blue, {}, {4.52, 0.3}}); }
  static Occurrence kick() { return seen(world::KickTaken{yellow_3, mark, {}, {}, {}}); }

  static inline const Vector2d mark{3.5, 0};
  static inline const Vector2d other_mark{-3.5, 0};
};

TEST_F(PenaltyRows, R15_15_aTakesTheKickAndRemembersWhoStoodWrongly) {
  for (const bool wrong : {false, true}) {
    automaton_.state().penalty.reset();
    given(Location::Setup);
    if (wrong) {
      frame_.robots[1].position.x() = 3.1;  // the line is 1.4 m from the goal line; its hull is over it
      frame_.robots[2].position.x() = 4.3;  // the keeper has left its line
    }
    expect("R15-15.a", std::nullopt, Location::GameOn, {kick()}, [&](GameState& s) {
      s.kicker = yellow_3;
      s.touch_team = Team::Yellow;
      s.last_touch = world::Touch{yellow_3, now, mark, 1.0};
      s.penalty = world::PenaltyKick{now, {}, {}};
      if (wrong) s.penalty = world::PenaltyKick{now, RobotId{Team::Yellow, 4}, blue_0};
    });
  }
}

TEST_F(PenaltyRows, AnOpponentAtThePenaltyLineIsNotTooNearTheBall) {
  given(Location::Setup);
  const std::vector<Occurrence> taken = {seen(world::KickTaken{yellow_3, mark, {}, blue_2, {}})};
  EXPECT_EQ(automaton_.take(frame_, taken)[0].row->name, "R15-15.a");
}

TEST_F(PenaltyRows, T11_1APenaltyGoalCountsEvenWhenTheKeeperTouchedIt) {
  GameState& state = after_kick();
  state.kicker.reset();
  state.last_touch = world::Touch{blue_0, now, {4.4, 0.2}, 1.0};
  expect("T11.1", Command{Goal, Team::Yellow}, Location::GameOff, {goal()}, [](GameState& s) {
    next(s, Kickoff, Team::Blue, {0, 0});
    s.score.yellow = 1;
  });
}

TEST_F(PenaltyRows, R15_15_bAGoalWithAnAttackerInTheWrongPlaceIsTakenAgain) {
  after_kick().penalty->attacker = yellow_3;
  expect("R15-15.b", Command{Stop}, Location::GameOff, {goal()},
         [](GameState& s) { next(s, Penalty, Team::Yellow, mark); });
}

TEST_F(PenaltyRows, T11_1AGoalWithADefenderInTheWrongPlaceCounts) {
  after_kick().penalty->defender = blue_0;
  const std::vector<Occurrence> what = {goal()};
  EXPECT_EQ(automaton_.take(frame_, what)[0].row->name, "T11.1");
}

TEST_F(PenaltyRows, R15_15_bNoGoalWithADefenderInTheWrongPlaceIsTakenAgain) {
  after_kick().penalty->defender = blue_0;
  expect("R15-15.b", Command{Stop}, Location::GameOff, {seen(world::BallLeftFieldGoalLine{{}, {4.5215, 1}})},
         [](GameState& s) { next(s, Penalty, Team::Yellow, mark); });
}

TEST_F(PenaltyRows, T11_7APenaltyThatMissesIsAGoalKick) {
  after_kick();
  expect("T11.7", Command{Stop}, Location::GameOff, {seen(world::BallLeftFieldGoalLine{{}, {4.5215, 1}})},
         [](GameState& s) {
           next(s, Direct, Team::Blue, {4.0, 2.9});
         });
}

TEST_F(PenaltyRows, R15_15_cSavedWithADefenderInTheWrongPlaceIsTakenAgain) {
  after_kick().penalty->defender = blue_2;
  frame_.ball->velocity.setZero();
  expect("R15-15.c", Command{Stop}, Location::GameOff, {},
         [](GameState& s) { next(s, Penalty, Team::Yellow, mark); });
}

TEST_F(PenaltyRows, R15_15_dTimeThatWasAddedForAPenaltyEndsWithIt) {
  after_kick().stage_end = now - 1s;
  EXPECT_TRUE(automaton_.take(frame_, {}).empty());  // still rolling
  frame_.ball->velocity.setZero();
  const auto taken = automaton_.take(frame_, {});
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_EQ(taken[0].row->name, "R15-15.d");
  EXPECT_EQ(taken[1].row->name, "T16.a");
}

TEST_F(PenaltyRows, TimeIsAddedForAPenaltyThatIsDue) {
  given(Location::GameOff).stage_end = now - 1h;
  EXPECT_TRUE(automaton_.take(frame_, {}).empty());
  given(Location::Setup);
  EXPECT_TRUE(automaton_.take(frame_, {}).empty());
}

TEST_F(PenaltyRows, R15_15_ePlayGoesOnWhenItIsPlayedOut) {
  struct Case {
    const char* what;
    std::function<void(GameState&, world::TrackedFrame&)> set;
  };
  const Case cases[] = {
      {"the ball rests", [](GameState&, world::TrackedFrame& f) { f.ball->velocity.setZero(); }},
      {"an attacker plays the rebound",
       [](GameState& s, world::TrackedFrame&) {
         s.last_touch = world::Touch{yellow_3, now, {4, 0}, 1.0};
       }},
      {"a defender clears it",
       [](GameState& s, world::TrackedFrame&) {
         s.last_touch = world::Touch{blue_2, now, {4, 0}, 1.0};
       }},
      {"it takes too long",
       [](GameState& s, world::TrackedFrame&) { s.penalty->taken = s.last_touch->time = now - 10s - 1ns; }},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.what);
    frame_.ball->velocity << 3.0, 0.0, 0.0;
    one.set(after_kick(), frame_);
    expect(
        "R15-15.e", std::nullopt, Location::GameOn, {}, [](GameState& s) { s.penalty.reset(); }, false);
  }
}

TEST_F(PenaltyRows, ThePenaltyIsOnWhileTheBallRollsOrTheKeeperHasIt) {
  GameState& state = after_kick();
  EXPECT_TRUE(automaton_.take(frame_, {}).empty());
  state.kicker.reset();
  state.last_touch = world::Touch{blue_0, now, {4.4, 0.2}, 1.0};
  EXPECT_TRUE(automaton_.take(frame_, {}).empty());
}

TEST_F(PenaltyRows, T18_aAPenaltyThatIsNotTakenIsANeutralStart) {
  given(Location::Setup).kick_deadline = now - 1ns;
  expect("T18.a", Command{Stop}, Location::GameOff, {}, [](GameState& s) {
    next(s, Start, Team::Yellow, {2.8, 0});
  });  // 0.7 m from the area
}

// --- Extra time ---

class WinnerRows : public Rows {
 protected:
  WinnerRows() {
    rules_.winner = true;
    const GameState state = automaton_.state();
    automaton_ = Automaton(rules_, {});
    automaton_.state() = state;
  }
};

TEST_F(WinnerRows, T16_aADrawIsFollowedByExtraTimeWithTimeoutsOfItsOwn) {
  GameState& state = given(Location::GameOff);
  state.stage = Stage::Second;
  state.stage_end = now - 1ns;
  state.score = {2, 2};
  state.timeout_num = {0, 3};
  state.timeout_time = {0s, 100s};
  expect("T16.a", Command{Halt}, Location::Break, {}, [](GameState& s) {
    s.stage = Stage::ExtraBreak;
    s.stage_end = now;
    s.timeout_num = {2, 2};
    s.timeout_time = {5min, 5min};
  });
}

TEST_F(WinnerRows, T16_aALeadEndsTheGame) {
  for (const Stage stage : {Stage::Second, Stage::ExtraSecond}) {
    GameState& state = given(Location::GameOff);
    state.stage = stage;
    state.stage_end = now - 1ns;
    state.score = {2, 1};
    expect("T16.a", Command{Halt}, Location::Break, {}, [](GameState& s) {
      s.stage = Stage::Post;
      s.stage_end.reset();
    });
  }
}

TEST_F(WinnerRows, T17_aExtraTimeBeginsWithEndsChanged) {
  for (const auto& [from, to, team] : {std::tuple{Stage::ExtraBreak, Stage::PreExtraFirst, Team::Yellow},
                                       std::tuple{Stage::ExtraHalfTime, Stage::PreExtraSecond, Team::Blue}}) {
    GameState& state = given(Location::Break);
    state.stage = from;
    state.stage_end = now - 1ns;
    expect("T17.a", Command{Kickoff, team}, Location::GameOff, {}, [&](GameState& s) {
      next(s, Kickoff, team, {0, 0});
      s.call = Ready;
      s.stage = to;
      s.stage_end.reset();
      s.blue_on_positive_half = !s.blue_on_positive_half;
    });
  }
}

TEST_F(WinnerRows, T12_1AHalfOfExtraTimeLastsFiveMinutes) {
  GameState& state = given(Location::GameOff);
  state.call = Ready;
  state.stage = Stage::PreExtraFirst;
  expect("T12.1", Command{Ready}, Location::Setup, {seen(world::RobotsSettled{})}, [](GameState& s) {
    s.stage = Stage::ExtraFirst;
    s.stage_end = now + 5min;
    s.kick_deadline = now + 10s;
    s.kick_position = Vector2d{1.5, -2.0};
  });
}

// --- The shoot-out ---

TEST_F(PenaltyRows, R8_10_aTheShootoutBeginsWithTheTeamOfTheFirstKickoff) {
  GameState& state = given(Location::Break);
  state.stage = Stage::ShootoutBreak;
  state.stage_end = now - 1ns;
  state.first_kickoff = Team::Blue;
  expect("R8-10.a", Command{Stop}, Location::GameOff, {}, [](GameState& s) {
    s.stage = Stage::Shootout;
    s.stage_end.reset();
    next(s, Penalty, Team::Blue, other_mark);
  });
}

TEST_F(PenaltyRows, R8_10_bAGoalInTheShootout) {
  in_shootout(after_kick());
  expect("R8-10.b", Command{Goal, Team::Yellow}, Location::GameOff, {goal()}, [](GameState& s) {
    s.shootout_kicks.yellow = 3;
    s.shootout_goals.yellow = 2;
    s.score.yellow = 5;
    next(s, Penalty, Team::Blue, other_mark);
  });
}

void missed(GameState& s) {
  s.shootout_kicks.yellow = 3;
  s.call = s.restart = Penalty;
  s.kick_team = Team::Blue;
  s.reset_position = Vector2d{-3.5, 0};
  s.is_kickoff = false;
  s.penalty.reset();
}

TEST_F(PenaltyRows, R8_10_cAMissInTheShootout) {
  const std::vector<Occurrence> misses = {seen(world::BallLeftFieldGoalLine{{}, {4.5215, 1}}),
                                          seen(world::BallLeftFieldTouchLine{{}, {1, 3.0215}}),
                                          seen(world::AttackerDoubleTouchedBall{yellow_3, {4, 0}}),
                                          seen(world::NoProgressInGame{{4, 0}, 12s}),
                                          seen(world::BotKickedBallTooFast{yellow_3, {3.5, 0}, 9.0})};
  for (const Occurrence& miss : misses) {
    in_shootout(after_kick());
    expect("R8-10.c", Command{Stop}, Location::GameOff, {miss}, missed);
  }
}

TEST_F(PenaltyRows, R15_15_bAFoulOfTheKeeperInTheShootoutMeansAgain) {
  in_shootout(after_kick());
  expect("R15-15.b", Command{Stop}, Location::GameOff,
         {{std::nullopt, Foul{blue_0, {4.2, 0}, Severity::Serious, Card::Yellow}, {}}}, [](GameState& s) {
           next(s, Penalty, Team::Yellow, mark);
           s.yellow_cards.blue = 1;
           s.yellow_times.blue = {120s};
         });
}

TEST_F(PenaltyRows, R8_10_dASaveInTheShootout) {
  in_shootout(after_kick());
  frame_.ball->velocity.setZero();
  expect("R8-10.d", Command{Stop}, Location::GameOff, {}, missed);
}

TEST_F(PenaltyRows, R8_10_eAKickThatIsLateInTheShootoutIsAMiss) {
  in_shootout(given(Location::Setup)).kick_deadline = now - 1ns;
  expect("R8-10.e", Command{Stop}, Location::GameOff, {}, missed);
}

TEST_F(PenaltyRows, R8_10_fTheShootoutEndsTheGame) {
  GameState& state = in_shootout(given(Location::GameOff));
  state.shootout_kicks = {5, 5};
  expect("R8-10.f", Command{Halt}, Location::Break, {}, [](GameState& s) { s.stage = Stage::Post; });
}

TEST_F(PenaltyRows, NoTimeoutInTheShootout) {
  in_shootout(given(Location::GameOff));
  const std::vector<Occurrence> wish = {request(Request::Kind::BeginTimeout, Team::Blue)};
  EXPECT_TRUE(automaton_.take(frame_, wish).empty());
}

// --- Cards (R-4.3-10, I-9, I-10) ---

TEST_F(Rows, AFoulWithAYellowCardStopsPlayAndStartsItsTime) {
  given(Location::GameOn).yellow_times.blue = {30s};
  expect("T11.3", Command{Stop}, Location::GameOff,
         {{std::nullopt, Foul{blue_2, {1, 0}, Severity::Minor, Card::Yellow}, {}}}, [](GameState& s) {
           next(s, Indirect, Team::Yellow, {1, 0});
           s.yellow_times.blue = {30s, 120s};  // each its own expiry
           s.yellow_cards.blue = 1;
         });
}

TEST_F(Rows, AFoulWithARedCardTakesARobotForGood) {
  expect("T11.4", Command{Stop}, Location::GameOff,
         {{std::nullopt, Foul{blue_2, {1, 0}, Severity::Serious, Card::Red}, {}}}, [](GameState& s) {
           next(s, Direct, Team::Yellow, {1, 0});
           s.red_cards.blue = 1;
         });
}

TEST_F(Rows, APenaltyCanComeWithACard) {
  expect("T11.5", Command{Stop}, Location::GameOff,
         {{std::nullopt, Foul{blue_2, {4.2, 0}, Severity::Serious, Card::Yellow}, {}}}, [](GameState& s) {
           next(s, Penalty, Team::Yellow, {3.5, 0});
           s.yellow_times.blue = {120s};
           s.yellow_cards.blue = 1;
         });
}

TEST_F(Rows, I9_offACardWhilePlayIsStoppedChangesNothingElse) {
  given(Location::GameOff);
  expect(
      "I-9.off", std::nullopt, Location::GameOff,
      {{std::nullopt, Foul{blue_2, {1, 0}, Severity::Minor, Card::Yellow}, {}}},
      [](GameState& s) {
        s.yellow_times.blue = {120s};
        s.yellow_cards.blue = 1;
      },
      false);
}

TEST_F(Rows, I9_setupACardBeforeTheKickMeansTheSameKickAgain) {
  GameState& state = given(Location::Setup);
  state.call = Ready;
  state.restart = Kickoff;
  expect("I-9.setup", Command{Stop}, Location::GameOff,
         {{std::nullopt, Foul{blue_2, {1, 0}, Severity::Minor, Card::Red}, {}}}, [](GameState& s) {
           s.red_cards.blue = 1;
           s.call = Kickoff;
           s.is_kickoff = true;
         });
}

// I-10: the time runs out in play, the card is removed at the next stoppage.
TEST_F(Rows, AYellowCardRunsOutInPlayAndIsRemovedAtAStoppage) {
  GameState& state = given(Location::GameOn);
  state.yellow_times.blue = {1s};
  frame_.time = now + 2s;
  EXPECT_TRUE(automaton_.take(frame_, {}).empty());
  EXPECT_EQ(state.yellow_times.blue, (std::vector<world::Duration>{-1s}));
  given(Location::GameOff);
  const auto taken = automaton_.take(frame_, {});
  ASSERT_EQ(taken.size(), 1u);
  EXPECT_EQ(taken[0].row->name, "T15.b");
  EXPECT_TRUE(state.yellow_times.blue.empty());
}

}  // namespace
}  // namespace automaton
