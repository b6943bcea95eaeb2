#include "autoref/calibrate/ball.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "autoref/calibrate/ball_fit.h"

namespace calibrate {
namespace {

constexpr double contact = 0.15;       // [m] to a robot's centre: radius, ball and 4 cm
constexpr double slowest = 0.2;        // [m/s]
constexpr double longest_gap = 0.1;    // [s]
constexpr double shortest = 0.25;      // [s] of a piece
constexpr double shortest_roll = 0.4;  // [s] of one in a single phase
constexpr std::size_t fewest = 10;     // sightings of a piece
constexpr double hardest = 12;         // [m/s^2] more is a kick or a bounce; sliding reaches 5
constexpr double least_slide = 1.5;    // [m/s^2]
constexpr double most_roll = 1.0;      // [m/s^2]
constexpr double most_bend = 0.003;    // [m] rms of residuals
constexpr std::size_t enough = 3;      // pieces
constexpr double kick = 1.0;           // [m/s] slower starts are not called kicks
constexpr std::size_t enough_kicks = 5;
constexpr double way_back = 0.005;  // error of a speed followed back to the robot (README)

struct Piece {
  std::span<const Sighting> sightings;
  double start_gap = 0;  // [m] from the last sighting before a kick, which came within 0.1 s; 0: no kick
};

double speed_between(const Sighting& a, const Sighting& b) {
  return (b.position - a.position).norm() / (b.time - a.time);
}

// The ball was struck or held between these sightings, or nobody knows.
bool struck(const Sighting& a, const Sighting& b, const Sighting& c, double sigma) {
  const double first = b.time - a.time;
  const double second = c.time - b.time;
  if (first > longest_gap || second > longest_gap) return true;
  const world::Vector2d change = (c.position - b.position) / second - (b.position - a.position) / first;
  const double mean = (first + second) / 2;
  return change.norm() > hardest * mean + 6 * sigma * 2.45 / mean;  // sqrt(6) sigma: of a second difference
}

std::vector<Piece> pieces_of(const Observations& seen, const Track& track, double sigma) {
  const auto& all = track.sightings;
  const std::span<const Sighting> sightings(all);
  std::vector<bool> free(all.size());
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    const std::size_t before = i >= 3 ? i - 3 : 0;
    const std::size_t after = std::min(i + 3, all.size() - 1);
    free[i] = speed_between(all[before], all[after]) > slowest &&
              !struck(all[i - 1], all[i], all[i + 1], sigma) &&
              !seen.robot_near(all[i].position, all[i].time, contact);
  }
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i;
    while (end < all.size() && free[end]) ++end;
    if (end - i >= fewest && all[end - 1].time - all[i].time >= shortest) {
      Piece piece{sightings.subspan(i, end - i)};
      if (i > 0 && all[i].time - all[i - 1].time < longest_gap &&
          seen.robot_near(all[i - 1].position, all[i - 1].time, contact + 0.05)) {
        piece.start_gap = std::max((all[i].position - all[i - 1].position).norm(), 1e-6);
      }
      pieces.push_back(piece);
    }
    i = end + 1;
  }
  return pieces;
}

void add_deceleration(std::string_view key, const std::string& name, const std::vector<Estimate>& found,
                      const std::string& what, Report& report) {
  if (found.size() < enough) {
    report.lack(key, name, fmt::format("too few: {} {}; at least {} are needed", found.size(), what, enough));
    return;
  }
  report.add(key, name, "m/s^2", combined(found), what);
}

}  // namespace

void add_ball(const Observations& seen, const Noise& noise, Report& report) {
  std::vector<Estimate> slides;
  std::vector<Estimate> rolls;
  std::vector<double> switches;
  std::vector<Estimate> kicks;
  std::size_t bent = 0;
  const double most = std::max(3 * noise.ball, most_bend);
  for (const Track& track : seen.ball) {
    for (const Piece& piece : pieces_of(seen, track, noise.ball)) {
      const BallFit fit = fit_ball(piece.sightings);
      if (fit.along > most || fit.across > most || fit.first.value < -0.3) {
        ++bent;
        continue;
      }
      const double seconds = piece.sightings.back().time - piece.sightings.front().time;
      if (fit.second) {
        if (fit.first.value > least_slide) slides.push_back(fit.first);
        if (fit.second->value < most_roll) rolls.push_back(*fit.second);
      } else if (fit.first.value > least_slide) {
        slides.push_back(fit.first);
      } else if (fit.first.value < most_roll && seconds > shortest_roll) {
        rolls.push_back(fit.first);
      }
      if (piece.start_gap == 0 || fit.speed.value < kick || fit.first.value < least_slide) continue;
      // Back to the robot, where the ball was before.
      const double speed =
          std::sqrt(fit.speed.value * fit.speed.value + 2 * fit.first.value * piece.start_gap);
      kicks.push_back({speed, std::hypot(fit.speed.error, way_back * speed), 1});
      if (fit.second) switches.push_back(fit.switch_speed / speed);
    }
  }
  add_deceleration("ball.slide_deceleration", "ball deceleration, sliding", slides,
                   "pieces of straight ways that begin fast", report);
  add_deceleration("ball.roll_deceleration", "ball deceleration, rolling", rolls,
                   "pieces of straight ways that roll", report);
  if (switches.size() >= enough) {
    report.tell("rolling begins at this share of the kick", "", high_quantile(switches, 0.5, 1),
                "median over kicks in two phases; a solid ball without spin: 0.714");
  }
  if (kicks.size() < enough_kicks) {
    report.lack("robots.max_kick_speed", "fastest kick",
                fmt::format("too few: {} kicks; at least {} are needed", kicks.size(), enough_kicks));
  } else {
    Estimate fastest = *std::ranges::max_element(kicks, {}, &Estimate::value);
    fastest.samples = kicks.size();
    report.add("robots.max_kick_speed", "fastest kick", "m/s", fastest,
               "fastest seen, flat, followed back to the robot");
  }
  report.tell("pieces of the ball's way left out", "",
              {static_cast<double>(bent), 0, bent + slides.size() + rolls.size()},
              "neither straight nor evenly braked: chips, deflections");
}

}  // namespace calibrate
