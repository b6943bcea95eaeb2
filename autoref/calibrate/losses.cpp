#include "autoref/calibrate/losses.h"

#include <fmt/format.h>

#include <algorithm>

namespace calibrate {
namespace {

using world::Vector2d;

constexpr double longest = 4;     // [s] a longer absence may have other reasons
constexpr double may_hide = 0.3;  // [m] radius of a robot, of the ball, and a shadow of 0.16 m
constexpr double same = 0.1;      // [m] a stray number nearer to a lost robot is that robot
constexpr std::size_t enough = 500;
constexpr std::int64_t enough_gaps = 5;

void count(Gaps& gaps, std::size_t missed) {
  if (gaps.size() <= missed) gaps.resize(missed + 1);
  ++gaps[missed];
}

struct BallGaps {
  Gaps free;
  Gaps near_robots;
};

// The place of the track at an image between two sightings.
Vector2d between(const Sighting& a, const Sighting& b, double time) {
  return a.position + (b.position - a.position) * ((time - a.time) / (b.time - a.time));
}

bool seen_well(const CameraImages& camera, const Sighting& a, const Sighting& b) {
  return b.time - a.time <= longest && camera.sees_well(a.position) && camera.sees_well(b.position);
}

void count_ball(const Observations& seen, const Track& track, BallGaps& gaps) {
  const CameraImages& camera = seen.cameras[track.camera];
  const auto& all = track.sightings;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Sighting& a = all[i - 1];
    const Sighting& b = all[i];
    if (!seen_well(camera, a, b)) continue;
    bool free = true;
    for (std::uint32_t image = a.image; image <= b.image && free; ++image) {
      const double time = camera.times[image];
      free = !seen.robot_near(between(a, b, time), time, may_hide);
    }
    count(free ? gaps.free : gaps.near_robots, b.image - a.image - 1);
  }
}

bool stray_at(const Observations& seen, std::size_t camera, std::uint32_t image, const world::RobotId& id,
              const Vector2d& place) {
  const auto before = [](const Stray& s, const std::pair<std::size_t, std::uint32_t>& key) {
    return s.camera != key.first ? s.camera < key.first : s.image < key.second;
  };
  auto at = std::lower_bound(seen.strays.begin(), seen.strays.end(), std::pair{camera, image}, before);
  for (; at != seen.strays.end() && at->camera == camera && at->image == image; ++at) {
    if (at->team == id.team && (at->position - place).norm() < same) return true;
  }
  return false;
}

void count_robot(const Observations& seen, world::RobotId id, const Track& track, Gaps& gaps) {
  const CameraImages& camera = seen.cameras[track.camera];
  const auto& all = track.sightings;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Sighting& a = all[i - 1];
    const Sighting& b = all[i];
    if (!seen_well(camera, a, b)) continue;
    std::size_t missed = 0;
    for (std::uint32_t image = a.image + 1; image < b.image; ++image) {
      if (stray_at(seen, track.camera, image, id, between(a, b, camera.times[image]))) {
        count(gaps, missed);  // seen after all
        missed = 0;
      } else {
        ++missed;
      }
    }
    count(gaps, missed);
  }
}

struct Totals {
  double images = 0;
  std::int64_t gaps = 0;
  double share = 0;
};

Totals totals(const Gaps& gaps) {
  Totals t;
  double missed = 0;
  for (std::size_t n = 0; n < gaps.size(); ++n) {
    const auto number = static_cast<double>(gaps[n]);
    t.images += number * static_cast<double>(n + 1);
    missed += number * static_cast<double>(n);
    if (n > 0) t.gaps += gaps[n];
  }
  if (t.images > 0) t.share = missed / t.images;
  return t;
}

void report_gaps(const std::string& what, const Gaps& gaps, Report& report) {
  const std::string prefix = "vision." + what;
  const Totals t = totals(gaps);
  if (t.images < static_cast<double>(enough)) {
    report.lack(prefix + "_missing", what + " losses",
                fmt::format("too few: {:.0f} images; at least {} are needed", t.images, enough));
    return;
  }
  const BurstFit fit = fit_bursts(gaps);
  report.tell(what + " losses, share of all images", "", {t.share, 0, fit.missing.samples},
              fmt::format("{} gaps, the longest of {} images", t.gaps, gaps.size() - 1));
  const std::string missing = what + " missing outside bursts";
  report.add(prefix + "_missing", missing, "", fit.missing,
             fit.start.value > 0 ? "two-state fit of the gaps" : "misses / images: no bursts");
  if (fit.start.value == 0) {
    report.add(prefix + "_burst_start", what + " burst starts, per image", "", fit.start,
               "none: gaps are as single misses make them; the error is the 95 % bound");
    return;
  }
  const auto bursts = static_cast<std::int64_t>(fit.start.value * t.images + 0.5);
  if (bursts < enough_gaps) {
    const std::string why =
        fmt::format("too few: about {} bursts; at least {} are needed", bursts, enough_gaps);
    report.lack(prefix + "_burst_start", what + " burst starts, per image", why);
    report.lack(prefix + "_burst_length", what + " burst length", why);
    return;
  }
  report.add(prefix + "_burst_start", what + " burst starts, per image", "", fit.start,
             fmt::format("two-state fit, about {} bursts", bursts));
  report.add(prefix + "_burst_length", what + " burst length", "images", fit.length, "two-state fit, mean");
}

}  // namespace

void add_losses(const Observations& seen, Report& report) {
  BallGaps ball;
  for (const Track& track : seen.ball) count_ball(seen, track, ball);
  report_gaps("ball", ball.free, report);
  const Totals hidden = totals(ball.near_robots);
  if (hidden.images > 0) {
    report.tell("  with a robot within 0.3 m, share lost", "",
                {hidden.share, 0, static_cast<std::size_t>(hidden.images)},
                "hidden, held or lost: counted apart");
  }
  Gaps robots;
  for (const Robot& robot : seen.robots) {
    for (const Track& track : robot.tracks) count_robot(seen, robot.id, track, robots);
  }
  report_gaps("robot", robots, report);
  for (const CameraImages& camera : seen.cameras) {
    if (camera.frames_lost == 0) continue;
    report.tell(fmt::format("  camera {}: images never received", camera.id), "",
                {static_cast<double>(camera.frames_lost), 0, camera.times.size()},
                "jumps of its frame number; no losses of objects");
  }
}

}  // namespace calibrate
