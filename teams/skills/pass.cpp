#include "teams/skills/pass.h"

#include <algorithm>
#include <cmath>

#include "teams/skills/motion.h"

namespace skills {

double pass_safety(const kit::View& view, const kit::BallModel& model, const Vector2d& from,
                   const Vector2d& to, double speed) {
  const Vector2d way = to - from;
  const double length = way.norm();
  if (length < 0.05) return 1;
  const Vector2d along = way / length;
  double least = 2;             // [s] nobody is ever safer than that
  const double reaction = 0.1;  // [s]
  const double c = model.switch_ratio;
  for (const kit::Robot& opponent : view.opponents) {
    const double abreast = (opponent.position - from).dot(along);
    if (abreast < -0.3) continue;
    const Limits limits = driving_limits(opponent.specs);
    const double reach = opponent.specs.radius + view.field().ball_radius;
    const double nearest = std::clamp(abreast, 0.2, length);
    for (const double s : {nearest, 0.5 * (nearest + length), length}) {
      const double ball = model.time_to_cover(speed, c * speed, s);
      const Vector2d point = from + along * s;
      const double drive = time_to_touch(point - opponent.position, opponent.velocity, limits, reach);
      const double robot = drive > 0 ? reaction + drive : 0;  // who stands there need not react
      least = std::min(least, robot - ball);
    }
  }
  return 1 / (1 + std::exp(-least / 0.1));
}

Pass plan_pass(const kit::View& view, const kit::BallModel& model, const Vector2d& from, const Vector2d& to,
               double arrival) {
  Pass pass;
  pass.target = to;
  const double length = (to - from).norm();
  pass.speed = std::clamp(model.kick_speed_for(length, arrival), 2.0, 6.5);
  pass.time = model.time_to_cover(pass.speed, model.switch_ratio * pass.speed, length);
  pass.safety = pass_safety(view, model, from, to, pass.speed);
  return pass;
}

}  // namespace skills
