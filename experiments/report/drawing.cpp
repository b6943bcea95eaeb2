#include "experiments/report/drawing.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <string_view>

#include "experiments/process/filter.h"
#include "experiments/report/markup.h"
#include "sim/console/printable.h"

// gnuplot executes what stands between backticks in a double-quoted text, expands macros and reads names of
// files as commands. So the scripts are fixed, the numbers are on its standard input, and in the place of
// every text stands another there: one character of Unicode's private use, a different one for each, as often
// as the text is long. The texts come into the SVG afterwards.
namespace report {
namespace {

constexpr std::size_t longest_text = 40;   // characters; ours: labels of an axis stand beside each other
constexpr std::size_t longest_title = 30;  // ours: gnuplot leaves out a legend that is wider than the figure
constexpr char32_t first_stand_in = 0xE000;             // of the Private Use Area
constexpr std::size_t stand_ins = 0xF8FF - 0xE000 + 1;  // its size
constexpr std::chrono::seconds patience{60};            // ours: usual is 0.1 s

std::string utf8(char32_t code) {  // of three bytes
  return {static_cast<char>(0xE0U | (code >> 12)), static_cast<char>(0x80U | ((code >> 6) & 0x3FU)),
          static_cast<char>(0x80U | (code & 0x3FU))};
}

/// The texts of a drawing and what stands in their place meanwhile.
class Texts {
 public:
  std::string stand_in(const std::string& text, std::size_t most = longest_text) {
    if (texts_.size() >= stand_ins)
      throw DrawingError("has more than " + std::to_string(stand_ins) + " texts");
    texts_.push_back(console::shortened(console::printable(text), most));
    const std::string one = utf8(first_stand_in + static_cast<char32_t>(texts_.size() - 1));
    std::string many;
    for (std::size_t i = 0; i < console::length(texts_.back()); ++i) many += one;
    return many;
  }

  /// The SVG with the texts in it, each once where its stand-ins are.
  std::string put_into(std::string_view svg) const {
    std::string result;
    char32_t before = 0;
    while (!svg.empty()) {
      const char32_t code = code_of(svg);
      if (code == 0) {
        result += svg.front();
        svg.remove_prefix(1);
      } else {
        if (code != before) result += escaped(texts_[code - first_stand_in]);
        svg.remove_prefix(3);
      }
      before = code;
    }
    return result;
  }

 private:
  /// The stand-in that a text begins with; 0: none.
  char32_t code_of(std::string_view text) const {
    if (text.size() < 3 || (text[0] != '\xEE' && text[0] != '\xEF')) return 0;
    const auto bits = [&](std::size_t i) { return static_cast<char32_t>(text[i]) & 0x3FU; };
    const char32_t code = (static_cast<char32_t>(text[0]) & 0x0FU) << 12 | bits(1) << 6 | bits(2);
    return code >= first_stand_in && code - first_stand_in < texts_.size() ? code : 0;
  }

  std::vector<std::string> texts_;
};

// Blocks of the data, with two empty lines between: span of x, ticks, trend, curves.
constexpr int first_curve = 3;

std::string data_of(const Drawing& drawing, Texts& texts) {
  const double low = drawing.ticks.front().x;
  const double high = drawing.ticks.back().x;
  const double room = high > low ? 0.06 * (high - low) : 0.5;
  constexpr const char* next = "\n\n";
  std::string data = fmt::format("{}\n{}\n", low - room, high + room) + next;
  for (const Drawing::Tick& tick : drawing.ticks)
    data += fmt::format("{}\t{}\n", tick.x, texts.stand_in(tick.label));
  data += next;
  const Drawing::Line trend = drawing.trend.value_or(Drawing::Line{0, 0});
  for (const double x : {low - room, high + room})
    data += fmt::format("{}\t{}\n", x, trend.at_zero + trend.slope * x);
  for (const Drawing::Curve& curve : drawing.curves) {
    data += fmt::format("{}x\t{}\n", next, texts.stand_in(curve.title, longest_title));
    for (const Drawing::Value& point : curve.points)
      data += fmt::format("{}\t{}\t{}\t{}\n", point.x, point.y, point.low, point.high);
    if (curve.points.empty()) data += "nan\tnan\tnan\tnan\n";  // a block must be there
  }
  return data;
}

const char* range_of(Drawing::Range range) {
  switch (range) {
    case Drawing::Range::Free:
      return "";
    case Drawing::Range::FromZero:
      return "set yrange [0:*];";
    case Drawing::Range::Percent:
      return "set yrange [0:100];";
  }
  return "";
}

/// Colours of Okabe and Ito, told apart by everyone.
const char* name_of(Drawing::Colour colour) {
  switch (colour) {
    case Drawing::Colour::A:
      return "#0072B2";
    case Drawing::Colour::B:
      return "#D55E00";
    case Drawing::Colour::Draw:
      return "#7F7F7F";
  }
  return "";
}

/// Pieces that stand here, nothing else.
std::string script_of(const Drawing& drawing, Texts& texts) {
  std::string script =
      "set terminal svg size 720,440 dynamic enhanced font 'Helvetica,14' background rgb 'white';"
      "set encoding utf8; set termoption noenhanced; set datafile separator \"\\t\";"
      "set border 3 lc rgb '#555555'; set tics nomirror; set grid ytics lc rgb '#DDDDDD' lt 1;"
      "set key outside top center horizontal; set errorbars small; set pointintervalbox 0;"
      "stats '/dev/stdin' index 0 using 1 nooutput; set xrange [STATS_min:STATS_max];";
  script += range_of(drawing.range);
  if (drawing.turned) script += "set xtics rotate by -30;";
  script += "set xlabel '" + texts.stand_in(drawing.x_label) + "';";
  script += "set ylabel '" + texts.stand_in(drawing.y_label) + "';";
  script += "plot '/dev/stdin' index 1 using 1:(NaN):xticlabels(2) with points pt 0 notitle";
  if (drawing.zero_line) script += ", 0 lc rgb '#999999' lw 1 notitle";
  for (std::size_t i = 0; i < drawing.curves.size(); ++i) {
    const std::string block = fmt::format(", '' index {} using ", first_curve + i);
    const std::string colour = fmt::format(" lc rgb '{}' ", name_of(drawing.curves[i].colour));
    if (drawing.lines) script += block + "1:2 with lines" + colour + "lw 1.5 notitle";
    script += block + "1:2:3:4 with yerrorbars" + colour + "pt 7 ps 0.7 lw 1.5 title columnheader(2)";
  }
  if (drawing.trend) script += ", '' index 2 using 1:2 with lines lc rgb '#999999' dt 2 lw 1.5 title 'trend'";
  return script;
}

}  // namespace

std::string drawn(const Drawing& drawing) {
  Texts texts;
  const std::string data = data_of(drawing, texts);
  const std::string script = script_of(drawing, texts);
  process::Filtered found;
  try {
    // -d: no settings of the user. The locale does not matter to numbers, which have points.
    found = process::filter({.arguments = {"gnuplot", "-d", "-e", script},
                             .input = data,
                             .environment = {{"LC_ALL", "C.UTF-8"}},
                             .patience = patience});
  } catch (const process::StartError&) {
    throw DrawingError("is drawn by gnuplot, which is not installed; scripts/install installs it");
  }
  if (!found.well) throw DrawingError("gnuplot did not draw it: it " + found.problem);
  if (found.output.find("</svg>") == std::string::npos) throw DrawingError("gnuplot did not draw it");
  return texts.put_into(found.output);
}

}  // namespace report
