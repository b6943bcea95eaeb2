#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/schedule/design.h"
#include "experiments/stats/intervals.h"
#include "experiments/stats/sequential.h"
#include "experiments/stopping/question.h"

namespace stopping {

enum class Decision : std::uint8_t {
  GoOn,
  Played,     ///< fixed number: all pairs are there
  Precise,    ///< fixed precision: reached
  AcceptH0,   ///< sequential
  AcceptH1,   ///< sequential
  Undecided,  ///< all pairs are there, but precision or decision was not reached
};

/// How far one question has come.
struct Standing {
  Question question;
  Decision decision = Decision::GoOn;
  int pairs = 0;           ///< that gave a score, up to the last look
  int next_pair = 0;       ///< pairs from this number on do not count
  stats::Mean score{};     ///< of those pairs, clipped if the rule says so; not corrected for stopping
  double llr = 0;          ///< sequential: log-likelihood ratio of h1 against h0 at the last look
  stats::Bounds bounds{};  ///< sequential: tightened, at the last look
  bool decided() const { return decision != Decision::GoOn; }
};

/// Watches the games of an experiment and says when which question has its answer.
///
/// Only the contiguous beginning of the schedule is looked at: what counts, and when it is looked at, depends
/// on the games' results alone, not on which were over first, by how many workers, or after how many breaks.
/// (In order of completion 128 games at a time find a difference between equal teams in 3 of 4 tests, when
/// winning games are a tenth shorter; harness reference 2.6.) A pair that was given up gives no score.
class Watch {
 public:
  explicit Watch(const schedule::Design& design);

  /// Takes in an attempt; the order does not matter. Attempts at games of other designs are ignored.
  ///
  /// @return  the questions that were answered by it, as indices into standings()
  std::vector<std::size_t> add(const record::Attempt& attempt);

  const std::vector<Standing>& standings() const { return standings_; }
  /// The decision about the question that a condition belongs to.
  const Standing& standing_of(std::size_t condition) const;

 private:
  using Attempts = std::vector<record::Attempt>;  ///< at one pair

  bool advance(std::size_t question);
  stats::SequentialPlan plan_of(const Standing& standing) const;
  bool look(Standing& standing, const std::vector<double>& scores, bool last) const;
  std::optional<double> score(const Question& question, int pair, bool& given_up) const;

  schedule::Design design_;
  std::vector<Standing> standings_;
  std::vector<int> prefix_;                                  ///< by question: pairs taken in
  std::vector<std::vector<double>> scores_;                  ///< by question
  std::vector<std::size_t> question_of_;                     ///< by condition
  std::map<std::string, std::size_t> names_;                 ///< of conditions
  std::map<std::pair<std::size_t, int>, Attempts> waiting_;  ///< by condition and pair, not yet taken in
};

/// The standings that a ledger gives.
std::vector<Standing> standings(const schedule::Design& design, std::span<const record::Attempt> attempts);

/// The attempts that count: without pairs that were begun before the test stopped but stand behind its end.
std::vector<record::Attempt> counted(const schedule::Design& design,
                                     std::span<const record::Attempt> attempts);

}  // namespace stopping
