#pragma once

#include <string>
#include <vector>

#include "experiments/report/drawing.h"
#include "experiments/report/summary.h"

namespace report {

/// A picture of results.
struct Figure {
  std::string name;     ///< of a file: "speed-goals"
  std::string caption;  ///< what is to be seen, one sentence
  Drawing drawing;
};

/// - Of each sweep: goals of both teams with standard errors (the paper's Figure 8), goal difference with its
///   trend, shares of wins and draws with Wilson's intervals.
/// - Of the other conditions: goal difference and shares side by side.
std::vector<Figure> figures(const Summary& summary);

/// The figure as SVG, drawn by gnuplot.
/// @throws DrawingError in one sentence that names it
std::string drawn(const Figure& figure);

}  // namespace report
