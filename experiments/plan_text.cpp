#include "experiments/plan_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/schedule/schedule.h"
#include "experiments/stats/power.h"
#include "experiments/stats/sequential.h"
#include "experiments/stopping/question.h"
#include "experiments/stopping/wording.h"

namespace commands {
namespace {

constexpr double night = 10 * 3600;  // [s]
// Without earlier games: half of robot soccer's games are draws where few goals fall (harness reference 2.5).
constexpr double usual_draws = 0.3;

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 90 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string size(const schedule::Design& design) {
  return fmt::format("{}: {} {} x {} {} x 2 games = {} games, rule set {}, realism {}\n", design.name,
                     design.conditions.size(), design.conditions.size() == 1 ? "condition" : "conditions",
                     design.pairs, design.pairs == 1 ? "pair" : "pairs", schedule::game_count(design),
                     design.rules, record::text(design.realism));
}

std::string time(const schedule::Design& design, const Speed& speed, int workers) {
  const double all = speed.game_seconds * static_cast<double>(schedule::game_count(design)) / workers;
  return fmt::format(
      "time: {} for all games, {:.1f} s each, {} at a time; a night of 10 h holds {:.0f} games\n  ({})\n"
      "  (besides, before the first: builds, and twice a game of about 1.5 min simulated for each two "
      "teams)\n",
      duration(all), speed.game_seconds, workers, night / speed.game_seconds * workers, speed.source);
}

/// What a question can show: for one condition as an example when all are alike.
std::string power(const schedule::Design& design, const std::optional<Spread>& spread) {
  const std::vector<stopping::Question> questions = stopping::questions(design);
  if (design.pairs == 1) return "what 1 pair shows: nothing, since it does not tell how far pairs differ\n";
  std::string text = fmt::format(
      "what {} pairs show of a difference that is there in 4 of 5 experiments (two-sided, 5 %, {}):\n",
      design.pairs, questions.size() > 1 ? "each question by itself" : "A against B");
  const double correlation = spread ? spread->correlation : 0;
  const bool has_plain =
      std::any_of(questions.begin(), questions.end(), [](const auto& one) { return !one.panel; });
  if (has_plain) {
    const double draws = spread ? spread->draws : usual_draws;
    text +=
        fmt::format("  share of games won, A's minus B's: {:.1f} points if {:.0f} % of the games are draws\n",
                    100 * stats::detectable_win_share(design.pairs, draws, correlation), 100 * draws);
  }
  for (const bool panel : {false, true}) {
    const auto question =
        std::find_if(questions.begin(), questions.end(), [&](const auto& one) { return one.panel == panel; });
    if (question == questions.end()) continue;
    // Deviation of a pair's score in deviations of a game: 1/sqrt(2), or 1/sqrt(k) against k opponents.
    const double games = panel ? static_cast<double>(question->terms.size()) / 2 : 2;
    const double effect =
        stats::detectable_effect(design.pairs) / std::sqrt(games) * std::sqrt(panel ? 1 : 1 + correlation);
    text += fmt::format("  goal difference {}: {:.2f} standard deviations of a game",
                        panel ? "of A and B against the panel" : "A - B", effect);
    if (spread) {
      text += fmt::format(", that is {:.2f} goals a game\n", effect * spread->goal_deviation);
    } else {
      text += fmt::format(
          ", that is {:.2f} goals a game where both score 1 together, {:.2f} where 4, {:.2f} where 9", effect,
          2 * effect, 3 * effect);  // Poisson: the deviation is the root of the goals
      text += "\n";
    }
  }
  text += spread
              ? fmt::format(
                    "  (deviation {:.2f} goals, correlation within pairs {:+.2f}, {:.0f} % draws: seen in {} "
                    "games)\n",
                    spread->goal_deviation, spread->correlation, 100 * spread->draws, spread->games)
              : std::string(
                    "  (goals taken as Poisson numbers, games of a pair as independent; --from RESULTS takes "
                    "both from earlier games)\n");
  constexpr int fewest = 6;  // 2 / 2^5 = 0.0625
  if (design.pairs < fewest) {
    text += fmt::format(
        "  (the sign flips over {} pairs cannot come below p = {:g}, whatever happens; {} pairs can reach 5 "
        "%)\n",
        design.pairs, std::pow(2.0, 1 - design.pairs), fewest);
  }
  return text;
}

std::string course(const schedule::Design& design, const std::optional<Speed>& speed, int workers) {
  const std::vector<stopping::Question> questions = stopping::questions(design);
  const stats::SequentialPlan plan = stopping::sequential_plan(design, questions.front(), questions.size());
  std::string text = "expected course of the sequential test" +
                     std::string(questions.size() > 1 ? ", each question" : "") + ":\n";
  const double t0 = plan.hypotheses.t0;
  const double t1 = plan.hypotheses.t1;
  const double games_a_pair = 2.0 * static_cast<double>(questions.front().terms.size());
  const auto line = [&](const std::string& truth, double t) {
    const stats::ExpectedCourse course = stats::expected_course(plan, t);
    const double pairs =
        std::clamp(course.pairs, static_cast<double>(plan.first_look), static_cast<double>(plan.cap));
    text +=
        fmt::format("  if the truth is {}: {:.0f} pairs, {:.0f} games", truth, pairs, games_a_pair * pairs);
    if (speed) text += fmt::format(", {}", duration(games_a_pair * pairs * speed->game_seconds / workers));
    text += fmt::format("; A is called better in {:.1f} %", 100 * course.accept_h1);
    text += course.pairs > static_cast<double>(plan.cap) ? "; the cap will often leave it undecided\n" : "\n";
  };
  line(fmt::format("H0 ({:g})", design.stopping.h0), t0);
  line("half way", (t0 + t1) / 2);
  line(fmt::format("H1 ({:g})", design.stopping.h1), t1);
  line("twice as far", t0 + 2 * (t1 - t0));
  return text;
}

std::string precision(const schedule::Design& design, const std::optional<Spread>& spread) {
  if (!spread) return "";
  const double h = design.stopping.standard_error;
  const double deviation = stats::pair_deviation(spread->goal_deviation, spread->correlation);
  const double pairs = std::max(std::ceil(deviation * deviation / (h * h)),
                                static_cast<double>(design.stopping.minimum_pairs));
  return fmt::format("expected: {:.0f} pairs per condition for a standard error of {:g}{}\n", pairs, h,
                     pairs > design.pairs ? fmt::format("; the design allows {} only", design.pairs) : "");
}

}  // namespace

std::string plan_text(const schedule::Design& design, const std::optional<Speed>& speed,
                      const std::optional<Spread>& spread, int workers) {
  std::string text = size(design);
  if (speed) text += time(design, *speed, workers);
  text += "stopping: " + stopping::rule(design) + "\n";
  text += power(design, spread);
  if (design.stopping.rule == schedule::StopRule::Sequential) text += course(design, speed, workers);
  if (design.stopping.rule == schedule::StopRule::Precision) text += precision(design, spread);
  return text;
}

}  // namespace commands
