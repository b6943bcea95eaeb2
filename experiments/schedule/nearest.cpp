#include "experiments/schedule/nearest.h"

#include <algorithm>
#include <optional>

namespace schedule {
namespace {

using Costs = std::vector<std::vector<std::size_t>>;

/// Least number of letters to insert, remove or exchange, neighbours exchanged with each other counting one;
/// in the last row from all of `one` to each beginning of `other`.
Costs edit_costs(std::string_view one, std::string_view other) {
  Costs cost(one.size() + 1, std::vector<std::size_t>(other.size() + 1));
  for (std::size_t i = 0; i <= one.size(); ++i) {
    for (std::size_t j = 0; j <= other.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const std::size_t exchanged = one[i - 1] == other[j - 1] ? 0 : 1;
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + exchanged});
      if (i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1]) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost;
}

std::size_t edit_distance(std::string_view one, std::string_view other) {
  return edit_costs(one, other).back().back();
}

/// The same to the first word of a name of several, as speed_factor; nothing when it has only one.
std::optional<std::size_t> distance_to_first_word(std::string_view word, std::string_view name) {
  const std::size_t end = name.find_first_of("_-");
  if (end == std::string_view::npos) return std::nullopt;
  return edit_costs(word, name).back()[end];
}

}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  const std::string* best = nullptr;
  std::size_t least = word.size() + 1;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(word, name);
    // Words with the same first letter may differ a little more: pears and pairs.
    const bool begins_alike = !word.empty() && !name.empty() && word.front() == name.front();
    const std::size_t most = std::max<std::size_t>(1, (word.size() + (begins_alike ? 1 : 0)) / 3);
    if (distance <= most && distance < least) {
      least = distance;
      best = &name;
    }
  }
  constexpr std::size_t short_word = 4;  // a slip in fewer letters is another word
  for (const std::string& name : names) {
    if (best != nullptr || word.size() < short_word) break;
    const auto distance = distance_to_first_word(word, name);
    if (distance && *distance <= 1) best = &name;
  }
  return best == nullptr ? "" : "; did you mean " + *best + "?";
}

}  // namespace schedule
