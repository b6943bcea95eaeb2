#include "experiments/runner/plan.h"

#include <algorithm>

#include "experiments/record/ledger.h"

namespace runner {

record::Attempt attempt_of(const Job& job) {
  record::Attempt attempt;
  attempt.key = job.game.key;
  attempt.attempt = job.attempt;
  attempt.seed = job.game.config.seed;
  attempt.a_colour = job.game.a_colour;
  attempt.blue_on_positive_half = job.game.config.blue_on_positive_half;
  attempt.first_kickoff = job.game.config.first_kickoff;
  return attempt;
}

Plan::Plan(const schedule::Design& design, std::span<const record::Attempt> attempts)
    : design_(design), pairs_(schedule::game_count(design) / 2) {
  std::vector<std::vector<const record::Attempt*>> by_pair(pairs_.size());
  for (const record::Attempt& attempt : attempts) by_pair[pair_index(attempt.key)].push_back(&attempt);

  std::vector<Entry> again;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const record::PairState state = record::pair_state(by_pair[i]);
    pairs_[i].attempt = state.attempt;
    for (std::size_t leg = 0; leg < 2; ++leg) {
      pairs_[i].played[leg] = state.legs[leg] != nullptr;
      if (pairs_[i].given_up() || pairs_[i].played[leg]) continue;
      const Entry entry{2 * i + leg, state.attempt};
      if (state.attempt == 1) {
        waiting_.push_back(entry);
      } else {
        again.push_back(entry);
      }
    }
  }
  waiting_.insert(waiting_.end(), again.begin(), again.end());
}

std::optional<Job> Plan::next() {
  if (waiting_.empty()) return std::nullopt;
  const Entry entry = waiting_.front();
  waiting_.pop_front();
  return Job{schedule::game(design_, entry.index), entry.attempt};
}

void Plan::put_back(const record::GameKey& key, int attempt) {
  const std::size_t index = pair_index(key);
  if (pairs_[index].attempt != attempt || !pairs_[index].needed) return;
  waiting_.push_front({2 * index + static_cast<std::size_t>(key.leg), attempt});
}

void Plan::add(const record::Attempt& attempt) {
  const std::size_t index = pair_index(attempt.key);
  Pair& pair = pairs_[index];
  if (record::outcome(attempt.record) == record::Outcome::Void) {
    if (attempt.attempt >= pair.attempt) start_again(index, attempt.attempt + 1);
  } else if (attempt.attempt == pair.attempt) {
    pair.played.at(static_cast<std::size_t>(attempt.key.leg)) = true;
  }
}

void Plan::start_again(std::size_t index, int attempt) {
  std::erase_if(waiting_, [&](const Entry& entry) { return entry.index / 2 == index; });
  Pair& pair = pairs_[index];
  pair.attempt = attempt;
  pair.played = {};
  if (pair.given_up() || !pair.needed) return;
  waiting_.push_back({2 * index, attempt});
  waiting_.push_back({2 * index + 1, attempt});
}

void Plan::stop(const std::string& condition, int next_pair) {
  for (int number = next_pair; number < design_.pairs; ++number) {
    pairs_[pair_index({condition, number, 0})].needed = false;
  }
  std::erase_if(waiting_, [&](const Entry& entry) { return !pairs_[entry.index / 2].needed; });
}

std::size_t Plan::total() const {
  return 2 * static_cast<std::size_t>(
                 std::count_if(pairs_.begin(), pairs_.end(), [](const Pair& pair) { return pair.needed; }));
}

std::size_t Plan::pair_index(const record::GameKey& key) const {
  const auto condition = std::find_if(design_.conditions.begin(), design_.conditions.end(),
                                      [&](const auto& one) { return one.name == key.condition; });
  if (condition == design_.conditions.end() || key.pair < 0 || key.pair >= design_.pairs || key.leg < 0 ||
      key.leg > 1) {
    throw record::StorageError("the ledger holds game '" + record::game_id(key) + "', which design '" +
                               design_.name + "' does not have; give another --out");
  }
  const auto number = static_cast<std::size_t>(condition - design_.conditions.begin());
  return static_cast<std::size_t>(key.pair) * design_.conditions.size() + number;
}

std::size_t Plan::resolved() const {
  std::size_t games = 0;
  for (const Pair& pair : pairs_) {
    if (!pair.needed) continue;
    if (pair.given_up()) {
      games += 2;
    } else {
      games += static_cast<std::size_t>(std::count(pair.played.begin(), pair.played.end(), true));
    }
  }
  return games;
}

std::size_t Plan::given_up_pairs() const {
  return static_cast<std::size_t>(std::count_if(
      pairs_.begin(), pairs_.end(), [](const Pair& pair) { return pair.needed && pair.given_up(); }));
}

}  // namespace runner
