#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "autoref/automaton/automaton.h"

namespace automaton {

using namespace std::chrono_literals;
using enum world::CommandKind;
using world::Command;
using world::GameState;
using world::Location;
using world::RobotId;
using world::Stage;
using world::Team;
using world::Time;
using world::Vector2d;

inline constexpr RobotId yellow_3{Team::Yellow, 3};
inline constexpr RobotId blue_2{Team::Blue, 2};
inline constexpr Time now{100s};

template <class Value>
void expect_same(const char* what, const Value& expected, const Value& actual) {
  EXPECT_TRUE(expected == actual) << what << " is not as expected";
}

inline void expect_same_touch(const std::optional<world::Touch>& a, const std::optional<world::Touch>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_TRUE(a->robot == b->robot && a->time == b->time && a->position == b->position) << "last_touch";
}

// Every field, so that a row cannot change one unnoticed.
inline void expect_same_state(const GameState& expected, const GameState& actual) {
  expect_same("location", expected.location, actual.location);
  expect_same("stage", expected.stage, actual.stage);
  expect_same("time", expected.time, actual.time);
  expect_same("stage_end", expected.stage_end, actual.stage_end);
  expect_same("timeout_time", expected.timeout_time, actual.timeout_time);
  expect_same("timeout_num", expected.timeout_num, actual.timeout_num);
  expect_same("timeout_team", expected.timeout_team, actual.timeout_team);
  expect_same("reset_position", expected.reset_position, actual.reset_position);
  expect_same("kick_deadline", expected.kick_deadline, actual.kick_deadline);
  expect_same("call", expected.call, actual.call);
  expect_same("restart", expected.restart, actual.restart);
  expect_same("touch_team", expected.touch_team, actual.touch_team);
  expect_same_touch(expected.last_touch, actual.last_touch);
  expect_same("kick_team", expected.kick_team, actual.kick_team);
  expect_same("goal_allowed", expected.goal_allowed, actual.goal_allowed);
  expect_same("is_kickoff", expected.is_kickoff, actual.is_kickoff);
  expect_same("kicker", expected.kicker, actual.kicker);
  expect_same("kick_position", expected.kick_position, actual.kick_position);
  expect_same("red_cards", expected.red_cards, actual.red_cards);
  expect_same("yellow_times", expected.yellow_times, actual.yellow_times);
  expect_same("yellow_cards", expected.yellow_cards, actual.yellow_cards);
  ASSERT_EQ(expected.penalty.has_value(), actual.penalty.has_value()) << "penalty";
  if (expected.penalty) {
    expect_same("penalty.taken", expected.penalty->taken, actual.penalty->taken);
    expect_same("penalty.attacker", expected.penalty->attacker, actual.penalty->attacker);
    expect_same("penalty.defender", expected.penalty->defender, actual.penalty->defender);
  }
  expect_same("shootout_kicks", expected.shootout_kicks, actual.shootout_kicks);
  expect_same("shootout_goals", expected.shootout_goals, actual.shootout_goals);
  expect_same("halted", expected.halted, actual.halted);
  expect_same("first_kickoff", expected.first_kickoff, actual.first_kickoff);
  expect_same("blue_on_positive_half", expected.blue_on_positive_half, actual.blue_on_positive_half);
  expect_same("score", expected.score, actual.score);
  expect_same("keeper", expected.keeper, actual.keeper);
  expect_same("command", expected.command, actual.command);
  expect_same("command_counter", expected.command_counter, actual.command_counter);
  expect_same("command_time", expected.command_time, actual.command_time);
  expect_same("location_time", expected.location_time, actual.location_time);
}

inline Occurrence seen(decltype(world::GameEvent::what) what) {
  return occurrence_of({now, std::move(what)});
}
inline Occurrence request(Request::Kind kind, Team team) {
  return {std::nullopt, std::nullopt, Request{kind, team}};
}

// One row under test: a state in the middle of a half, set up further, then one tick.
class Rows : public ::testing::Test {
 protected:
  Rows() : rules_(world::rule_set("ssl-2015")), automaton_(rules_, {}) {
    GameState& state = automaton_.state();
    state.location = Location::GameOn;
    state.stage = Stage::First;
    state.stage_end = Time{600s};
    state.time = now;
    state.location_time = Time{50s};
    state.call = Stop;
    state.touch_team = Team::Blue;
    state.last_touch = world::Touch{blue_2, Time{99s}, {1, 1}, 1.0};
    state.reset_position = Vector2d{0.5, 0.5};
    state.kick_position = Vector2d{0.25, 0.25};
    state.command_counter = 7;
    frame_.time = now;
    frame_.ball = world::TrackedBall{};
    frame_.ball->position << 1.5, -2.0, 0.0;
  }

  GameState& given(Location location) {
    automaton_.state().location = location;
    return automaton_.state();
  }

  // Expects exactly one row to be taken, with the effect described on a copy of the state.
  void expect(std::string_view row, std::optional<Command> command, Location to, std::vector<Occurrence> what,
              const std::function<void(GameState&)>& effect, bool enters = true) {
    GameState expected = automaton_.state();
    expected.location = to;
    if (enters) expected.location_time = now;
    if (command) {
      expected.command = *command;
      ++expected.command_counter;
      expected.command_time = now;
    }
    effect(expected);
    const auto taken = automaton_.take(frame_, what);
    ASSERT_EQ(taken.size(), 1u) << "rows taken";
    EXPECT_EQ(taken[0].row->name, row);
    expect_same("command", taken[0].command, command);
    expect_same_state(expected, automaton_.state());
  }

  // The call, kick team and place that a stopping row leaves.
  static void next(GameState& s, world::CommandKind call, Team team, Vector2d place) {
    s.call = s.restart = call;
    s.kick_team = team;
    s.reset_position = place;
    s.is_kickoff = call == Kickoff;
    s.penalty.reset();
  }

  world::RuleSet rules_;
  Automaton automaton_;
  world::TrackedFrame frame_;
};

}  // namespace automaton
