#include "autoref/automaton/transitions.h"

#include <algorithm>
#include <array>

#include "autoref/automaton/positions.h"
#include "autoref/automaton/restart.h"
#include "autoref/automaton/stages.h"
#include "autoref/detectors/penalty.h"

namespace automaton {
namespace {

using enum world::Location;
using enum world::CommandKind;
using world::Command;
using world::CommandKind;
using world::GameState;
using world::Stage;
using world::Team;
using world::Vector2d;

// --- Questions ---

template <class Event>
const Event* event(const Context& c) {
  return c.occurrence && c.occurrence->event ? std::get_if<Event>(&c.occurrence->event->what) : nullptr;
}

template <class Event>
bool is(const Context& c) {
  return event<Event>(c) != nullptr;
}

Vector2d ball_position(const Context& c) {
  if (c.frame.ball) return c.frame.ball->position.head<2>();
  return c.state.reset_position.value_or(Vector2d::Zero());
}

bool settled_for(const Context& c, CommandKind call) {
  return is<world::RobotsSettled>(c) && c.state.call == call;
}

bool stage_is_over(const Context& c) { return c.state.stage_end && c.state.time > *c.state.stage_end; }

// A penalty kick is taken, and decided, even when time is up (Law 14).
bool penalty_is_due(const GameState& state) {
  return state.location == GameOn ? state.penalty.has_value() : state.restart == Penalty;
}

bool half_is_over(const Context& c) {
  return is_half(c.state.stage) && stage_is_over(c) && !penalty_is_due(c.state);
}

bool half_is_overdue(const Context& c) {
  return half_is_over(c) && c.state.time > *c.state.stage_end + c.rules.half_overrun;
}

// A ball that rests sooner has hardly been kicked (ours).
constexpr world::Duration penalty_rest = std::chrono::milliseconds{500};

world::RobotId keeper_of(const GameState& state, Team team) {
  return {team, static_cast<std::uint8_t>(state.keeper[team])};
}

bool in_shootout(const Context& c) { return c.state.stage == Stage::Shootout; }

bool is_foul(const Context& c, Severity severity) {
  return c.occurrence->foul && c.occurrence->foul->severity == severity;
}

bool in_own_area(const Context& c, const Foul& foul) {
  const world::Side own = world::defended_side(c.state, foul.by.team);
  return world::distance_to_defense_area(c.rules.field, own, foul.location) <= 0;
}

// Where the ball left the field, for the exits and for a goal that is not allowed.
std::optional<Vector2d> exit_point(const Context& c) {
  if (const auto* left = event<world::BallLeftFieldTouchLine>(c)) return left->location;
  if (const auto* left = event<world::BallLeftFieldGoalLine>(c)) return left->location;
  if (const auto* goal = event<world::PossibleGoal>(c)) return goal->location;
  return std::nullopt;
}

bool requests(const Context& c, Request::Kind kind) {
  return c.occurrence->request && c.occurrence->request->kind == kind;
}

// --- Commands ---

Command stop(const Context&) { return {Stop, Team::Yellow}; }
Command call(const Context& c) { return {c.state.call, c.state.kick_team}; }
Command goal(const Context& c) { return {Goal, world::opponent(event<world::PossibleGoal>(c)->defending)}; }
Command timeout(const Context& c) { return {Timeout, c.occurrence->request->team}; }
Command stage_end(const Context& c) { return stage_end_command(c.state); }

// --- Effects ---

void next_free_kick(const Context& c, GameState& state, CommandKind kind, Team team, const Vector2d& place) {
  next_restart(state, kind, team, free_kick_position(c.rules, c.state, team, place));
}

void neutral_start(const Context& c, GameState& state) {
  next_neutral_start(c.rules, state, ball_position(c));
}

void begin_match(const Context&, GameState& state) {
  next_restart(state, Kickoff, state.first_kickoff, Vector2d::Zero());
  state.stage = Stage::PreFirst;
  state.goal_allowed = true;
  state.kicker.reset();
  state.score = {};
}

void touched(const Context& c, GameState& state) {
  const world::Touch& touch = event<world::BallTouched>(c)->touch;
  state.kicker.reset();
  state.touch_team = touch.robot.team;
  state.last_touch = touch;
  state.goal_allowed = true;
}

void double_touched(const Context& c, GameState& state) {
  const auto& touch = *event<world::AttackerDoubleTouchedBall>(c);
  next_free_kick(c, state, Indirect, world::opponent(touch.by.team), touch.location);
}

// I-9: each yellow card has a time of its own; there is no limit to their number in the laws of 2015.
void show_card(const Context& c, GameState& state) {
  const Foul& foul = *c.occurrence->foul;
  if (foul.card == Card::Red) ++state.red_cards[foul.by.team];
  if (foul.card != Card::Yellow) return;
  ++state.yellow_cards[foul.by.team];
  state.yellow_times[foul.by.team].push_back(c.rules.yellow_card);
}

void fouled(const Context& c, GameState& state) {
  show_card(c, state);
  const Foul& foul = *c.occurrence->foul;
  next_free_kick(c, state, foul.severity == Severity::Minor ? Indirect : Direct,
                 world::opponent(foul.by.team), foul.location);
}

void fouled_in_own_area(const Context& c, GameState& state) {
  show_card(c, state);
  next_penalty(c.rules, state, world::opponent(c.occurrence->foul->by.team));
}

void scored(const Context& c, GameState& state) {
  const Team defending = event<world::PossibleGoal>(c)->defending;
  next_restart(state, Kickoff, defending, Vector2d::Zero());
  ++state.score[world::opponent(defending)];
}

// Algorithm 2, lines 16 to 33.
void left_field(const Context& c, GameState& state) {
  const Vector2d point = *exit_point(c);
  const world::Side side = point.x() > 0 ? world::Side::Positive : world::Side::Negative;
  const Team defending = world::defending_team(state, side);
  // Nobody was seen to touch the ball since the match began: it was most likely an attacker of that half.
  const Team toucher = state.touch_team.value_or(world::opponent(defending));
  const Team kicker = world::opponent(toucher);
  if (is<world::BallLeftFieldTouchLine>(c)) {
    next_restart(state, Indirect, kicker, kick_in_position(c.rules, point));
  } else {
    next_restart(state, c.rules.direct_from_goal_line ? Direct : Indirect, kicker,
                 goal_line_position(c.rules, point, toucher == defending));
  }
}

void await_kick(const Context& c, GameState& state) {
  state.goal_allowed = state.call != Indirect;
  state.kick_deadline = state.time + c.rules.kick_time;
  state.kick_position = ball_position(c);
}

void begin_half(const Context& c, GameState& state) {
  await_kick(c, state);
  state.stage = next_stage(c.rules, state.stage, false);
  state.stage_end = state.time + *stage_length(c.rules, state.stage);
}

void started(const Context&, GameState& state) {
  state.goal_allowed = true;
  state.kicker.reset();
  state.is_kickoff = false;
}

void kicked(const Context& c, GameState& state) {
  const auto& kick = *event<world::KickTaken>(c);
  state.kicker = kick.by;
  state.touch_team = kick.by.team;
  state.last_touch = world::Touch{kick.by, c.occurrence->event->time, kick.location, 1.0};
  state.is_kickoff = false;
}

void kicked_penalty(const Context& c, GameState& state) {
  kicked(c, state);
  const auto offenders = detectors::penalty_offenders(c.rules.field, c.rules.penalty_line, c.frame, c.state);
  state.penalty = world::PenaltyKick{c.occurrence->event->time, offenders.attacker, offenders.defender};
}

void repeat_penalty(const Context& c, GameState& state) {
  if (c.occurrence && c.occurrence->foul) show_card(c, state);
  next_penalty(c.rules, state, state.kick_team);
}

void penalty_decided(const Context&, GameState& state) { state.penalty.reset(); }

void begin_shootout(const Context& c, GameState& state) {
  state.stage = Stage::Shootout;
  state.stage_end.reset();
  next_penalty(c.rules, state, state.first_kickoff);
}

void shootout_scored(const Context& c, GameState& state) { next_shootout_kick(c.rules, state, true); }

void shootout_missed(const Context& c, GameState& state) {
  if (c.occurrence && c.occurrence->foul) show_card(c, state);
  next_shootout_kick(c.rules, state, false);
}

void end_shootout(const Context&, GameState& state) { state.stage = Stage::Post; }

void card_at_restart(const Context& c, GameState& state) {
  show_card(c, state);
  same_restart_again(state);
}

void attacker_was_near_area(const Context& c, GameState& state) {
  next_free_kick(c, state, Indirect, world::opponent(state.kick_team), event<world::KickTaken>(c)->location);
}

// The ball goes back to where the kick was to be taken: reset_position stays.
void retake(const Context& c, GameState& state) {
  state.call = c.rules.retake_keeps_call ? state.restart : Indirect;
  state.restart = state.call;
  state.is_kickoff = state.call == Kickoff;
}

void retake_kickoff(const Context&, GameState& state) { state.call = Kickoff; }

void prepared(const Context&, GameState& state) { state.call = Ready; }

bool card_ran_out(const GameState& state, Team team) {
  return std::ranges::any_of(state.yellow_times[team], [](world::Duration left) { return left.count() < 0; });
}

void remove_card(const Context&, GameState& state) {
  const Team team = card_ran_out(state, Team::Yellow) ? Team::Yellow : Team::Blue;
  std::vector<world::Duration>& times = state.yellow_times[team];
  times.erase(std::ranges::min_element(times));
}

void end_half(const Context& c, GameState& state) {
  state.stage = next_stage(c.rules, state.stage, state.score.yellow == state.score.blue);
  state.stage_end.reset();
  if (const auto length = stage_length(c.rules, state.stage)) state.stage_end = state.time + *length;
  if (state.stage == Stage::ExtraBreak) {
    state.timeout_num = {c.rules.extra_timeouts, c.rules.extra_timeouts};
    state.timeout_time = {c.rules.extra_timeout_time, c.rules.extra_timeout_time};
  }
}

void begin_timeout(const Context& c, GameState& state) {
  state.timeout_team = c.occurrence->request->team;
  --state.timeout_num[*state.timeout_team];
}

// A kickoff or penalty that had been announced is announced again.
void end_timeout(const Context&, GameState& state) {
  state.timeout_team.reset();
  state.call = state.restart;
}

void end_half_time(const Context& c, GameState& state) {
  state.stage = next_stage(c.rules, state.stage, false);
  next_restart(state, Kickoff, kickoff_team(state, state.stage), Vector2d::Zero());
  state.call = Ready;
  state.stage_end.reset();
  state.blue_on_positive_half = !state.blue_on_positive_half;
}

// --- Conditions ---

bool kicker_touched(const Context& c) {
  const auto* touch = event<world::AttackerDoubleTouchedBall>(c);
  return touch && c.state.kicker == touch->by;
}

bool other_robot_touched(const Context& c) {
  const auto* touch = event<world::BallTouched>(c);
  return touch && c.state.kicker != touch->touch.robot;
}

bool serious_in_own_area(const Context& c) {
  return is_foul(c, Severity::Serious) && in_own_area(c, *c.occurrence->foul);
}

bool legal_goal(const Context& c) { return is<world::PossibleGoal>(c) && c.state.goal_allowed; }

bool exit_or_illegal_goal(const Context& c) {
  return exit_point(c) && !(is<world::PossibleGoal>(c) && c.state.goal_allowed);
}

bool half_time_is_over(const Context& c) {
  return is_half_time(c.state.stage) && !c.state.timeout_team && stage_is_over(c);
}

bool shootout_begins(const Context& c) { return c.state.stage == Stage::ShootoutBreak && stage_is_over(c); }

// Not in a shoot-out (laws of 2015, appendix A).
bool timeout_is_granted(const Context& c) {
  if (!requests(c, Request::Kind::BeginTimeout) || in_shootout(c)) return false;
  const Team team = c.occurrence->request->team;
  return c.state.timeout_num[team] > 0 && c.state.timeout_time[team].count() > 0;
}

bool timeout_ran_out(const Context& c) {
  return c.state.timeout_team && c.state.timeout_time[*c.state.timeout_team].count() <= 0;
}

bool timeout_is_ended(const Context& c) {
  return requests(c, Request::Kind::EndTimeout) && c.state.timeout_team == c.occurrence->request->team;
}

bool settled_to_prepare(const Context& c) { return settled_for(c, Kickoff) || settled_for(c, Penalty); }

bool kick_is_late(const Context& c) { return c.state.kick_deadline && c.state.time > *c.state.kick_deadline; }

bool attacker_near_area(const Context& c) {
  const auto* kick = event<world::KickTaken>(c);
  return kick && kick->attacker_near_area;
}

bool opponent_near_ball(const Context& c) {
  const auto* kick = event<world::KickTaken>(c);
  return kick && kick->opponent_near_ball;
}

bool wrong_half_at_kickoff(const Context& c) {
  const auto* kick = event<world::KickTaken>(c);
  return kick && c.state.is_kickoff && kick->wrong_half;
}

bool card_shown(const Context& c) { return c.occurrence->foul && c.occurrence->foul->card != Card::None; }

// R-R15-15, the laws' Law 14: a kick with someone in the wrong place is taken all the same; what came of it
// decides whether it counts.

bool penalty_taken(const Context& c) { return is<world::KickTaken>(c) && c.state.restart == Penalty; }

bool penalty_goal(const Context& c) {
  const auto* goal = event<world::PossibleGoal>(c);
  return goal && goal->defending == world::opponent(c.state.kick_team);
}

// The ball rests, somebody but the keeper played it, or it has taken too long.
bool penalty_played_out(const Context& c) {
  if (!c.state.penalty) return false;
  const Team defending = world::opponent(c.state.kick_team);
  const world::Time taken = c.state.penalty->taken;
  const auto& touch = c.state.last_touch;
  if (touch && touch->time > taken && touch->robot != keeper_of(c.state, defending)) return true;
  const world::Duration since = c.state.time - taken;
  const bool rests = c.frame.ball && c.frame.ball->velocity.norm() < c.rules.ball_settled_speed;
  return (rests && since > penalty_rest) || since > c.rules.penalty_time;
}

bool penalty_to_be_repeated(const Context& c) {
  if (!c.state.penalty) return false;
  if (penalty_goal(c)) return c.state.penalty->attacker.has_value();
  if (exit_point(c)) return c.state.penalty->defender.has_value();
  return in_shootout(c) && c.occurrence->foul && c.occurrence->foul->by.team != c.state.kick_team;
}

bool played_out_to_be_repeated(const Context& c) {
  return penalty_played_out(c) && c.state.penalty->defender.has_value();
}

bool penalty_is_over(const Context& c) { return penalty_played_out(c) && !c.state.penalty->defender; }

bool shootout_is_missed(const Context& c) {
  const bool foul = c.occurrence->foul && c.occurrence->foul->by.team == c.state.kick_team;
  return in_shootout(c) && (exit_point(c) || foul || kicker_touched(c) || is<world::NoProgressInGame>(c));
}

// --- The tables ---

constexpr bool awaits = true;   // an occurrence
constexpr bool always = false;  // a condition on variables only
constexpr bool anew = true;

// clang-format off
constexpr std::array<Row, 41> table = {{
    // name     from     to       when    condition              command  effect
    {"T10", Init, GameOff, always, nullptr, stop, begin_match, false, "always"},

    {"T14", GameOn, GameOn, awaits, other_robot_touched, nullptr, touched, false, "robot other than the kicker touches the ball"},
    {"R15-15.b", GameOn, GameOff, awaits, penalty_to_be_repeated, stop, repeat_penalty, false, "penalty: goal with an attacker in the wrong place, or none with a defender there"},
    {"R8-10.b", GameOn, GameOff, awaits, [](const Context& c) { return in_shootout(c) && penalty_goal(c); }, goal, shootout_scored, false, "shoot-out: goal"},
    {"R8-10.c", GameOn, GameOff, awaits, shootout_is_missed, stop, shootout_missed, false, "shoot-out: ball exits, foul or second touch by the kicker's team"},
    {"T11.6", GameOn, GameOff, awaits, kicker_touched, stop, double_touched, false, "kicker touches the ball"},
    {"T11.3", GameOn, GameOff, awaits, [](const Context& c) { return is_foul(c, Severity::Minor); }, stop, fouled, false, "minor foul"},
    {"T11.5", GameOn, GameOff, awaits, serious_in_own_area, stop, fouled_in_own_area, false, "serious foul in own area"},
    {"T11.4", GameOn, GameOff, awaits, [](const Context& c) { return is_foul(c, Severity::Serious); }, stop, fouled, false, "serious foul"},
    {"T11.1", GameOn, GameOff, awaits, legal_goal, goal, scored, false, "goal"},
    {"T11.7", GameOn, GameOff, awaits, exit_or_illegal_goal, stop, left_field, false, "ball exits"},
    {"T11.2", GameOn, GameOff, awaits, is<world::NoProgressInGame>, stop, neutral_start, false, "ball is stuck"},
    {"R15-15.c", GameOn, GameOff, always, played_out_to_be_repeated, stop, repeat_penalty, false, "penalty: played out without a goal, a defender was in the wrong place"},
    {"R8-10.d", GameOn, GameOff, always, [](const Context& c) { return in_shootout(c) && (!c.state.penalty || penalty_is_over(c)); }, stop, shootout_missed, false, "shoot-out: played out without a goal"},
    {"R15-15.d", GameOn, GameOff, always, [](const Context& c) { return penalty_is_over(c) && is_half(c.state.stage) && stage_is_over(c); }, stop, neutral_start, false, "penalty: played out, time is up"},
    {"R15-15.e", GameOn, GameOn, always, penalty_is_over, nullptr, penalty_decided, false, "penalty: played out"},
    {"I-18.on", GameOn, GameOff, always, half_is_overdue, stop, neutral_start, false, "half is overdue"},

    {"R8-10.f", GameOff, Break, always, [](const Context& c) { return in_shootout(c) && shootout_is_over(c.rules, c.state); }, stage_end, end_shootout, false, "shoot-out: decided, or long enough"},
    {"T16.a", GameOff, Break, always, half_is_over, stage_end, end_half, false, "half is over"},
    {"T16.b", GameOff, Break, awaits, timeout_is_granted, timeout, begin_timeout, false, "time-out requested"},
    {"I-9.off", GameOff, GameOff, awaits, card_shown, nullptr, show_card, false, "foul with a card while play is stopped"},
    {"T15.b", GameOff, GameOff, always, [](const Context& c) { return card_ran_out(c.state, Team::Yellow) || card_ran_out(c.state, Team::Blue); }, nullptr, remove_card, false, "yellow card ran out"},
    {"T15.a", GameOff, GameOff, awaits, settled_to_prepare, call, prepared, anew, "settled, kickoff or penalty"},
    {"T12.1", GameOff, Setup, awaits, [](const Context& c) { return settled_for(c, Ready) && is_before_half(c.state.stage); }, call, begin_half, false, "settled, ready, before a half"},
    {"T12.2", GameOff, Setup, awaits, [](const Context& c) { return settled_for(c, Ready) && !is_before_half(c.state.stage); }, call, await_kick, false, "settled, ready, in a half"},
    {"T12.3", GameOff, Setup, awaits, [](const Context& c) { return settled_for(c, Direct); }, call, await_kick, false, "settled, direct"},
    {"T12.4", GameOff, Setup, awaits, [](const Context& c) { return settled_for(c, Indirect); }, call, await_kick, false, "settled, indirect"},
    {"I-1", GameOff, GameOn, awaits, [](const Context& c) { return settled_for(c, Start); }, call, started, false, "settled, neutral start"},

    {"I-9.setup", Setup, GameOff, awaits, card_shown, stop, card_at_restart, false, "foul with a card before the kick"},
    {"R15-15.a", Setup, GameOn, awaits, penalty_taken, nullptr, kicked_penalty, false, "penalty kick taken"},
    {"T18.b", Setup, GameOff, awaits, attacker_near_area, stop, attacker_was_near_area, false, "kick taken, team-mate near the opponents' area"},
    {"T18.c", Setup, GameOff, awaits, opponent_near_ball, stop, retake, false, "kick taken, opponent near the ball"},
    {"T18.d", Setup, GameOff, awaits, wrong_half_at_kickoff, stop, retake_kickoff, false, "kickoff taken, robot in the wrong half"},
    {"T13", Setup, GameOn, awaits, is<world::KickTaken>, nullptr, kicked, false, "kick taken"},
    {"R8-10.e", Setup, GameOff, always, [](const Context& c) { return in_shootout(c) && kick_is_late(c); }, stop, shootout_missed, false, "shoot-out: kick is late"},
    {"T18.a", Setup, GameOff, always, kick_is_late, stop, neutral_start, false, "kick is late"},
    {"I-18.setup", Setup, GameOff, always, half_is_overdue, stop, neutral_start, false, "half is overdue"},

    {"T17.a", Break, GameOff, always, half_time_is_over, stage_end, end_half_time, false, "half-time is over"},
    {"R8-10.a", Break, GameOff, always, shootout_begins, stage_end, begin_shootout, false, "break before the shoot-out is over"},
    {"T17.b", Break, GameOff, always, timeout_ran_out, stop, end_timeout, false, "time-out ran out"},
    {"T17.c", Break, GameOff, awaits, timeout_is_ended, stop, end_timeout, false, "time-out ended"},
}};
// clang-format on

}  // namespace

std::span<const Row> transitions() { return table; }

}  // namespace automaton
