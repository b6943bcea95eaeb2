#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace automaton {

/// The paper's Algorithm 1 for any automaton whose transitions are the rows of a table.
///
/// The first row in table order that holds is taken; then the scan starts again from the top, until no row
/// holds. A row may await an occurrence (something that was detected in this tick); each occurrence is taken
/// at most once, so that the loop ends even where a row's own effect leaves its condition true (I-41). Rows
/// that await none must make their own condition false.
class EventLoop {
 public:
  struct Result {
    int transitions = 0;
    bool cut_short = false;  ///< the cap was reached: a defect of the table
  };

  /// More transitions than this in one tick are a defect (ours: the longest sound chain has about six, and
  /// each touch and each card that runs out may add one).
  static constexpr int cap = 64;

  /// @tparam Row  has a member `awaits_occurrence`
  /// @param holds  bool(const Row&, const Occurrence*): whether the row can be taken now,
  ///               with this occurrence; null for rows that await none
  /// @param take   void(const Row&, const Occurrence*): the row's effect
  template <class Row, class Occurrence, class Holds, class Take>
  Result run(std::span<const Row> rows, std::span<const Occurrence> occurrences, Holds&& holds, Take&& take) {
    taken_.assign(occurrences.size(), false);
    Result result;
    while (take_first(rows, occurrences, holds, take)) {
      if (++result.transitions == cap) {
        result.cut_short = true;
        break;
      }
    }
    return result;
  }

 private:
  template <class Row, class Occurrence, class Holds, class Take>
  bool take_first(std::span<const Row> rows, std::span<const Occurrence> occurrences, Holds&& holds,
                  Take&& take) {
    for (const Row& row : rows) {
      if (!row.awaits_occurrence) {
        if (!holds(row, nullptr)) continue;
        take(row, nullptr);
        return true;
      }
      for (std::size_t i = 0; i < occurrences.size(); ++i) {
        if (taken_[i] || !holds(row, &occurrences[i])) continue;
        taken_[i] = true;
        take(row, &occurrences[i]);
        return true;
      }
    }
    return false;
  }

  std::vector<char> taken_;
};

}  // namespace automaton
