#include "teams/reference/assignment.h"

#include <cassert>
#include <limits>

namespace reference {

std::array<std::size_t, most_to_assign> assign(const Costs& costs) {
  assert(costs.tasks <= costs.robots && costs.robots <= most_to_assign);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  // Rows and columns count from 1; column 0 holds the row being placed.
  std::array<double, most_to_assign + 1> row_potential{}, column_potential{}, slack;
  std::array<std::size_t, most_to_assign + 1> row_of{}, from{};
  for (std::size_t row = 1; row <= costs.tasks; ++row) {
    row_of[0] = row;
    std::size_t column = 0;
    slack.fill(infinite);
    std::array<bool, most_to_assign + 1> used{};
    do {
      used[column] = true;
      const std::size_t here = row_of[column];
      double step = infinite;
      std::size_t next = 0;
      for (std::size_t j = 1; j <= costs.robots; ++j) {
        if (used[j]) continue;
        const double reduced = costs.of[here - 1][j - 1] - row_potential[here] - column_potential[j];
        if (reduced < slack[j]) {
          slack[j] = reduced;
          from[j] = column;
        }
        if (slack[j] < step) {
          step = slack[j];
          next = j;
        }
      }
      for (std::size_t j = 0; j <= costs.robots; ++j) {
        if (used[j]) {
          row_potential[row_of[j]] += step;
          column_potential[j] -= step;
        } else {
          slack[j] -= step;
        }
      }
      column = next;
    } while (row_of[column] != 0);
    while (column != 0) {
      const std::size_t before = from[column];
      row_of[column] = row_of[before];
      column = before;
    }
  }
  std::array<std::size_t, most_to_assign> robot_of{};
  for (std::size_t j = 1; j <= costs.robots; ++j) {
    if (row_of[j] != 0) robot_of[row_of[j] - 1] = j - 1;
  }
  return robot_of;
}

}  // namespace reference
