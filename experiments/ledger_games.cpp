#include "experiments/ledger_games.h"

#include "experiments/schedule/schedule.h"

namespace commands {
namespace {

/// Keeps the rows of which nothing is wrong.
template <class Item, class Problem>
void keep_right(std::vector<Item>& items, record::RowCheck& check, const Problem& problem_of) {
  std::vector<Item> right;
  for (Item& item : items) {
    const std::string problem = problem_of(item);
    if (problem.empty()) {
      right.push_back(std::move(item));
      continue;
    }
    check.damaged.push_back("game " + record::game_id(item.key) + ", attempt " +
                            std::to_string(item.attempt) + " " + problem);
    --(check.whole > 0 ? check.whole : check.unknown);
  }
  items = std::move(right);
}

}  // namespace

void compare_with_design(const schedule::Design& design, record::LedgerCheck& rows) {
  const std::string none = "is a game that the design does not have";
  keep_right(rows.readable_attempts, rows.attempts, [&](const record::Attempt& attempt) -> std::string {
    const auto game = schedule::game_of(design, attempt.key);
    if (!game) return none;
    const bool same = attempt.seed == game->config.seed && attempt.a_colour == game->a_colour &&
                      attempt.blue_on_positive_half == game->config.blue_on_positive_half &&
                      attempt.first_kickoff == game->config.first_kickoff;
    return same ? "" : "has another seed, other colours or other sides than the design gives it";
  });
  keep_right(rows.readable_audits, rows.audits, [&](const record::Audit& audit) -> std::string {
    return schedule::game_of(design, audit.key) ? "" : none;
  });
}

}  // namespace commands
