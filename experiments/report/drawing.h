#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace report {

/// Curves with error bars over one axis.
struct Drawing {
  enum class Range { Free, FromZero, Percent };  ///< of the axis of y
  enum class Colour { A, B, Draw };
  struct Tick {
    double x;
    std::string label;
  };
  struct Value {
    double x;
    double y;
    double low;
    double high;
  };
  struct Curve {
    std::string title;
    Colour colour;
    std::vector<Value> points;
  };
  struct Line {
    double at_zero;
    double slope;
  };
  std::string x_label;
  std::string y_label;
  std::vector<Tick> ticks;  ///< by rising x, at least one; they span the axis of x
  std::vector<Curve> curves;
  Range range = Range::Free;
  bool lines = true;       ///< between the points of a curve
  bool turned = false;     ///< labels of ticks are long
  bool zero_line = false;  ///< at y = 0
  std::optional<Line> trend{};
};

/// gnuplot is missing or would not draw; one sentence.
struct DrawingError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The drawing as SVG by gnuplot. No text of the drawing reaches gnuplot, and none acts in the SVG.
std::string drawn(const Drawing& drawing);

}  // namespace report
