#include "experiments/runner/progress.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ostream>

#include "sim/console/printable.h"
#include "sim/console/standard_output.h"

namespace runner {
namespace {

constexpr std::chrono::milliseconds redraw{250};
constexpr std::size_t widest = 110;  // columns

std::string printed(const char* format, auto... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// 4:31, or 2:04:31
std::string hours(double seconds) {
  const long whole = static_cast<long>(seconds + 0.5);
  if (whole >= 3600) return printed("%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  return printed("%ld:%02ld", whole / 60, whole % 60);
}

bool a_is(const record::Attempt& attempt, record::Outcome outcome) {
  const bool a_is_blue = attempt.a_colour == world::Team::Blue;
  return outcome == (a_is_blue ? record::Outcome::BlueWins : record::Outcome::YellowWins);
}

std::string described(const record::Attempt& attempt) {
  const record::MatchRecord& record = attempt.record;
  const record::Outcome outcome = record::outcome(record);
  const world::PerTeam<int>& goals = record.goals;
  std::string text = printed("A %d:%d B", goals[attempt.a_colour], goals[world::opponent(attempt.a_colour)]);
  if (outcome == record::Outcome::Void) {
    text = "void: " + record.reason;
  } else if (record.at_fault != record::Party::Nobody) {
    text = printed("forfeit, %s at fault: ", a_is(attempt, outcome) ? "B" : "A") + record.reason;
  }
  return text + printed(" (%.1f s)", record.wall_seconds);
}

}  // namespace

Progress::Progress(std::ostream& out, bool terminal, const schedule::Design& design, std::size_t total,
                   std::size_t resolved)
    : out_(out),
      terminal_(terminal),
      design_(design),
      total_(total),
      resolved_(resolved),
      resolved_before_(resolved) {
  for (const schedule::Condition& condition : design.conditions)
    conditions_.push_back({condition.name, {}, {}});
}

Progress::Score Progress::Games::score() const {
  Score sum;
  for (const auto& [pair, score] : pairs) {
    sum.wins += score.wins;
    sum.draws += score.draws;
    sum.losses += score.losses;
  }
  return sum;
}

void Progress::known(const record::Attempt& attempt) {
  const int pair = attempt.key.pair;
  const auto games = std::find_if(conditions_.begin(), conditions_.end(),
                                  [&](const Games& one) { return one.condition == attempt.key.condition; });
  if (games == conditions_.end() || (games->next_pair && pair >= *games->next_pair)) return;
  std::vector<record::Attempt>& begun = games->begun[pair];
  begun.push_back(attempt);
  begun.back().record.timeline = {};  // nine tenths of it
  std::vector<const record::Attempt*> all;
  for (const record::Attempt& one : begun) all.push_back(&one);
  const record::PairState state = record::pair_state(all);
  if (!state.complete()) return;
  Score score;
  for (const record::Attempt* leg : state.legs) {
    const record::Outcome outcome = record::outcome(leg->record);
    ++(outcome == record::Outcome::Draw ? score.draws : a_is(*leg, outcome) ? score.wins : score.losses);
  }
  games->pairs[pair] = score;
  games->begun.erase(pair);
}

void Progress::stop(const std::string& condition, int next_pair) {
  for (Games& games : conditions_) {
    if (games.condition != condition) continue;
    games.next_pair = next_pair;
    games.begun.erase(games.begun.lower_bound(next_pair), games.begun.end());
    games.pairs.erase(games.pairs.lower_bound(next_pair), games.pairs.end());
  }
}

void Progress::ended(const record::Attempt& attempt, std::size_t resolved, Clock::time_point now) {
  known(attempt);
  resolved_ = resolved;
  const bool notable = attempt.record.at_fault != record::Party::Nobody;
  const std::string what = record::game_id(attempt.key) +
                           (attempt.attempt > 1 ? printed(" (attempt %d)", attempt.attempt) : "") + ": " +
                           described(attempt);
  if (terminal_ && !notable) {
    drawn_ = {};
  } else if (terminal_) {
    say(what);
  } else {
    out_ << console::printable(what) << "; " << line(now) << std::endl;
  }
}

void Progress::tick(std::size_t running, Clock::time_point now) {
  if (!terminal_ || now - drawn_ < redraw) return;
  drawn_ = now;
  std::string text = line(now) + printed(" | %zu running", running);
  if (text.size() > widest) text.replace(widest - 3, std::string::npos, "...");
  out_ << console::clear_line << text << std::flush;
}

void Progress::clear() {
  if (terminal_) out_ << console::clear_line << std::flush;
}

void Progress::say(const std::string& sentence) {
  clear();
  out_ << console::printable(sentence) << std::endl;
  drawn_ = {};
}

std::string Progress::line(Clock::time_point now) const {
  std::string text = printed("%zu/%zu games", resolved_, total_);
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const auto played = static_cast<double>(resolved_ - resolved_before_);
  if (played > 0 && seconds > 0) {
    text += printed(", %.1f/min", 60 * played / seconds);
  }
  if (left_ && resolved_ < total_) {
    text += ", " + hours(left_->seconds) + " left (" + hours(left_->low) + "-" + hours(left_->high) + ")";
  }
  for (const Games& games : conditions_) {
    const Score score = games.score();
    text += (&games == &conditions_.front() ? " | " : ", ") + games.condition +
            printed(" %d-%d-%d", score.wins, score.draws, score.losses);
  }
  return text;
}

}  // namespace runner
