#include "experiments/stopping/wording.h"

#include <fmt/format.h>

#include "experiments/stopping/estimate.h"

namespace stopping {
namespace {

const char* metric_name(const schedule::Design& design) {
  return design.stopping.metric == schedule::Metric::Points ? "points" : "goal difference";
}

/// "A (new) against B (old)", "A (new) compared with B (old) against the panel".
std::string view(const Question& question, const schedule::Design& design) {
  const schedule::Condition& first = design.conditions[question.terms.front().condition];
  if (!question.panel) return fmt::format("A ({}) against B ({})", first.a.name, first.b.name);
  std::string b = "B";
  for (const Question::Term& term : question.terms) {
    const schedule::Condition& condition = design.conditions[term.condition];
    if (condition.panel->arm == 'b') b = condition.a.name;
  }
  return fmt::format("A ({}) compared with B ({}) against the panel", first.a.name, b);
}

std::string hypothesis(double h) { return fmt::format("{:g} standard deviations of a game", h); }

std::string number(double value, const Question& question, const schedule::Design& design) {
  const bool points = design.stopping.metric == schedule::Metric::Points;
  if (points && !question.panel) return fmt::format("{:.1f}", 100 * value);
  return points ? fmt::format("{:+.1f}", 100 * value) : fmt::format("{:+.2f}", value);
}

const char* unit(const schedule::Design& design) {
  return design.stopping.metric == schedule::Metric::Points ? "% of the points" : "goals a game";
}

std::string outcome(const Standing& standing, const schedule::Design& design) {
  const schedule::Stopping& rule = design.stopping;
  switch (standing.decision) {
    case Decision::GoOn:
      return "not decided yet";
    case Decision::Played:
      return "all pairs are played";
    case Decision::Precise:
      return fmt::format("standard error {:.3f} reached the wanted {:g}", standing.score.standard_error,
                         rule.standard_error);
    case Decision::AcceptH0:
      return "H0 accepted, A is not better by more than " + hypothesis(rule.h0);
    case Decision::AcceptH1:
      return "H1 accepted, A is better by about " + hypothesis(rule.h1) + " or more";
    case Decision::Undecided:
      return rule.rule == schedule::StopRule::Precision
                 ? fmt::format("standard error {:.3f}, the wanted {:g} was not reached",
                               standing.score.standard_error, rule.standard_error)
                 : std::string("undecided at the cap");
  }
  return "";
}

}  // namespace

std::string rule(const schedule::Design& design) {
  const schedule::Stopping& rule = design.stopping;
  if (rule.rule == schedule::StopRule::Fixed)
    return fmt::format("fixed number: {} pairs per condition", design.pairs);
  const std::string looks = fmt::format("looked at after {} pairs and then every {}, at most {}",
                                        rule.minimum_pairs, rule.batch_pairs, design.pairs);
  if (rule.rule == schedule::StopRule::Precision) {
    return fmt::format("fixed precision: standard error of A's goal difference at most {:g} a game; {}",
                       rule.standard_error, looks);
  }
  const std::size_t count = questions(design).size();
  const std::string clip = rule.clip ? fmt::format(" (a pair counts at most {:g})", *rule.clip) : "";
  return fmt::format("sequential test of A's {}{}: H0 {:g} against {}, alpha {:g}{}, beta {:g}; {}",
                     metric_name(design), clip, rule.h0, "H1 " + hypothesis(rule.h1), rule.alpha,
                     count > 1 ? fmt::format(" shared by {} questions", count) : "", rule.beta, looks);
}

std::string sentence(const Standing& standing, const schedule::Design& design) {
  const Question& question = standing.question;
  std::string text = fmt::format("{}: {}, {}: {} after {} pairs", question.name, view(question, design),
                                 metric_name(design), outcome(standing, design), standing.pairs);
  if (standing.pairs < 2 || !standing.score.has_error()) return text;
  const auto shown = [&](double value) { return number(value, question, design); };
  if (design.stopping.rule != schedule::StopRule::Sequential) {
    return text + fmt::format("; {} ± {:.2f} {}", shown(standing.score.mean), standing.score.standard_error,
                              unit(design));
  }
  const stats::Estimate estimate = corrected(standing, design);
  return text + fmt::format(
                    "; estimate corrected for the stopping {} [{}, {}] {} (plain mean {}); LLR {:.2f} in "
                    "[{:.2f}, {:.2f}]",
                    shown(estimate.value), shown(estimate.interval.low), shown(estimate.interval.high),
                    unit(design), shown(standing.score.mean), standing.llr, standing.bounds.lower,
                    standing.bounds.upper);
}

std::string verdict(const Standing& standing) {
  switch (standing.decision) {
    case Decision::AcceptH1:
      return "A is better, says the sequential test (H1 accepted)";
    case Decision::AcceptH0:
      return "A is not better, says the sequential test (H0 accepted)";
    case Decision::GoOn:
      return "not decided yet by the sequential test";
    default:
      return "undecided by the sequential test";
  }
}

std::vector<std::string> sentences(const schedule::Design& design,
                                   std::span<const record::Attempt> attempts) {
  std::vector<std::string> texts;
  if (design.stopping.rule == schedule::StopRule::Fixed) return texts;
  for (const Standing& standing : standings(design, attempts)) texts.push_back(sentence(standing, design));
  return texts;
}

}  // namespace stopping
