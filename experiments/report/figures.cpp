#include "experiments/report/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/report/drawing.h"
#include "experiments/report/wording.h"

namespace report {
namespace {

/// For names of files: letters, digits, dash, underscore and dot, not at the front.
std::string plain(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    const bool kept = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                      (letter >= '0' && letter <= '9') || letter == '-' || letter == '_' ||
                      (letter == '.' && !result.empty());
    result += kept ? letter : '-';
  }
  return result;
}

struct Point {
  double x;
  std::string label;
  const Row* row;
};

/// The rows of a sweep or a list of conditions that have games.
struct Points {
  std::string name;
  std::string x_label;
  std::vector<Point> points;
  bool numeric = true;
  const Sweep* sweep = nullptr;
};

constexpr std::size_t labels_side_by_side = 4;

/// Axis of x and its labels.
Drawing start(const Points& points, const char* y_label, Drawing::Range range) {
  Drawing drawing;
  drawing.x_label = points.x_label;
  drawing.y_label = y_label;
  drawing.range = range;
  drawing.lines = points.numeric;
  drawing.turned = !points.numeric && points.points.size() > labels_side_by_side;
  for (const Point& point : points.points) {
    drawing.ticks.push_back({point.x, points.numeric ? fmt::format("{:g}", point.x) : point.label});
  }
  return drawing;
}

/// A number of every point, shifted a little so that bars do not hide each other.
template <class Value>
Drawing::Curve curve(const std::string& title, Drawing::Colour colour, const Points& points, double shift,
                     Value value) {
  const double span = points.points.back().x - points.points.front().x;
  const double step = !points.numeric ? 0.07 : span > 0 ? 0.008 * span : 0.03;
  Drawing::Curve result{title, colour, {}};
  for (const Point& point : points.points) {
    const std::array<double, 3> numbers = value(*point.row);
    if (!std::isfinite(numbers[0])) continue;
    result.points.push_back({point.x + shift * step, numbers[0], numbers[1], numbers[2]});
  }
  return result;
}

std::array<double, 3> with_error(const stats::Mean& mean) {
  return {mean.mean, mean.mean - mean.standard_error, mean.mean + mean.standard_error};
}

std::array<double, 3> of_interval(double value, const stats::Interval& interval) {
  const bool known = std::isfinite(interval.low) && std::isfinite(interval.high);
  return {value, known ? interval.low : value, known ? interval.high : value};
}

Figure goals(const Points& points, const std::string& a, const std::string& b) {
  Drawing drawing = start(points, "goals a game", Drawing::Range::FromZero);
  drawing.curves = {
      curve(a, Drawing::Colour::A, points, -1, [](const Row& row) { return with_error(row.a.goals); }),
      curve(b, Drawing::Colour::B, points, 1, [](const Row& row) { return with_error(row.b.goals); })};
  return {plain(points.name) + "-goals",
          points.name + ": mean goals a game of both teams, bars one standard error", std::move(drawing)};
}

Figure difference(const Points& points) {
  Drawing drawing = start(points, "goals of A minus goals of B, a game", Drawing::Range::Free);
  drawing.zero_line = true;
  drawing.curves = {curve("A - B", Drawing::Colour::A, points, 0, [](const Row& row) {
    return of_interval(row.difference.mean, row.t_test.interval);
  })};
  if (points.sweep != nullptr && points.sweep->trend.known) {
    drawing.trend = {points.sweep->trend.intercept, points.sweep->trend.slope};
  }
  return {plain(points.name) + "-difference",
          points.name + ": A's goal difference a game, bars Student's 95 % intervals over pairs",
          std::move(drawing)};
}

Figure shares(const Points& points) {
  const auto share = [](std::int64_t count, const Row& row) {
    const stats::Interval interval = stats::wilson(count, row.games);
    return std::array<double, 3>{100.0 * static_cast<double>(count) / static_cast<double>(row.games),
                                 100 * interval.low, 100 * interval.high};
  };
  Drawing drawing = start(points, "share of games [%]", Drawing::Range::Percent);
  drawing.curves = {
      curve("A wins", Drawing::Colour::A, points, -1, [&](const Row& row) { return share(row.a.wins, row); }),
      curve("draws", Drawing::Colour::Draw, points, 0, [&](const Row& row) { return share(row.draws, row); }),
      curve("B wins", Drawing::Colour::B, points, 1, [&](const Row& row) { return share(row.b.wins, row); })};
  return {plain(points.name) + "-results",
          points.name + ": shares of wins and draws, bars Wilson's 95 % intervals", std::move(drawing)};
}

/// The same team under every condition, or just the letter.
std::string team_title(char letter, const Points& points) {
  const std::string capital(1, letter == 'a' ? 'A' : 'B');
  const auto name = [&](const Point& point) { return letter == 'a' ? point.row->a.name : point.row->b.name; };
  const std::string first = name(points.points.front());
  for (const Point& point : points.points) {
    if (name(point) != first) return capital;
  }
  return capital + " " + first;
}

}  // namespace

std::vector<Figure> figures(const Summary& summary) {
  std::vector<Points> all;
  for (const Sweep& sweep : summary.sweeps) {
    Points points;
    bool several = false;
    for (const Sweep& other : summary.sweeps)
      several = several || (&other != &sweep && other.name == sweep.name);
    points.name = several ? sweep.name + " " + sweep.key : sweep.name;
    points.x_label = sweep.key;
    points.sweep = &sweep;
    for (std::size_t i = 0; i < sweep.rows.size(); ++i) {
      const Row& row = summary.rows[sweep.rows[i]];
      if (row.games > 0) points.points.push_back({sweep.x[i], row.condition, &row});
    }
    all.push_back(std::move(points));
  }
  Points others;
  others.name = "conditions";
  others.numeric = false;
  for (std::size_t i = 0; i < summary.rows.size(); ++i) {
    if (!summary.header.conditions[i].sweep.empty() || summary.rows[i].games == 0) continue;
    others.points.push_back(
        {static_cast<double>(others.points.size()), summary.rows[i].condition, &summary.rows[i]});
  }
  all.push_back(std::move(others));

  std::vector<Figure> found;
  for (const Points& points : all) {
    if (points.points.empty()) continue;
    found.push_back(goals(points, team_title('a', points), team_title('b', points)));
    found.push_back(difference(points));
    found.push_back(shares(points));
  }
  return found;
}

std::string drawn(const Figure& figure) {
  try {
    return drawn(figure.drawing);
  } catch (const DrawingError& error) {
    throw DrawingError("figure " + figure.name + ": " + error.what());
  }
}

}  // namespace report
