#include "autoref/referee/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "autoref/referee/explain_special.h"

namespace referee {
namespace {

using automaton::Transition;
using world::CommandKind;
using world::GameState;
using world::Team;
using world::Vector2d;

double without_minus_zero(double value) { return std::abs(value) < 0.005 ? 0.0 : value; }

template <class Event>
const Event* event(const Transition& transition) {
  return transition.occurrence.event ? std::get_if<Event>(&transition.occurrence.event->what) : nullptr;
}

std::string score_text(const world::PerTeam<int>& score) {
  return fmt::format("yellow {} : {} blue", score.yellow, score.blue);
}

}  // namespace

std::string kick_name(CommandKind kind) {
  switch (kind) {
    case CommandKind::Indirect:
      return "indirect free kick";
    case CommandKind::Direct:
      return "direct free kick";
    case CommandKind::Kickoff:
      return "kickoff";
    case CommandKind::Penalty:
      return "penalty kick";
    default:
      return "neutral start";
  }
}

namespace {

// A direct kick after the ball left over a goal line has a name of its own.
std::string restart_text(const Transition& transition) {
  const GameState& after = transition.after;
  if (after.location == world::Location::Break) return "";
  if (after.restart == CommandKind::Start) return "neutral start";
  std::string kick = kick_name(after.restart);
  const auto* left = event<world::BallLeftFieldGoalLine>(transition);
  const auto* goal = event<world::PossibleGoal>(transition);
  if ((left || goal) && after.restart == CommandKind::Direct) {
    const Vector2d& point = left ? left->location : goal->location;
    const world::Side side = point.x() > 0 ? world::Side::Positive : world::Side::Negative;
    kick = world::defending_team(after, side) == after.kick_team ? "goal kick" : "corner kick";
  }
  return kick + " for " + world::name(after.kick_team);
}

constexpr double sure_touch = 0.9;  // below, the sentence names the next most likely robot, too; ours

std::string last_touch_text(const std::optional<world::Touch>& touch, world::Time when) {
  if (!touch) return "nobody was seen touching it";
  const double before = std::max(0.0, world::seconds(when - touch->time));
  std::string sentence = fmt::format("last touched by {} {:.2f} s earlier", text(touch->robot), before);
  if (touch->probability < 1)
    sentence += fmt::format(" (probability {:.2f}", std::min(touch->probability, 0.99));
  if (touch->probability < 1 && touch->rival && touch->probability < sure_touch) {
    sentence += fmt::format(", else {}", text(*touch->rival));
  }
  if (touch->probability < 1) sentence += ")";
  return sentence;
}

std::string goal_text(const world::PossibleGoal& goal, const std::optional<world::Touch>& touch) {
  const Team scoring = world::opponent(goal.defending);
  if (!touch) return fmt::format("goal for {}, nobody was seen touching the ball", world::name(scoring));
  if (touch->robot.team == goal.defending) {
    return fmt::format("goal for {}, an own goal of {}", world::name(scoring), text(touch->robot));
  }
  return fmt::format("goal for {}, scored by {} from {}", world::name(scoring), text(touch->robot),
                     text(touch->position));
}

std::string too_fast_text(const world::BotKickedBallTooFast& e, const world::RuleSet& rules) {
  return fmt::format("{} kicked the ball at {:.1f} m/s, {:.1f} m/s is the limit", text(e.by), e.speed,
                     rules.max_ball_speed);
}

std::string foul_text(const Transition& transition, const world::RuleSet& rules) {
  if (const auto* kick = event<world::BotKickedBallTooFast>(transition)) return too_fast_text(*kick, rules);
  if (const auto* dribble = event<world::BotDribbledBallTooFar>(transition)) {
    return fmt::format("{} dribbled the ball more than {:.2f} m, from {} to {}", text(dribble->by),
                       rules.max_dribble, text(dribble->start), text(dribble->end));
  }
  return describe(*transition.occurrence.event);
}

std::string kick_offence_text(const Transition& transition, const world::RuleSet& rules) {
  const auto& kick = *event<world::KickTaken>(transition);
  const std::string when = fmt::format("when {} took the kick", text(kick.by));
  if (transition.row->name == "T18.b") {
    return fmt::format("{} was within {:.2f} m of the opponents' defense area {}",
                       text(*kick.attacker_near_area), rules.attacker_area_distance, when);
  }
  if (transition.row->name == "T18.c") {
    return fmt::format("{} was within {:.2f} m of the ball {}", text(*kick.opponent_near_ball),
                       rules.opponent_distance, when);
  }
  return fmt::format("{} was in the wrong half {}", text(*kick.wrong_half), when);
}

// What was seen, for rows that stop play because of something that was detected.
std::string cause_of(const Transition& transition, const world::RuleSet& rules) {
  const auto& touch = transition.before.last_touch;
  const world::Time when =
      transition.occurrence.event ? transition.occurrence.event->time : transition.after.time;
  if (const auto* left = event<world::BallLeftFieldTouchLine>(transition)) {
    return fmt::format("ball left over the touch line at {}, {}", text(left->location),
                       last_touch_text(touch, when));
  }
  if (const auto* left = event<world::BallLeftFieldGoalLine>(transition)) {
    return fmt::format("ball left over the goal line at {}, {}", text(left->location),
                       last_touch_text(touch, when));
  }
  if (const auto* goal = event<world::PossibleGoal>(transition)) {
    if (transition.before.goal_allowed) {
      return goal_text(*goal, touch) + ", now " + score_text(transition.after.score);
    }
    return fmt::format("ball went into {}'s goal straight from an indirect free kick, which is no goal, {}",
                       world::name(goal->defending), last_touch_text(touch, when));
  }
  if (const auto* stuck = event<world::NoProgressInGame>(transition)) {
    return fmt::format("the ball did not move {:.2f} m within a second for {:.0f} s", rules.stuck_distance,
                       world::seconds(stuck->waited));
  }
  if (const auto* twice = event<world::AttackerDoubleTouchedBall>(transition)) {
    return fmt::format("{} took the kick and touched the ball again at {} before anyone else did",
                       text(twice->by), text(twice->location));
  }
  if (event<world::KickTaken>(transition)) return kick_offence_text(transition, rules);
  if (transition.occurrence.foul) return foul_text(transition, rules);
  if (transition.row->name == "T18.a") {
    return fmt::format("{} did not take its {} within {:.0f} s", world::name(transition.before.kick_team),
                       kick_name(transition.before.restart), world::seconds(rules.kick_time));
  }
  return fmt::format("time has been up for {:.0f} s without a stoppage", world::seconds(rules.half_overrun));
}

// Rows that restart play, or lead to it.
std::string progress_text(const Transition& transition, const world::RuleSet& rules) {
  const GameState& after = transition.after;
  const char* team = world::name(after.kick_team);
  const auto* settled = event<world::RobotsSettled>(transition);
  const std::string late = settled && settled->waited_too_long ? ", the wait was over" : "";
  switch (transition.command->kind) {
    case CommandKind::Kickoff:
    case CommandKind::Penalty:
      return fmt::format("{} for {}, get ready{}", kick_name(transition.command->kind), team, late);
    case CommandKind::Start:
      return fmt::format("neutral start, anyone may play the ball{}", late);
    default:
      return fmt::format("{} for {}, to be taken within {:.0f} s{}", kick_name(after.restart), team,
                         world::seconds(rules.kick_time), late);
  }
}

std::string break_text(const Transition& transition) {
  const GameState& after = transition.after;
  if (transition.row->name == "T16.b") {
    const Team team = *after.timeout_team;
    return fmt::format("time-out for {}, {} left after it and {:.0f} s in all", world::name(team),
                       after.timeout_num[team], world::seconds(after.timeout_time[team]));
  }
  const char* team = world::name(*transition.before.timeout_team);
  if (transition.row->name == "T17.b") return fmt::format("the time-outs of {} are used up", team);
  return fmt::format("{} ended its time-out", team);
}

bool stops(const Transition& transition) {
  const auto& row = *transition.row;
  return (row.from == world::Location::GameOn || row.from == world::Location::Setup) &&
         row.to == world::Location::GameOff;
}

std::optional<world::RobotId> offender(const Transition& transition) {
  if (transition.occurrence.foul) return transition.occurrence.foul->by;
  if (const auto* twice = event<world::AttackerDoubleTouchedBall>(transition)) return twice->by;
  const auto* kick = event<world::KickTaken>(transition);
  if (!kick || !stops(transition)) return std::nullopt;
  if (transition.row->name == "T18.b") return kick->attacker_near_area;
  if (transition.row->name == "T18.c") return kick->opponent_near_ball;
  return kick->wrong_half;
}

// Whose offence a noted event is: a robot's, or both teams' or a whole team's.
struct NotedOffender {
  std::optional<world::RobotId> robot;
};

std::optional<NotedOffender> noted_offender(const world::GameEvent& event) {
  if (const auto* crash = std::get_if<world::BotCrashUnique>(&event.what)) return {{crash->by}};
  if (const auto* near = std::get_if<world::BotTooNearInStop>(&event.what)) return {{near->by}};
  if (const auto* in_way = std::get_if<world::BotInterferedPlacement>(&event.what)) return {{in_way->by}};
  if (const auto* outside = std::get_if<world::BotLeftField>(&event.what)) return {{outside->by}};
  const bool of_nobody = std::holds_alternative<world::BotCrashDrawn>(event.what) ||
                         std::holds_alternative<world::TooManyRobots>(event.what);
  if (of_nobody) return NotedOffender{};
  return std::nullopt;
}

}  // namespace

bool is_call(const Transition& transition) {
  return transition.command.has_value() || stops(transition) || !card_text(transition).empty();
}

std::optional<Call> note(const automaton::Occurrence& occurrence, const GameState& state) {
  if (!occurrence.event || occurrence.foul) return std::nullopt;
  const auto by = noted_offender(*occurrence.event);
  if (!by) return std::nullopt;
  Call call;
  call.time = state.time;
  call.row = "note";
  call.event = occurrence.event;
  call.stage = state.stage;
  call.score = state.score;
  if (by->robot) call.offender = by->robot;
  call.sentence = "noted: " + describe(*occurrence.event);
  return call;
}

Call explain(const Transition& transition, const world::RuleSet& rules) {
  const GameState& after = transition.after;
  Call call;
  call.time = after.time;
  call.row = transition.row->name;
  call.event = transition.occurrence.event;
  call.command = transition.command;
  call.stops_play = stops(transition);
  call.offender = offender(transition);
  call.stage = after.stage;
  call.score = after.score;
  const bool only_a_card = !transition.command && !call.stops_play;
  if (!only_a_card) call.restart = restart_text(transition);
  if (!call.restart.empty()) call.position = after.reset_position;

  const std::optional<std::string> special = special_sentence(transition, rules);
  if (only_a_card) {
    if (transition.occurrence.event) call.sentence = describe(*transition.occurrence.event);
  } else if (call.stops_play) {
    call.sentence = fmt::format("{}, so {}", special ? *special : cause_of(transition, rules), call.restart);
    if (call.position) call.sentence += " from " + text(*call.position);
  } else if (special) {
    call.sentence = *special;
  } else if (call.row == "T10") {
    call.sentence = "the match begins with a " + call.restart;
  } else if (transition.row->from == world::Location::Break || transition.row->to == world::Location::Break) {
    call.sentence = break_text(transition);
  } else {
    call.sentence = progress_text(transition, rules);
  }
  call.sentence += card_text(transition);
  return call;
}

std::string text(world::RobotId robot) {
  return fmt::format("{} {}", world::name(robot.team), static_cast<int>(robot.number));
}

std::string text(const Vector2d& place) {
  return fmt::format("({:.2f}, {:.2f}) m", without_minus_zero(place.x()), without_minus_zero(place.y()));
}

namespace {

struct Describe {
  world::Time time;
  std::string operator()(const world::BallLeftFieldTouchLine& e) const {
    return fmt::format("ball left over the touch line at {}, {}", text(e.location),
                       last_touch_text(e.last_touch, time));
  }
  std::string operator()(const world::BallLeftFieldGoalLine& e) const {
    return fmt::format("ball left over the goal line at {}, {}", text(e.location),
                       last_touch_text(e.last_touch, time));
  }
  std::string operator()(const world::PossibleGoal& e) const { return goal_text(e, e.last_touch); }
  std::string operator()(const world::BotKickedBallTooFast& e) const {
    return fmt::format("{} kicked the ball at {:.1f} m/s from {}", text(e.by), e.speed, text(e.location));
  }
  std::string operator()(const world::BotDribbledBallTooFar& e) const {
    return fmt::format("{} dribbled the ball from {} to {}", text(e.by), text(e.start), text(e.end));
  }
  std::string operator()(const world::AttackerDoubleTouchedBall& e) const {
    return fmt::format("{} touched the ball again at {} after its own kick", text(e.by), text(e.location));
  }
  std::string operator()(const world::AimlessKick& e) const {
    return fmt::format(
        "{} kicked from its own half at {} over the opponents' goal line at {}, untouched (icing)",
        text(e.by), text(e.kick), text(e.location));
  }
  std::string operator()(const world::ChippedGoal& e) const {
    return fmt::format(
        "no goal: the ball was {:.2f} m high after {} chipped it at {}, and neither a team-mate "
        "touched it nor did it roll before it went in",
        e.highest, text(e.by), text(e.kick));
  }
  std::string operator()(const world::BotCrashUnique& e) const {
    return fmt::format("{} ran into {} at {:.1f} m/s at {}{}", text(e.by), text(e.victim), e.speed,
                       text(e.location), e.advantage ? ", advantage" : "");
  }
  std::string operator()(const world::BotCrashDrawn& e) const {
    return fmt::format("{} and {} ran into each other at {:.1f} m/s at {}", text(e.robots.yellow),
                       text(e.robots.blue), e.speed, text(e.location));
  }
  std::string operator()(const world::AttackerTouchedKeeper& e) const {
    return fmt::format("{} touched the goalie {} in its area at {}", text(e.by), text(e.keeper),
                       text(e.location));
  }
  std::string operator()(const world::DefenderInDefenseArea& e) const {
    return fmt::format("{} touched the ball {} inside its own defense area at {}", text(e.by),
                       e.wholly ? "wholly" : "partly", text(e.location));
  }
  std::string operator()(const world::AttackerTouchedBallInDefenseArea& e) const {
    return fmt::format("{} touched the ball {:.2f} m inside the opponents' defense area at {}", text(e.by),
                       e.depth, text(e.location));
  }
  std::string operator()(const world::KeeperHeldBall& e) const {
    return fmt::format("the goalie {} held the ball for {:.0f} s at {}", text(e.by), world::seconds(e.held),
                       text(e.location));
  }
  std::string operator()(const world::BotTooFastInStop& e) const {
    return fmt::format("{} drove at {:.1f} m/s under STOP at {}", text(e.by), e.speed, text(e.location));
  }
  std::string operator()(const world::BotTooNearInStop& e) const {
    return fmt::format("{} stayed {:.2f} m from the ball under STOP at {}", text(e.by), e.distance,
                       text(e.location));
  }
  std::string operator()(const world::BotInterferedPlacement& e) const {
    return fmt::format("{} stood in the way of the ball's placement at {}", text(e.by), text(e.location));
  }
  std::string operator()(const world::BotLeftField& e) const {
    return fmt::format("{} was {:.2f} m outside the field at {}", text(e.by), e.distance, text(e.location));
  }
  std::string operator()(const world::TooManyRobots& e) const {
    return fmt::format("{} plays with {} robots, {} are allowed", world::name(e.team), e.robots, e.allowed);
  }
  std::string operator()(const world::NoProgressInGame& e) const {
    return fmt::format("the ball is stuck at {} for {:.0f} s", text(e.location), world::seconds(e.waited));
  }
  std::string operator()(const world::BallTouched& e) const {
    return fmt::format("{} touched the ball at {}", text(e.touch.robot), text(e.touch.position));
  }
  std::string operator()(const world::KickTaken& e) const {
    std::string sentence = fmt::format("{} took the kick from {}", text(e.by), text(e.location));
    if (e.attacker_near_area) sentence += fmt::format(", {} was near the area", text(*e.attacker_near_area));
    if (e.opponent_near_ball) sentence += fmt::format(", {} was near the ball", text(*e.opponent_near_ball));
    if (e.wrong_half) sentence += fmt::format(", {} was in the wrong half", text(*e.wrong_half));
    return sentence;
  }
  std::string operator()(const world::RobotsSettled& e) const {
    return e.waited_too_long ? "the wait for robots to settle is over" : "robots are settled";
  }
};

}  // namespace

std::string kind_of(const world::GameEvent& event) {
  struct Kind {
    const char* operator()(const world::BallLeftFieldTouchLine&) const { return "touch line"; }
    const char* operator()(const world::BallLeftFieldGoalLine&) const { return "goal line"; }
    const char* operator()(const world::PossibleGoal&) const { return "goal"; }
    const char* operator()(const world::BotKickedBallTooFast&) const { return "too fast"; }
    const char* operator()(const world::BotDribbledBallTooFar&) const { return "dribbled too far"; }
    const char* operator()(const world::AttackerDoubleTouchedBall&) const { return "double touch"; }
    const char* operator()(const world::AimlessKick&) const { return "icing"; }
    const char* operator()(const world::ChippedGoal&) const { return "chip goal"; }
    const char* operator()(const world::BotCrashUnique&) const { return "collision"; }
    const char* operator()(const world::BotCrashDrawn&) const { return "collision, drawn"; }
    const char* operator()(const world::AttackerTouchedKeeper&) const { return "touched the goalie"; }
    const char* operator()(const world::DefenderInDefenseArea&) const { return "defender in own area"; }
    const char* operator()(const world::AttackerTouchedBallInDefenseArea&) const {
      return "attacker in area";
    }
    const char* operator()(const world::KeeperHeldBall&) const { return "goalie holds the ball"; }
    const char* operator()(const world::BotTooFastInStop&) const { return "too fast in stop"; }
    const char* operator()(const world::BotTooNearInStop&) const { return "too near in stop"; }
    const char* operator()(const world::BotInterferedPlacement&) const { return "interfered placement"; }
    const char* operator()(const world::BotLeftField&) const { return "robot left field"; }
    const char* operator()(const world::TooManyRobots&) const { return "too many robots"; }
    const char* operator()(const world::NoProgressInGame&) const { return "no progress"; }
    const char* operator()(const world::BallTouched&) const { return "ball touched"; }
    const char* operator()(const world::KickTaken&) const { return "kick taken"; }
    const char* operator()(const world::RobotsSettled&) const { return "robots settled"; }
  };
  return std::visit(Kind{}, event.what);
}

std::string describe(const world::GameEvent& event) { return std::visit(Describe{event.time}, event.what); }

std::string format_call(const Call& call) {
  const auto milliseconds =
      std::chrono::round<std::chrono::milliseconds>(call.time.time_since_epoch()).count();
  std::string command = "-";
  if (call.command) {
    command = world::name(call.command->kind);
    if (world::has_team(call.command->kind)) command += fmt::format("({})", world::name(call.command->team));
  }
  return fmt::format("{:>3}:{:02}.{:03}  {:<10} {:<16} {}-{}  {}", milliseconds / 60000,
                     milliseconds / 1000 % 60, milliseconds % 1000, call.row, command, call.score.yellow,
                     call.score.blue, call.sentence);
}

}  // namespace referee
