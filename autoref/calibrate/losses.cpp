#include "autoref/calibrate/losses.h"

#include <fmt/format.h>

#include <algorithm>

namespace calibrate {
namespace {

using world::Vector2d;

constexpr double longest = 4;     // [s] a longer absence may have other reasons
constexpr double may_hide = 0.3;  // [m] radius of a robot, of the ball, and a shadow of 0.16 m
constexpr double same = 0.1;      // [m] a stray number nearer to a lost robot is that robot
constexpr double enough = 500;    // images
constexpr std::int64_t enough_bursts = 5;

// The place of the track at an instant between two sightings.
Vector2d between(const Sighting& a, const Sighting& b, double time) {
  return a.position + (b.position - a.position) * ((time - a.time) / (b.time - a.time));
}

bool stray_at(const Observations& seen, std::size_t camera, std::uint32_t image, world::Team team,
              const Vector2d& place) {
  const auto before = [](const Stray& s, const std::pair<std::size_t, std::uint32_t>& key) {
    return s.camera != key.first ? s.camera < key.first : s.image < key.second;
  };
  auto at = std::lower_bound(seen.strays.begin(), seen.strays.end(), std::pair{camera, image}, before);
  for (; at != seen.strays.end() && at->camera == camera && at->image == image; ++at) {
    if (at->team == team && (at->position - place).norm() < same) return true;
  }
  return false;
}

// Counts the gaps of a track. From each sighting that counts, the images are followed up to the next one. A
// gap stays open where it comes to a place that does not count, and when the object could have left the
// camera's view at one and a half times its speed. So long gaps count as well as short ones.
//
// counts(place, time)      the object should be seen there
// otherwise(image, place)  it was seen, under another name
void count_gaps(const CameraImages& camera, const Track& track, auto&& counts, auto&& otherwise, Gaps& gaps) {
  const auto& all = track.sightings;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Sighting& a = all[i - 1];
    const Sighting& b = all[i];
    if (b.time - a.time > longest || !counts(a.position, a.time)) continue;
    if (camera.inside(b.position) <= 0) continue;  // it may come from outside, or be another one
    const double speed = 1.5 * velocity_before(track, i - 1).norm() + 0.2;
    const double seen_until = a.time + std::max(camera.inside(a.position) / speed, 0.0);
    std::size_t missed = 0;
    bool open = false;
    for (std::uint32_t image = a.image + 1; image <= b.image && !open; ++image) {
      const double time = camera.times[image];
      const Vector2d place = between(a, b, time);
      const bool next = image == a.image + 1 && image == b.image;  // nothing missed: nothing to doubt
      if (!counts(place, time) || (time > seen_until && !next)) {
        open = true;
      } else if (image < b.image && otherwise(image, place)) {
        gaps.add(missed);
        missed = 0;
      } else if (image < b.image) {
        ++missed;
      }
    }
    gaps.add(missed, open);
  }
}

void report_gaps(const std::string& what, const Gaps& gaps, Report& report) {
  const std::string prefix = "vision." + what;
  const double images = gaps.seen() + gaps.missed();
  if (images < enough) {
    const std::string why = fmt::format("too few: {:.0f} images; at least {:.0f} are needed", images, enough);
    report.lack(prefix + "_missing", what + " missing outside bursts", why);
    report.lack(prefix + "_burst_start", what + " burst starts, per image", why);
    return;
  }
  const BurstFit fit = fit_bursts(gaps);
  report.tell(what + " losses, share of all images", "", {gaps.missed() / images, 0, fit.missing.samples},
              fmt::format("the longest of {} images", std::max(gaps.ended.size(), gaps.open.size()) - 1));
  const std::string missing = what + " missing outside bursts";
  report.add(prefix + "_missing", missing, "", fit.missing,
             fit.start.value > 0 ? "two-state fit of the gaps" : "misses / images: no bursts");
  if (fit.start.value == 0) {
    report.add(prefix + "_burst_start", what + " burst starts, per image", "", fit.start,
               "none: gaps are as single misses make them; the error is the 95 % bound");
    return;
  }
  const auto bursts = static_cast<std::int64_t>(fit.start.value * gaps.seen() + 0.5);
  if (bursts < enough_bursts) {
    const std::string why =
        fmt::format("too few: about {} bursts; at least {} are needed", bursts, enough_bursts);
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
  Gaps ball;
  Gaps hidden;
  const auto never = [](std::uint32_t, const Vector2d&) { return false; };
  for (const Track& track : seen.ball) {
    const CameraImages& camera = seen.cameras[track.camera];
    const auto covered = [&](const Vector2d& place, double time) {
      return seen.robot_near(place, time, may_hide);
    };
    count_gaps(
        camera, track,
        [&](const Vector2d& place, double time) { return camera.inside(place) > 0 && !covered(place, time); },
        never, ball);
    count_gaps(
        camera, track,
        [&](const Vector2d& place, double time) { return camera.inside(place) > 0 && covered(place, time); },
        never, hidden);
  }
  report_gaps("ball", ball, report);
  const double images = hidden.seen() + hidden.missed();
  if (images > 0) {
    report.tell("  with a robot within 0.3 m, share lost", "",
                {hidden.missed() / images, 0, static_cast<std::size_t>(images)},
                "hidden, held or lost: counted apart");
  }
  Gaps robots;
  for (const Robot& robot : seen.robots) {
    for (const Track& track : robot.tracks) {
      const CameraImages& camera = seen.cameras[track.camera];
      count_gaps(
          camera, track, [&](const Vector2d& place, double) { return camera.inside(place) > 0; },
          [&](std::uint32_t image, const Vector2d& place) {
            return stray_at(seen, track.camera, image, robot.id.team, place);
          },
          robots);
    }
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
