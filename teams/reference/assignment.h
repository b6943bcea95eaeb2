#pragma once

#include <array>
#include <cstddef>

namespace reference {

/// The most robots and tasks there are to join.
inline constexpr std::size_t most_to_assign = 16;

/// What each task (row) costs each robot (column); unset ones cost nothing.
struct Costs {
  std::array<std::array<double, most_to_assign>, most_to_assign> of{};
  std::size_t tasks = 0;
  std::size_t robots = 0;
};

/// Gives every task to another robot so that the sum of the costs is least.
///
/// The Hungarian method with potentials, O(tasks^2 robots). Among equal sums it always returns the same one.
///
/// @pre     tasks <= robots <= 16
/// @return  for each task its robot (column)
/// Source   H. W. Kuhn, "The Hungarian method for the assignment problem", 1955; J. Munkres 1957
std::array<std::size_t, most_to_assign> assign(const Costs& costs);

}  // namespace reference
