#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/report/summary.h"

namespace report {

/// A picture of results: data and drawing as a script for gnuplot.
struct Figure {
  std::string name;     ///< of a file: "speed-goals"
  std::string caption;  ///< what is to be seen, one sentence
  std::string script;   ///< draws into standard output as SVG
};

/// Of each sweep: goals of both teams with standard errors (the paper's Figure 8), goal difference with its
/// trend, shares of wins and draws with Wilson's intervals. Of the other conditions: goal difference and
/// shares side by side.
std::vector<Figure> figures(const Summary& summary);

/// gnuplot is missing or would not draw.
struct DrawingError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The figure as SVG, drawn by gnuplot.
/// @throws DrawingError in one sentence
std::string drawn(const Figure& figure);

}  // namespace report
