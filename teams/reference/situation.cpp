#include "teams/reference/situation.h"

#include <algorithm>

namespace reference {
namespace {

constexpr int think_every = 3;        // ticks
constexpr double sooner = 0.25;       // [s] a team this much sooner at a free ball will have it (ours)
constexpr double change_after = 0.3;  // [s] reference "football", 2.8

// The robot's meeting every third tick, staggered by number; in between it comes nearer by itself.
void refresh(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model,
             skills::Meeting& meeting) {
  if ((view.tick + robot.number) % think_every != 0 && meeting.time > 0) {
    meeting.time = std::max(0.0, meeting.time - world::tick_length);
    return;
  }
  const double reach = robot.specs.center_to_dribbler + view.field().ball_radius;
  meeting = skills::meet(view, robot, skills::driving_limits(robot.specs), model, reach);
}

}  // namespace

void Observer::meet_the_ball(const kit::View& view) {
  Situation& s = situation_;
  s.our_time = s.their_time = 9;
  s.their_first = -1;
  for (const kit::Robot& robot : view.own) {
    refresh(view, robot, s.model, s.meetings[robot.number]);
    if (view.game.forbidden != robot.number) {
      s.our_time = std::min(s.our_time, s.meetings[robot.number].time);
    }
  }
  for (const kit::Robot& robot : view.opponents) {
    refresh(view, robot, s.model, their_meetings_[robot.number]);
    if (their_meetings_[robot.number].time < s.their_time) {
      s.their_time = their_meetings_[robot.number].time;
      s.their_first = robot.number;
    }
  }
}

// Who is at the ball has it; a free ball belongs to whom it will belong to; else to who had it last.
Possession Observer::judge(const kit::View& view) {
  const Possession had = tracker_.update(view);
  if (tracker_.at_ball() != Possession::None) return tracker_.at_ball();
  const Situation& s = situation_;
  if (s.our_time + sooner < s.their_time) return Possession::Ours;
  if (s.their_time + sooner < s.our_time) return Possession::Theirs;
  if (had == Possession::None && s.our_time < 1.0) return Possession::Contested;
  return had;
}

const Situation& Observer::observe(const kit::View& view) {
  situation_.model = kit::BallModel(view.geometry);
  meet_the_ball(view);
  const Possession now = judge(view);
  if (now != candidate_) {
    candidate_ = now;
    candidate_since_ = view.time;
  }
  // A change counts when it lasts: no dithering between formations.
  if (view.time - candidate_since_ >= change_after) situation_.possession = now;
  return situation_;
}

}  // namespace reference
