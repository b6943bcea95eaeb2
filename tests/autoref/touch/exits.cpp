#include "tests/autoref/touch/exits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace study {

using world::Location;
using world::TouchAlgorithms;

namespace {

constexpr double nearest_reach = 0.15;  // [m] hull centre to ball (football.md 4.2)
constexpr double robot_height = 0.15;   // [m]
constexpr world::Duration one_tick = std::chrono::microseconds{16'667};
constexpr int frames_outside = 3;  // observed ones, as the referee counts them (Algorithm 2)
constexpr world::Duration longest_wait = std::chrono::seconds{1};  // for them

bool right(const Exit& exit, std::size_t witness) {
  const auto& said = exit.said[witness];
  return said && said->robot.team == exit.toucher.team;
}

}  // namespace

Witness::Witness(std::string name, const world::Field& field, TouchAlgorithms algorithms)
    : name_(std::move(name)), field_(field), detector_(std::in_place, field, algorithms) {}

Witness Witness::nearest(const world::Field& field) {
  Witness witness("nearest robot", field, {});
  witness.detector_.reset();
  return witness;
}

void Witness::update(const world::TrackedFrame& frame, std::span<const world::Detection> images,
                     std::optional<world::Time> play_began) {
  if (detector_) {
    if (frame.time <= last_frame_) detector_->reset();
    detector_->update(frame, images, found_);
  } else if (found_.clear(); frame.ball) {
    const world::Vector2d ball = frame.ball->position.head<2>();
    const auto distance = [&](const world::TrackedRobot& robot) { return (robot.position - ball).norm(); };
    const auto closest = std::ranges::min_element(frame.robots, {}, distance);
    if (closest != frame.robots.end() && distance(*closest) < nearest_reach) {
      found_.push_back({closest->id, frame.time, ball});
    }
  }
  last_frame_ = frame.time;
  if (!play_began) return;
  for (const world::Touch& touch : found_) {  // as the referee does: detectors::BallTouched
    if (touch.time < *play_began) continue;
    if (world::distance_outside_lines(field_, touch.position) > field_.ball_radius) continue;
    last_ = touch;
  }
}

void Witness::begin(std::optional<world::RobotId> kicker, world::Time when) {
  last_.reset();
  if (!kicker) return;
  last_.emplace();
  last_->robot = *kicker;
  last_->time = when;
}

ExitStudy::ExitStudy(const world::Field& field, std::vector<Witness> witnesses)
    : field_(field), witnesses_(std::move(witnesses)) {}

void ExitStudy::tick(const truth::Frame& truth, const world::TrackedFrame* frame,
                     std::span<const world::Detection> images, const world::GameState& state) {
  touches_.add(truth);
  if (state.location == Location::GameOn && location_ != Location::GameOn) {
    armed_ = true;
    // The referee knows who took the kick, whatever the witness saw.
    for (Witness& witness : witnesses_) witness.begin(state.kicker, state.location_time);
  }
  // The touches of the tick that ends play still count: the referee looks at them first (I-29).
  const bool in_play = state.location == Location::GameOn || location_ == Location::GameOn;
  if (state.location == Location::GameOn) play_began_ = state.location_time;
  location_ = state.location;
  if (frame) {
    for (Witness& witness : witnesses_) witness.update(*frame, images, in_play ? play_began_ : std::nullopt);
  }
  if (pending_ && frame) decide(*frame);

  const world::Vector2d ball = truth.ball.position.head<2>();
  if (!armed_ || world::distance_outside_lines(field_, ball) <= field_.ball_radius) return;
  armed_ = false;
  if (location_ != Location::GameOn || !touches_.last()) return;
  const TrueTouch& last = *touches_.last();
  Exit exit;
  exit.time = truth.time;
  exit.toucher = *touches_.toucher();
  exit.kind = last.kind();
  exit.chip = last.highest > robot_height;
  exit.earlier = world::seconds(truth.time - last.end);
  exit.at_line = exit.earlier < 0.034;
  exit.goal = std::abs(ball.x()) > field_.half_length() && std::abs(ball.y()) < field_.goal_width / 2 &&
              truth.ball.position.z() < field_.goal_height;
  const auto& by_team = touches_.by_team();
  if (by_team.yellow && by_team.blue) {
    const world::Duration between = *by_team.yellow - *by_team.blue;
    exit.ambiguous = between <= one_tick && -between <= one_tick;
  }
  pending_ = exit;
  seen_outside_ = 0;
}

void ExitStudy::decide(const world::TrackedFrame& frame) {
  if (frame.time > pending_->time + longest_wait) pending_.reset();  // the referee saw no exit
  if (!pending_ || !frame.ball || !frame.ball->observed) return;
  const bool outside =
      world::distance_outside_lines(field_, frame.ball->position.head<2>()) > field_.ball_radius;
  seen_outside_ = outside ? seen_outside_ + 1 : 0;
  if (seen_outside_ < frames_outside) return;
  for (const Witness& witness : witnesses_) pending_->said.push_back(witness.last());
  exits_.push_back(*std::move(pending_));
  pending_.reset();
}

std::vector<Witness> all_witnesses(const world::Field& field) {
  std::vector<Witness> all;
  const auto add = [&](const char* name, const TouchAlgorithms& algorithms) {
    all.emplace_back(name, field, algorithms);
  };
  add("accel", {.accel = true});
  add("accel + line", {.accel = true, .line = true});
  add("accel + backtrack", {.accel = true, .backtrack = true});
  add("all three", {.accel = true, .line = true, .backtrack = true});
  add("all three, as coded", {.accel = true, .line = true, .backtrack = true, .as_coded = true});
  add("three + reach", {.accel = true, .line = true, .backtrack = true, .reach = true});
  add("likelihood", {.likelihood = true});
  all.push_back(Witness::nearest(field));
  return all;
}

Interval wilson(int successes, int n) {
  if (n == 0) return {};
  constexpr double z = 1.96;
  const double p = static_cast<double>(successes) / n;
  const double centre = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z * std::sqrt(p * (1 - p) / n + z * z / (4.0 * n * n)) / (1 + z * z / n);
  return {centre - half, centre + half};
}

double mcnemar(int b, int c) {
  const int n = b + c;
  double sum = 0;
  for (int k = 0; k <= std::min(b, c); ++k) {
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) - n * std::log(2.0));
  }
  return std::min(1.0, 2 * sum);
}

