#include <variant>

#include "sim/wire/referee.h"

// Some offences of 2015 are none any more; the league keeps their events as deprecated.
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace wire {

namespace {

using proto::GameEvent;

matchday::referee::Team to_wire(world::Team team) {
  return team == world::Team::Yellow ? matchday::referee::YELLOW : matchday::referee::BLUE;
}

// Events are in metres, unlike the rest of the referee's message.
void set_point(const world::Vector2d& point, matchday::referee::Vector2& out) {
  out.set_x(static_cast<float>(point.x()));
  out.set_y(static_cast<float>(point.y()));
}

template <class Body>
void set_by(world::RobotId by, Body& out) {
  out.set_by_team(to_wire(by.team));
  out.set_by_bot(by.number);
}

template <class Event>
void set_ball_left(const Event& event, GameEvent::BallLeftField& out) {
  out.set_by_team(matchday::referee::UNKNOWN);  // required, also when nobody touched the ball
  if (event.last_touch) set_by(event.last_touch->robot, out);
  set_point(event.location, *out.mutable_location());
}

template <class Event, class Body>
void set_crash(const Event& event, Body& out) {
  set_point(event.location, *out.mutable_location());
  out.set_crash_speed(static_cast<float>(event.speed));
  out.set_speed_diff(static_cast<float>(event.speed_difference));
  out.set_crash_angle(static_cast<float>(event.angle));
}

template <class Event, class Body>
void set_depth(const Event& event, Body& out) {
  set_by(event.by, out);
  set_point(event.location, *out.mutable_location());
  out.set_distance(static_cast<float>(event.depth));
}

/// Fills type and body; one overload per event that the league has.
struct Body {
  Epoch epoch;
  GameEvent& out;

  bool operator()(const world::BallLeftFieldTouchLine& event) const {
    out.set_type(GameEvent::BALL_LEFT_FIELD_TOUCH_LINE);
    set_ball_left(event, *out.mutable_ball_left_field_touch_line());
    return true;
  }
  bool operator()(const world::BallLeftFieldGoalLine& event) const {
    out.set_type(GameEvent::BALL_LEFT_FIELD_GOAL_LINE);
    set_ball_left(event, *out.mutable_ball_left_field_goal_line());
    return true;
  }
  bool operator()(const world::PossibleGoal& event) const {
    out.set_type(GameEvent::POSSIBLE_GOAL);
    GameEvent::Goal& goal = *out.mutable_possible_goal();
    const world::Team scoring = world::opponent(event.defending);
    goal.set_by_team(to_wire(scoring));
    set_point(event.location, *goal.mutable_location());
    if (event.last_touch) {
      goal.set_kicking_team(to_wire(event.last_touch->robot.team));
      goal.set_kicking_bot(event.last_touch->robot.number);
      set_point(event.last_touch->position, *goal.mutable_kick_location());
      if (event.last_touch->robot.team == scoring) {
        goal.set_last_touch_by_team(
            static_cast<std::uint64_t>(to_microseconds(event.last_touch->time, epoch)));
      }
    }
    return true;
  }
  bool operator()(const world::BotKickedBallTooFast& event) const {
    out.set_type(GameEvent::BOT_KICKED_BALL_TOO_FAST);
    GameEvent::BotKickedBallTooFast& kick = *out.mutable_bot_kicked_ball_too_fast();
    set_by(event.by, kick);
    set_point(event.location, *kick.mutable_location());
    kick.set_initial_ball_speed(static_cast<float>(event.speed));
    return true;
  }
  bool operator()(const world::BotDribbledBallTooFar& event) const {
    out.set_type(GameEvent::BOT_DRIBBLED_BALL_TOO_FAR);
    GameEvent::BotDribbledBallTooFar& dribble = *out.mutable_bot_dribbled_ball_too_far();
    set_by(event.by, dribble);
    set_point(event.start, *dribble.mutable_start());
    set_point(event.end, *dribble.mutable_end());
    return true;
  }
  bool operator()(const world::AttackerDoubleTouchedBall& event) const {
    out.set_type(GameEvent::ATTACKER_DOUBLE_TOUCHED_BALL);
    GameEvent::AttackerDoubleTouchedBall& touch = *out.mutable_attacker_double_touched_ball();
    set_by(event.by, touch);
    set_point(event.location, *touch.mutable_location());
    return true;
  }
  bool operator()(const world::NoProgressInGame& event) const {
    out.set_type(GameEvent::NO_PROGRESS_IN_GAME);
    GameEvent::NoProgressInGame& stuck = *out.mutable_no_progress_in_game();
    set_point(event.location, *stuck.mutable_location());
    stuck.set_time(static_cast<float>(world::seconds(event.waited)));
    return true;
  }
  bool operator()(const world::AimlessKick& event) const {
    out.set_type(GameEvent::AIMLESS_KICK);
    GameEvent::AimlessKick& kick = *out.mutable_aimless_kick();
    set_by(event.by, kick);
    set_point(event.location, *kick.mutable_location());
    set_point(event.kick, *kick.mutable_kick_location());
    return true;
  }
  bool operator()(const world::ChippedGoal& event) const {
    out.set_type(GameEvent::CHIPPED_GOAL);
    GameEvent::ChippedGoal& goal = *out.mutable_chipped_goal();
    set_by(event.by, goal);
    set_point(event.location, *goal.mutable_location());
    set_point(event.kick, *goal.mutable_kick_location());
    goal.set_max_ball_height(static_cast<float>(event.highest));
    return true;
  }
  bool operator()(const world::BotCrashUnique& event) const {
    out.set_type(GameEvent::BOT_CRASH_UNIQUE);
    GameEvent::BotCrashUnique& crash = *out.mutable_bot_crash_unique();
    crash.set_by_team(to_wire(event.by.team));
    crash.set_violator(event.by.number);
    crash.set_victim(event.victim.number);
    set_crash(event, crash);
    return true;
  }
  bool operator()(const world::BotCrashDrawn& event) const {
    out.set_type(GameEvent::BOT_CRASH_DRAWN);
    GameEvent::BotCrashDrawn& crash = *out.mutable_bot_crash_drawn();
    crash.set_bot_yellow(event.robots.yellow.number);
    crash.set_bot_blue(event.robots.blue.number);
    set_crash(event, crash);
    return true;
  }
  bool operator()(const world::AttackerTouchedKeeper& event) const {
    out.set_type(GameEvent::ATTACKER_TOUCHED_OPPONENT_IN_DEFENSE_AREA);
    GameEvent::AttackerTouchedOpponentInDefenseArea& touch =
        *out.mutable_attacker_touched_opponent_in_defense_area();
    set_by(event.by, touch);
    set_point(event.location, *touch.mutable_location());
    touch.set_victim(event.keeper.number);
    return true;
  }
  bool operator()(const world::DefenderInDefenseArea& event) const {
    if (event.wholly) {
      out.set_type(GameEvent::DEFENDER_IN_DEFENSE_AREA);
      set_depth(event, *out.mutable_defender_in_defense_area());
    } else {
      out.set_type(GameEvent::DEFENDER_IN_DEFENSE_AREA_PARTIALLY);
      set_depth(event, *out.mutable_defender_in_defense_area_partially());
    }
    return true;
  }
  bool operator()(const world::AttackerTouchedBallInDefenseArea& event) const {
    out.set_type(GameEvent::ATTACKER_TOUCHED_BALL_IN_DEFENSE_AREA);
    set_depth(event, *out.mutable_attacker_touched_ball_in_defense_area());
    return true;
  }
  bool operator()(const world::KeeperHeldBall& event) const {
    out.set_type(GameEvent::KEEPER_HELD_BALL);
    GameEvent::KeeperHeldBall& held = *out.mutable_keeper_held_ball();
    held.set_by_team(to_wire(event.by.team));
    set_point(event.location, *held.mutable_location());
    held.set_duration(static_cast<float>(world::seconds(event.held)));
    return true;
  }
  bool operator()(const world::BotTooFastInStop& event) const {
    out.set_type(GameEvent::BOT_TOO_FAST_IN_STOP);
    GameEvent::BotTooFastInStop& robot = *out.mutable_bot_too_fast_in_stop();
    set_by(event.by, robot);
    set_point(event.location, *robot.mutable_location());
    robot.set_speed(static_cast<float>(event.speed));
    return true;
  }
  bool operator()(const world::BotInterferedPlacement& event) const {
    out.set_type(GameEvent::BOT_INTERFERED_PLACEMENT);
    GameEvent::BotInterferedPlacement& robot = *out.mutable_bot_interfered_placement();
    set_by(event.by, robot);
    set_point(event.location, *robot.mutable_location());
    return true;
  }
  bool operator()(const world::TooManyRobots& event) const {
    out.set_type(GameEvent::TOO_MANY_ROBOTS);
    GameEvent::TooManyRobots& robots = *out.mutable_too_many_robots();
    robots.set_by_team(to_wire(event.team));
    robots.set_num_robots_allowed(event.allowed);
    robots.set_num_robots_on_field(event.robots);
    return true;
  }
  // The kick itself is nothing to the league, the offences of that moment are; of two the graver one.
  bool operator()(const world::KickTaken& event) const {
    if (event.attacker_near_area) {
      out.set_type(GameEvent::ATTACKER_TOO_CLOSE_TO_DEFENSE_AREA);
      GameEvent::AttackerTooCloseToDefenseArea& robot = *out.mutable_attacker_too_close_to_defense_area();
      set_by(*event.attacker_near_area, robot);
      set_point(event.location, *robot.mutable_ball_location());
      return true;
    }
    if (!event.opponent_near_ball) return false;
    out.set_type(GameEvent::DEFENDER_TOO_CLOSE_TO_KICK_POINT);
    set_by(*event.opponent_near_ball, *out.mutable_defender_too_close_to_kick_point());
    return true;
  }
  template <class NotInTheLeague>
  bool operator()(const NotInTheLeague&) const {
    return false;
  }
};

}  // namespace

bool encode(const world::GameEvent& event, Epoch epoch, proto::GameEvent& out) {
  out.Clear();
  if (!std::visit(Body{epoch, out}, event.what)) return false;
  out.set_created_timestamp(static_cast<std::uint64_t>(to_microseconds(event.time, epoch)));
  return true;
}

}  // namespace wire
