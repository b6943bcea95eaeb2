#include "experiments/judge/net/reported.h"

#include "sim/wire/epoch.h"

namespace judge {
namespace {

namespace proto = matchday::referee;

constexpr world::Duration oldest = std::chrono::seconds{10};
constexpr double farthest = 100;  // [m] no field is longer; ours

std::optional<world::RobotId> robot(proto::Team team, std::uint32_t number) {
  if (team == proto::UNKNOWN || number > world::max_robot_number) return std::nullopt;
  return world::RobotId{team == proto::YELLOW ? world::Team::Yellow : world::Team::Blue,
                        static_cast<std::uint8_t>(number)};
}

template <class What>
void say_who(const What& what, Call& call) {
  if constexpr (requires { what.by_bot(); }) {
    if (what.has_by_team()) call.by = robot(what.by_team(), what.by_bot());
  } else if constexpr (requires { what.by_team(); }) {
    if (what.has_by_team()) call.by = robot(what.by_team(), 0);
  }
  if constexpr (requires { what.location(); }) {
    const world::Vector2d place(what.location().x(), what.location().y());
    if (place.cwiseAbs().maxCoeff() <= farthest && place.allFinite()) call.place = place;
  }
}

}  // namespace

bool can_be_reported(Event event) {
  switch (event) {
    case Event::ChippedGoal:  // of laws that are gone
    case Event::KeeperTouched:
    case Event::RobotLeftField:
    case Event::KickTaken:
    case Event::WrongHalf:
    case Event::RobotsSettled:
    case Event::TooNearInStop:
      return false;
    default:
      return true;
  }
}

std::optional<Call> call_of(const proto::GameEvent& reported, world::Time now) {
  Call call;
  call.time = call.reported = now;
  if (reported.has_created_timestamp() && reported.created_timestamp() < 4'000'000'000'000'000) {
    const world::Time created =
        wire::from_microseconds(static_cast<std::int64_t>(reported.created_timestamp()), wire::Epoch{});
    if (created <= now && created > now - oldest) call.time = created;
  }
  const auto is = [&](Event event, const auto& what) {
    call.event = event;
    say_who(what, call);
  };
  const auto exit = [&](const proto::GameEvent::BallLeftField& what) {
    is(Event::Exit, what);
    if (!call.by) return;
    call.last.emplace();
    call.last->robot = *call.by;
    call.last->time = call.time;
  };
  switch (reported.event_case()) {
    case proto::GameEvent::kBallLeftFieldTouchLine:
      exit(reported.ball_left_field_touch_line());
      break;
    case proto::GameEvent::kBallLeftFieldGoalLine:
      exit(reported.ball_left_field_goal_line());
      break;
    case proto::GameEvent::kPossibleGoal:
      is(Event::Goal, reported.possible_goal());
      call.by.reset();
      break;
    case proto::GameEvent::kGoal:
      is(Event::Goal, reported.goal());
      call.by.reset();
      break;
    case proto::GameEvent::kAimlessKick:
      is(Event::AimlessKick, reported.aimless_kick());
      break;
    case proto::GameEvent::kBotKickedBallTooFast:
      is(Event::BallTooFast, reported.bot_kicked_ball_too_fast());
      break;
    case proto::GameEvent::kBotDribbledBallTooFar:
      is(Event::DribbledTooFar, reported.bot_dribbled_ball_too_far());
      break;
    case proto::GameEvent::kAttackerDoubleTouchedBall:
      is(Event::DoubleTouch, reported.attacker_double_touched_ball());
      break;
    case proto::GameEvent::kAttackerTouchedBallInDefenseArea:
      is(Event::AttackerInArea, reported.attacker_touched_ball_in_defense_area());
      break;
    case proto::GameEvent::kDefenderInDefenseArea:
      is(Event::DefenderInArea, reported.defender_in_defense_area());
      break;
    case proto::GameEvent::kKeeperHeldBall:
      is(Event::KeeperHeldBall, reported.keeper_held_ball());
      call.by.reset();  // which robot is the keeper it does not say
      break;
    case proto::GameEvent::kBotCrashUnique:
      is(Event::Collision, reported.bot_crash_unique());
      call.by = robot(reported.bot_crash_unique().by_team(), reported.bot_crash_unique().violator());
      break;
    case proto::GameEvent::kBotCrashDrawn:
      is(Event::Collision, reported.bot_crash_drawn());
      break;
    case proto::GameEvent::kNoProgressInGame:
      is(Event::NoProgress, reported.no_progress_in_game());
      break;
    case proto::GameEvent::kTooManyRobots:
      is(Event::TooManyRobots, reported.too_many_robots());
      break;
    case proto::GameEvent::kBotTooFastInStop:
      is(Event::TooFastInStop, reported.bot_too_fast_in_stop());
      break;
    case proto::GameEvent::kBotInterferedPlacement:
      is(Event::InterferedPlacement, reported.bot_interfered_placement());
      break;
    case proto::GameEvent::kDefenderTooCloseToKickPoint:
      is(Event::OpponentNearBall, reported.defender_too_close_to_kick_point());
      break;
    case proto::GameEvent::kAttackerTooCloseToDefenseArea:
      is(Event::AttackerNearArea, reported.attacker_too_close_to_defense_area());
      break;
    default:
      return std::nullopt;
  }
  return call;
}

}  // namespace judge
