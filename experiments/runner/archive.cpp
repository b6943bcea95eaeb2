#include "experiments/runner/archive.h"

namespace runner {

std::string Archive::cut_down(record::Attempt& attempt, bool sampled) const {
  if (!Evidence::keeps(attempt, sampled)) return {};
  const std::string removed = runner::cut_down(folder_.game(record::game_id(attempt.key), attempt.attempt));
  std::string& reason = attempt.record.reason;
  if (!removed.empty() && !reason.empty()) reason += "; " + removed;
  return removed;
}

bool Archive::add(const record::Attempt& attempt, bool sampled) {
  const std::string game = record::game_id(attempt.key);
  if (!Evidence::keeps(attempt, sampled)) {
    writer_.write([attempt](record::Ledger& ledger) { ledger.add(attempt); },
                  [this, game, number = attempt.attempt] { folder_.forget_game(game, number); });
    return false;
  }
  remove_odd(folder_.game(game, attempt.attempt));
  writer_.write([attempt, files = files_in(folder_.path(), folder_.game(game, attempt.attempt))](
                    record::Ledger& ledger) { ledger.add(attempt, files); });
  const std::vector<Evidence::Place> gone = evidence_.add(attempt);
  for (const Evidence::Place& one : gone) {
    const std::string place =
        folder_.game(one.game, one.attempt).lexically_relative(folder_.path()).generic_string();
    writer_.write([place](record::Ledger& ledger) { ledger.forget_files(place); },
                  [this, one] { folder_.forget_game(one.game, one.attempt); });
  }
  return !gone.empty();
}

}  // namespace runner