namespace {

/// The columns of the table: a name, and which exits belong to it.
struct Column {
  std::string name;
  std::function<bool(const Exit&)> counts;
};

std::vector<Column> columns() {
  const auto clear = [](const Exit& e) { return !e.ambiguous && !e.goal; };
  std::vector<Column> all;
  all.push_back({"at the line", [=](const Exit& e) { return clear(e) && e.at_line; }});
  for (int k = 0; k < kinds; ++k) {
    const Kind kind = static_cast<Kind>(k);
    all.push_back(
        {study::name(kind), [=](const Exit& e) { return clear(e) && !e.at_line && e.kind == kind; }});
  }
  all.push_back({"chip", [=](const Exit& e) { return clear(e) && !e.at_line && e.chip; }});
  all.push_back({"ambiguous", [](const Exit& e) { return e.ambiguous && !e.goal; }});
  all.push_back({"goal", [](const Exit& e) { return !e.ambiguous && e.goal; }});
  return all;
}

}  // namespace

std::string table(const std::vector<Exit>& exits, const std::vector<Witness>& witnesses) {
  const auto count = [&](std::size_t w, const std::function<bool(const Exit&)>& counts) {
    int n = 0;
    int good = 0;
    for (const Exit& exit : exits) {
      if (!counts(exit)) continue;
      ++n;
      good += right(exit, w);
    }
    return std::pair{good, n};
  };
  const auto clear = [](const Exit& e) { return !e.ambiguous && !e.goal; };
  const auto three = std::ranges::find(witnesses, "all three", &Witness::name) - witnesses.begin();

  std::string text = "| | right | 95 % | p against all three |";
  std::string rule = "|---|---|---|---|";
  for (const Column& column : columns()) {
    text += fmt::format(" {} |", column.name);
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  for (std::size_t w = 0; w < witnesses.size(); ++w) {
    const auto [good, n] = count(w, clear);
    const Interval interval = wilson(good, n);
    int only_it = 0;
    int only_three = 0;
    for (const Exit& exit : exits) {
      if (!clear(exit)) continue;
      const bool its = right(exit, w);
      const bool theirs = right(exit, static_cast<std::size_t>(three));
      only_it += its && !theirs;
      only_three += theirs && !its;
    }
    text += fmt::format("| {} | {}/{} = {:.3f} | {:.3f} to {:.3f} | {:.2g} |", witnesses[w].name(), good, n,
                        n > 0 ? static_cast<double>(good) / n : 0, interval.low, interval.high,
                        mcnemar(only_it, only_three));
    for (const Column& column : columns()) {
      const auto [g, m] = count(w, column.counts);
      text += fmt::format(" {}/{} |", g, m);
    }
    text += "\n";
  }
  return text;
}

std::string calibration(const std::vector<Exit>& exits, const std::vector<Witness>& witnesses) {
  const auto it = std::ranges::find(witnesses, "likelihood", &Witness::name);
  if (it == witnesses.end()) return "";
  const auto w = static_cast<std::size_t>(it - witnesses.begin());
  constexpr std::array bounds = {0.0, 0.5, 0.7, 0.9, 0.97, 1.0001};
  std::string text = "| probability said | exits | right team |\n|---|---|---|\n";
  for (std::size_t b = 0; b + 1 < bounds.size(); ++b) {
    int n = 0;
    int good = 0;
    for (const Exit& exit : exits) {
      if (exit.ambiguous || exit.goal || !exit.said[w]) continue;
      const double p = exit.said[w]->probability;
      if (p < bounds[b] || p >= bounds[b + 1]) continue;
      ++n;
      good += right(exit, w);
    }
    text += fmt::format("| {:.2f} to {:.2f} | {} | {:.2f} |\n", bounds[b], std::min(bounds[b + 1], 1.0), n,
                        n > 0 ? static_cast<double>(good) / n : 0);
  }
  return text;
}

}  // namespace study
