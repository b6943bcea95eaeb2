#include "experiments/stopping/question.h"

#include <algorithm>
#include <cmath>

namespace stopping {

std::vector<Question> questions(const schedule::Design& design) {
  std::vector<Question> found;
  for (std::size_t i = 0; i < design.conditions.size(); ++i) {
    const schedule::Condition& condition = design.conditions[i];
    if (!condition.panel) {
      found.push_back({condition.name, {{i, 1.0}}});
      continue;
    }
    auto question = std::find_if(found.begin(), found.end(), [&](const Question& one) {
      return one.panel && one.name == condition.panel->base;
    });
    if (question == found.end()) question = found.insert(found.end(), {condition.panel->base, {}, true});
    question->terms.push_back({i, condition.panel->arm == 'a' ? 1.0 : -1.0});
  }
  for (Question& question : found) {
    if (!question.panel) continue;
    const double opponents = static_cast<double>(question.terms.size()) / 2;
    for (Question::Term& term : question.terms) term.weight /= opponents;
  }
  return found;
}

double pair_score(const record::PairState& state, schedule::Metric metric, int forfeit_goals) {
  double sum = 0;
  for (const record::Attempt* leg : state.legs) {
    const world::PerTeam<int> goals = record::counted_goals(leg->record, forfeit_goals);
    const int difference = goals[leg->a_colour] - goals[world::opponent(leg->a_colour)];
    if (metric == schedule::Metric::GoalDifference) {
      sum += difference;
    } else {
      const record::Outcome outcome = record::outcome(leg->record);
      const bool a_is_blue = leg->a_colour == world::Team::Blue;
      if (outcome == record::Outcome::Draw) sum += 0.5;
      if (outcome == (a_is_blue ? record::Outcome::BlueWins : record::Outcome::YellowWins)) sum += 1;
    }
  }
  return sum / 2;
}

stats::SequentialPlan sequential_plan(const schedule::Design& design, const Question& question,
                                      std::size_t questions) {
  const schedule::Stopping& stopping = design.stopping;
  const double games = question.panel ? static_cast<double>(question.terms.size()) / 2 : 2;
  stats::SequentialPlan plan;
  plan.metric = stopping.metric == schedule::Metric::Points && !question.panel
                    ? stats::Metric::Points
                    : stats::Metric::GoalDifference;
  plan.hypotheses = {stopping.h0 * std::sqrt(games), stopping.h1 * std::sqrt(games)};
  plan.alpha = stopping.alpha / static_cast<double>(questions);
  plan.beta = stopping.beta;
  plan.first_look = stopping.minimum_pairs;
  plan.batch = stopping.batch_pairs;
  plan.cap = design.pairs;
  plan.clip = stopping.clip.value_or(0);
  return plan;
}

}  // namespace stopping
