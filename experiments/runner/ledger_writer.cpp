#include "experiments/runner/ledger_writer.h"

#include <utility>

namespace runner {

void LedgerWriter::write(std::function<void(record::Ledger&)> what, std::function<void()> then) {
  queue_.push_back({std::move(what), std::move(then)});
  if (queue_.size() == 1) flush();
}

LedgerWriter::News LedgerWriter::look(Clock::time_point now, bool idle) {
  flush();
  if (queue_.empty()) return std::exchange(since_, std::nullopt) ? News::Free : News::None;
  if (!since_) {
    since_ = now;
    return News::Blocked;
  }
  return idle && now - *since_ > patience_ ? News::GiveUp : News::None;
}

void LedgerWriter::flush() {
  while (!queue_.empty()) {
    try {
      queue_.front().what(ledger_);
    } catch (const record::LedgerBlocked& error) {
      reason_ = error.what();
      return;
    }
    const Entry done = std::move(queue_.front());
    queue_.pop_front();
    if (done.then) done.then();
  }
}

}  // namespace runner
