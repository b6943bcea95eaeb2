#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

// Do games played here and there, early and late, look alike?
namespace stats {

/// Counts of one group: one column per kind of result.
struct GroupCounts {
  std::string name;
  std::vector<std::int64_t> counts;
};

/// A chi-square test, and which rows stand out.
struct Homogeneity {
  double chi_square = 0;
  std::int64_t freedom = 0;          ///< 0: too little to say anything
  double p = 1;                      ///< that groups alike differ at least as much
  std::vector<std::string> dropped;  ///< groups with an expected count of 5 or less
  struct Outlier {
    std::string name;
    double chi_square = 0;  ///< of the row, divided by (1 - its share), so that large groups are judged alike
    double p = 1;           ///< of the row, not adjusted for the number of rows
  };
  std::vector<Outlier> rows;  ///< of the groups that were used
};

/// Chi-square test that all rows come from one distribution over the columns.
///
/// Columns nobody has are left out; rows with an expected count of at most `least` in some column are dropped
/// one by one, the smallest first, and the rest is tested.
///
/// Source  fishtest, stat_util.py, "get_chi2"; harness reference 2.8
Homogeneity homogeneity(std::span<const GroupCounts> groups, double least = 5);

/// Are highs and lows of a sequence mixed as by chance? (Wald and Wolfowitz)
struct RunsTest {
  std::int64_t above = 0;  ///< values above the median
  std::int64_t below = 0;  ///< values below it; those equal to it are left out
  std::int64_t runs = 0;
  double expected = 0;  ///< runs, if mixed by chance
  double z = 0;         ///< negative: the like sticks together, as with a drift
  double p = 1;         ///< two-sided, normal with continuity correction; 1 with fewer than ten values
};

/// @param values  in the order they were played
/// Source  A. Wald, J. Wolfowitz, "On a test whether two samples are from the same population", 1940
RunsTest runs_test(std::span<const double> values);

}  // namespace stats
