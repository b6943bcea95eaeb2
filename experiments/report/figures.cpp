#include "experiments/report/figures.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>

#include "experiments/report/wording.h"

namespace report {
namespace {

// Colours of Okabe and Ito, told apart by everyone.
constexpr const char* colour_a = "#0072B2";
constexpr const char* colour_b = "#D55E00";
constexpr const char* colour_draw = "#7F7F7F";

/// A text in gnuplot's double quotes, with nothing in it special.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    result += letter == '\n' ? ' ' : letter;
  }
  return result + "\"";
}

/// For names of files: letters, digits, dash, underscore and dot.
std::string plain(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    const bool kept = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                      (letter >= '0' && letter <= '9') || letter == '-' || letter == '_' || letter == '.';
    result += kept ? letter : '-';
  }
  return result;
}

std::string frame(const std::string& x_label, const std::string& y_label) {
  return "set terminal svg size 720,440 dynamic enhanced font 'Helvetica,14' background rgb 'white'\n"
         "set encoding utf8\nset termoption noenhanced\n"
         "set border 3 lc rgb '#555555'\nset tics nomirror\nset grid ytics lc rgb '#DDDDDD' lt 1\n"
         "set key outside top center horizontal\nset errorbars small\n"
         "set xlabel " +
         quoted(x_label) + "\nset ylabel " + quoted(y_label) + "\n";
}

/// The range of x with room at both ends.
std::string x_range(double low, double high) {
  const double room = high > low ? 0.06 * (high - low) : 0.5;
  return fmt::format("set xrange [{}:{}]\n", low - room, high + room);
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

std::string ticks(const Points& points) {
  std::string text = "set xtics (";
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const Point& point = points.points[i];
    text += fmt::format("{}{} {}", i > 0 ? ", " : "",
                        quoted(points.numeric ? fmt::format("{:g}", point.x) : point.label), point.x);
  }
  text += ")";
  return text + (points.numeric || points.points.size() < 5 ? "\n" : " rotate by -30\n");
}

std::string start(const Points& points, const std::string& y_label) {
  return frame(points.x_label, y_label) + x_range(points.points.front().x, points.points.back().x) +
         ticks(points);
}

/// A named block of lines "x y low high", shifted a little so that bars do not hide each other.
template <class Value>
std::string block(const std::string& name, const Points& points, double shift, Value value) {
  const double span = points.points.back().x - points.points.front().x;
  const double step = span > 0 ? 0.008 * span : 0.03;
  std::string text = "$" + name + " << EOD\n";
  for (const Point& point : points.points) {
    const std::array<double, 3> numbers = value(*point.row);
    if (!std::isfinite(numbers[0])) continue;
    text += fmt::format("{} {} {} {}\n", point.x + shift * step, numbers[0], numbers[1], numbers[2]);
  }
  return text + "EOD\n";
}

std::array<double, 3> with_error(const stats::Mean& mean) {
  return {mean.mean, mean.mean - mean.standard_error, mean.mean + mean.standard_error};
}

std::array<double, 3> of_interval(double value, const stats::Interval& interval) {
  const bool known = std::isfinite(interval.low) && std::isfinite(interval.high);
  return {value, known ? interval.low : value, known ? interval.high : value};
}

std::string curve(const std::string& name, const std::string& title, const char* colour,
                  const Points& points) {
  const char* lines = points.numeric ? "with lines" : "with points pt 0";
  return fmt::format(
      "${0} using 1:2 {1} lc rgb '{2}' lw 1.5 notitle, ${0} using 1:2:3:4 with yerrorbars lc rgb '{2}' "
      "pt 7 ps 0.7 lw 1.5 title {3}",
      name, lines, colour, quoted(title));
}

Figure goals(const Points& points, const std::string& a, const std::string& b) {
  std::string script = start(points, "goals a game") + "set yrange [0:*]\n";
  script += block("a", points, -1, [](const Row& row) { return with_error(row.a.goals); });
  script += block("b", points, 1, [](const Row& row) { return with_error(row.b.goals); });
  script += "plot " + curve("a", a, colour_a, points) + ", " + curve("b", b, colour_b, points) + "\n";
  return {plain(points.name) + "-goals",
          points.name + ": mean goals a game of both teams, bars one standard error", script};
}

Figure difference(const Points& points) {
  std::string script = start(points, "goals of A minus goals of B, a game");
  script += block("d", points, 0,
                  [](const Row& row) { return of_interval(row.difference.mean, row.t_test.interval); });
  script += "plot 0 lc rgb '#999999' lw 1 notitle, " + curve("d", "A - B", colour_a, points);
  if (points.sweep != nullptr && points.sweep->trend.known) {
    script += fmt::format(", {} + {} * x lc rgb '#999999' dt 2 lw 1.5 title 'trend'",
                          points.sweep->trend.intercept, points.sweep->trend.slope);
  }
  return {plain(points.name) + "-difference",
          points.name + ": A's goal difference a game, bars Student's 95 % intervals over pairs",
          script + "\n"};
}

Figure shares(const Points& points) {
  const auto share = [](std::int64_t count, const Row& row) {
    const stats::Interval interval = stats::wilson(count, row.games);
    return std::array<double, 3>{100.0 * static_cast<double>(count) / static_cast<double>(row.games),
                                 100 * interval.low, 100 * interval.high};
  };
  std::string script = start(points, "share of games [%]") + "set yrange [0:100]\n";
  script += block("a", points, -1, [&](const Row& row) { return share(row.a.wins, row); });
  script += block("n", points, 0, [&](const Row& row) { return share(row.draws, row); });
  script += block("b", points, 1, [&](const Row& row) { return share(row.b.wins, row); });
  script += "plot " + curve("a", "A wins", colour_a, points) + ", " +
            curve("n", "draws", colour_draw, points) + ", " + curve("b", "B wins", colour_b, points) + "\n";
  return {plain(points.name) + "-results",
          points.name + ": shares of wins and draws, bars Wilson's 95 % intervals", script};
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
  // The script goes through a file: a pipe for each direction would need a process of our own.
  std::string name = (std::filesystem::temp_directory_path() / "matchday-figure-XXXXXX").string();
  const int descriptor = ::mkstemp(name.data());
  if (descriptor < 0) throw DrawingError("figures: no file can be written in the system's temporary folder");
  ::close(descriptor);
  struct Remove {
    std::string name;
    ~Remove() { std::remove(name.c_str()); }
  } const remove{name};
  std::ofstream(name) << figure.script;

  struct Close {
    void operator()(FILE* pipe) const { ::pclose(pipe); }
  };
  std::unique_ptr<FILE, Close> pipe(::popen(("gnuplot '" + name + "' 2>/dev/null").c_str(), "r"));
  if (!pipe) throw DrawingError("figures: no process can be started");
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get()))
    text.append(buffer.data(), count);
  const int status = ::pclose(pipe.release());
  constexpr int not_found = 127;  // as the shell says it
  if (WIFEXITED(status) && WEXITSTATUS(status) == not_found) {
    throw DrawingError("figures are drawn by gnuplot, which is not installed; scripts/install installs it");
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || text.find("</svg>") == std::string::npos) {
    throw DrawingError("figure " + figure.name + ": gnuplot did not draw it");
  }
  return text;
}

}  // namespace report
