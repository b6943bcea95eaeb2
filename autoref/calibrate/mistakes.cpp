#include "autoref/calibrate/mistakes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace calibrate {
namespace {

constexpr std::size_t enough_false_balls = 10;  // for their lengths
constexpr std::uint32_t pause = 5;              // [images]
constexpr double enough_seconds = 60;           // without any of them the rate is not known to be small
constexpr double enough_robots = 1000;          // sightings
constexpr double same = 0.1;                    // [m] between a robot and its misread pattern, plus motion
constexpr std::size_t enough_areas = 100;

// The lengths of the false balls in a track: after a pause it is another one.
void add_lengths(const Track& track, std::vector<double>& lengths) {
  std::uint32_t first = track.sightings.front().image;
  std::uint32_t last = first;
  for (const Sighting& s : track.sightings) {
    if (s.image - last > pause) {
      lengths.push_back(last - first + 1.0);
      first = s.image;
    }
    last = s.image;
  }
  lengths.push_back(last - first + 1.0);
}

void add_false_balls(const Observations& seen, Report& report) {
  double seconds = 0;
  for (const CameraImages& camera : seen.cameras) seconds += camera.seconds();
  std::vector<double> lengths;
  for (const Track& track : seen.false_balls) add_lengths(track, lengths);
  const auto number = static_cast<double>(lengths.size());
  const std::string name = "false balls, per camera";
  if (seen.ball.empty() || (number == 0 && seconds < enough_seconds)) {
    report.lack("vision.false_ball_rate", name,
                seen.ball.empty() ? "no ball was seen"
                                  : fmt::format("none in {:.0f} s of images; at least {:.0f} s are needed",
                                                seconds, enough_seconds));
    return;
  }
  report.add("vision.false_ball_rate", name, "1/s",
             {number / seconds, std::sqrt(std::max(number, 3.0)) / seconds, lengths.size()},
             "tracks elsewhere than the ball, while it was seen");
  if (lengths.size() < enough_false_balls) {
    const std::string why =
        fmt::format("too few: {} false balls; at least {} are needed", lengths.size(), enough_false_balls);
    report.lack("vision.false_ball_shortest", "false ball, shortest", why);
    report.lack("vision.false_ball_longest", "false ball, longest", why);
    return;
  }
  report.tell("false ball, median length", "images", high_quantile(lengths, 0.5, 1), "median");
  report.add("vision.false_ball_shortest", "false ball, shortest", "images", high_quantile(lengths, 0.025, 1),
             "2.5 % quantile");
  report.add("vision.false_ball_longest", "false ball, longest", "images", high_quantile(lengths, 0.975, 1),
             "97.5 % quantile");
}

void add_numbers(const Observations& seen, Report& report) {
  double right = 0;
  for (const Robot& robot : seen.robots) right += static_cast<double>(robot.path.size());
  double misread = 0;
  double unread = 0;
  for (const Stray& stray : seen.strays) {
    const double time = seen.cameras[stray.camera].times[stray.image];
    const bool known = std::ranges::any_of(seen.robots, [&](const Robot& robot) {
      if (robot.id.team != stray.team) return false;
      const auto place = Observations::position_of(robot, time);
      return place && (*place - stray.position).norm() < same;
    });
    if (known) (stray.numbered ? misread : unread) += 1;
  }
  const double all = right + misread + unread;
  const auto add = [&](std::string_view key, const std::string& name, double number) {
    if (all < enough_robots) {
      report.lack(key, name,
                  fmt::format("too few: {:.0f} patterns; at least {:.0f} are needed", all, enough_robots));
      return;
    }
    report.add(key, name, "",
               {number / all, std::sqrt(std::max(number, 3.0)) / all, static_cast<std::size_t>(all)},
               fmt::format("{:.0f} patterns where a robot with another number was", number));
  };
  add("vision.misread_id", "robot given another number, per image", misread);
  add("vision.unread_id", "robot given no number, per image", unread);
}

void add_area(const Observations& seen, Report& report) {
  std::vector<double> differences;
  bool any = false;
  for (const Track& track : seen.ball) {
    for (std::size_t i = 1; i < track.sightings.size(); ++i) {
      const Sighting& a = track.sightings[i - 1];
      const Sighting& b = track.sightings[i];
      any |= b.area > 0;
      if (b.image == a.image + 1) {
        differences.push_back((static_cast<double>(b.area) - static_cast<double>(a.area)) / std::sqrt(2.0));
      }
    }
  }
  if (!any || differences.size() < enough_areas) {
    report.lack("vision.area_sigma", "ball area noise",
                any ? fmt::format("too few: {} pairs of images; at least {} are needed", differences.size(),
                                  enough_areas)
                    : "every area in the log is 0");
    return;
  }
  // Areas are whole numbers: spread them over the width of their rounding, or the median moves in steps.
  for (std::size_t i = 0; i < differences.size(); ++i) {
    differences[i] += (static_cast<double>(i % 101) / 100 - 0.5) / std::sqrt(2.0);
  }
  report.add("vision.area_sigma", "ball area noise", "px", spread(differences, 1.5),
             "robust spread of differences between images, over sqrt 2");
}

}  // namespace

void add_mistakes(const Observations& seen, Report& report) {
  add_false_balls(seen, report);
  add_numbers(seen, report);
  add_area(seen, report);
}

}  // namespace calibrate
