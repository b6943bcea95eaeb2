#include <variant>

#include "sim/wire/referee.h"

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
