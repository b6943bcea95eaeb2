#include "experiments/stopping/watch.h"

#include <algorithm>

namespace stopping {
namespace {

/// What `mean` needs of the pair's games: nothing of the record but its end and its goals.
record::Attempt slim(const record::Attempt& attempt) {
  record::Attempt kept;
  kept.key = attempt.key;
  kept.attempt = attempt.attempt;
  kept.a_colour = attempt.a_colour;
  kept.record.goals = attempt.record.goals;
  kept.record.termination = attempt.record.termination;
  kept.record.at_fault = attempt.record.at_fault;
  return kept;
}

record::PairState state_of(const std::vector<record::Attempt>& attempts) {
  std::vector<const record::Attempt*> pointers;
  for (const record::Attempt& attempt : attempts) pointers.push_back(&attempt);
  return record::pair_state(pointers);
}

Decision decision_of(stats::Decision decision) {
  switch (decision) {
    case stats::Decision::GoOn:
      return Decision::GoOn;
    case stats::Decision::AcceptH0:
      return Decision::AcceptH0;
    case stats::Decision::AcceptH1:
      return Decision::AcceptH1;
    case stats::Decision::Undecided:
      return Decision::Undecided;
  }
  return Decision::GoOn;
}

}  // namespace

Watch::Watch(const schedule::Design& design) : design_(design), question_of_(design.conditions.size(), 0) {
  for (const Question& question : questions(design)) {
    for (const Question::Term& term : question.terms) question_of_[term.condition] = standings_.size();
    standings_.push_back({question});
  }
  for (std::size_t i = 0; i < design.conditions.size(); ++i) names_[design.conditions[i].name] = i;
  prefix_.resize(standings_.size(), 0);
  scores_.resize(standings_.size());
}

std::vector<std::size_t> Watch::add(const record::Attempt& attempt) {
  const auto name = names_.find(attempt.key.condition);
  if (name == names_.end()) return {};
  const std::size_t question = question_of_[name->second];
  if (standings_[question].decided() || attempt.key.pair < prefix_[question]) return {};
  waiting_[{name->second, attempt.key.pair}].push_back(slim(attempt));
  if (advance(question)) return {question};
  return {};
}

std::optional<double> Watch::score(const Question& question, int pair, bool& given_up) const {
  double sum = 0;
  for (const Question::Term& term : question.terms) {
    const auto found = waiting_.find({term.condition, pair});
    if (found == waiting_.end()) return std::nullopt;
    const record::PairState state = state_of(found->second);
    if (state.given_up) {
      given_up = true;
    } else if (state.complete()) {
      sum += term.weight * pair_score(state, design_.stopping.metric, design_.forfeit_goals);
    } else {
      return std::nullopt;
    }
  }
  return sum;
}

bool Watch::advance(std::size_t index) {
  Standing& standing = standings_[index];
  std::vector<double>& scores = scores_[index];
  while (prefix_[index] < design_.pairs) {
    const int pair = prefix_[index];
    bool given_up = false;
    const std::optional<double> score = this->score(standing.question, pair, given_up);
    if (!score) return false;
    for (const Question::Term& term : standing.question.terms) waiting_.erase({term.condition, pair});
    ++prefix_[index];
    if (!given_up) scores.push_back(stats::clipped(*score, plan_of(standing)));
    const bool last = prefix_[index] == design_.pairs;
    if ((!given_up || last) && look(standing, scores, last)) {
      standing.next_pair = prefix_[index];
      return true;
    }
  }
  return false;
}

stats::SequentialPlan Watch::plan_of(const Standing& standing) const {
  return sequential_plan(design_, standing.question, standings_.size());
}

/// Returns whether the question is answered; only at the looks agreed on beforehand.
bool Watch::look(Standing& standing, const std::vector<double>& scores, bool last) const {
  const schedule::Stopping& rule = design_.stopping;
  const int count = static_cast<int>(scores.size());
  const bool due = count >= rule.minimum_pairs && (count - rule.minimum_pairs) % rule.batch_pairs == 0;
  if (!last && (rule.rule == schedule::StopRule::Fixed || !due)) return false;

  standing.pairs = count;
  standing.next_pair = prefix_[question_of_[standing.question.terms.front().condition]];
  standing.score = stats::mean_of(scores);
  switch (rule.rule) {
    case schedule::StopRule::Fixed:
      standing.decision = Decision::Played;
      break;
    case schedule::StopRule::Precision:
      if (due && standing.score.has_error() && standing.score.standard_error <= rule.standard_error) {
        standing.decision = Decision::Precise;
      }
      break;
    case schedule::StopRule::Sequential: {
      const stats::SequentialState state = stats::sequential_test(scores, plan_of(standing));
      standing.decision = decision_of(state.decision);
      standing.llr = state.llr;
      standing.bounds = state.bounds;
      break;
    }
  }
  if (last && !standing.decided()) standing.decision = Decision::Undecided;
  return standing.decided();
}

const Standing& Watch::standing_of(std::size_t condition) const {
  return standings_[question_of_[condition]];
}

std::vector<Standing> standings(const schedule::Design& design, std::span<const record::Attempt> attempts) {
  Watch watch(design);
  for (const record::Attempt& attempt : attempts) watch.add(attempt);
  return watch.standings();
}

std::vector<record::Attempt> counted(const schedule::Design& design,
                                     std::span<const record::Attempt> attempts) {
  std::map<std::string, int> ends;  // by condition: the first pair that does not count
  for (const Standing& standing : standings(design, attempts)) {
    if (!standing.decided()) continue;
    for (const Question::Term& term : standing.question.terms) {
      ends[design.conditions[term.condition].name] = standing.next_pair;
    }
  }
  std::vector<record::Attempt> kept;
  for (const record::Attempt& attempt : attempts) {
    const auto end = ends.find(attempt.key.condition);
    if (end == ends.end() || attempt.key.pair < end->second) kept.push_back(attempt);
  }
  return kept;
}

}  // namespace stopping
