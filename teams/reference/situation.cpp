#include "teams/reference/situation.h"

#include <algorithm>

namespace reference {

const char* name(Possession possession) {
  switch (possession) {
    case Possession::None:
      return "none";
    case Possession::Ours:
      return "ours";
    case Possession::Theirs:
      return "theirs";
    case Possession::Contested:
      return "contested";
  }
  return "unknown";
}

const Situation& Observer::observe(const kit::View& view) {
  Situation& s = situation_;
  s.model = kit::BallModel(view.geometry);
  const double ball_radius = view.field().ball_radius;

  // Each robot's meeting every third tick, staggered; in between it comes nearer by itself.
  double our_time = 9;
  for (const kit::Robot& robot : view.own) {
    skills::Meeting& meeting = s.meetings[robot.number];
    if ((view.tick + robot.number) % 3 == 0 || meeting.time <= 0) {
      const double reach = robot.specs.center_to_dribbler + ball_radius;
      meeting = skills::meet(view, robot, skills::driving_limits(robot.specs), s.model, reach);
    } else {
      meeting.time = std::max(0.0, meeting.time - world::tick_length);
    }
    if (view.game.forbidden != robot.number) our_time = std::min(our_time, meeting.time);
  }
  if (view.tick % 3 == 0 || kit::find(view.opponents, s.their_first) == nullptr) {
    s.their_time = 9;
    s.their_first = -1;
    for (const kit::Robot& robot : view.opponents) {
      const double reach = robot.specs.center_to_dribbler + ball_radius;
      const skills::Meeting meeting =
          skills::meet(view, robot, skills::driving_limits(robot.specs), s.model, reach);
      if (meeting.time < s.their_time) {
        s.their_time = meeting.time;
        s.their_first = robot.number;
      }
    }
  }

  Possession now = Possession::Contested;
  if (our_time + 0.25 < s.their_time) {
    now = Possession::Ours;
  } else if (s.their_time + 0.25 < our_time) {
    now = Possession::Theirs;
  } else if (our_time > 1.0) {
    now = Possession::None;
  }
  // A change counts when it lasts 0.15 s: no dithering between formations.
  possession_ticks_ = now == candidate_ ? possession_ticks_ + 1 : 0;
  candidate_ = now;
  if (possession_ticks_ >= 9) s.possession = now;
  return s;
}

}  // namespace reference
