#include "autoref/calibrate/calibration.h"

#include "autoref/calibrate/ball.h"
#include "autoref/calibrate/bias.h"
#include "autoref/calibrate/losses.h"
#include "autoref/calibrate/mistakes.h"
#include "autoref/calibrate/noise.h"
#include "autoref/calibrate/robots.h"
#include "autoref/calibrate/set_up.h"

namespace calibrate {

Report calibrated(const Observations& seen, const std::optional<world::Geometry>& geometry) {
  Report report;
  add_set_up(seen, geometry, report);
  const Noise noise = add_noise(seen, report);
  add_bias(seen, report);
  add_losses(seen, report);
  add_mistakes(seen, report);
  add_ball(seen, noise, report);
  add_robots(seen, noise, report);
  return report;
}

}  // namespace calibrate
