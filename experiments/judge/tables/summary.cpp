#include <fmt/format.h>

#include <algorithm>

#include "experiments/judge/tables/counting.h"
#include "experiments/judge/tables/parts.h"
#include "experiments/stats/sign_test.h"

namespace judge {
namespace {

double part(std::int64_t good, std::int64_t n) {
  return n > 0 ? static_cast<double>(good) / static_cast<double>(n) : 0;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all;
}

/// Rows of the table, and what they say together.
class Goals {
 public:
  /// @param few  what there is too little of; empty: there is enough
  void add(const std::string& goal, const std::string& asked, const std::string& got, bool reached,
           const std::string& few) {
    if (!asked_) {
      rows.push_back({goal, "", got, ""});
      return;
    }
    const std::string answer = reached ? "yes" : "no";
    rows.push_back({goal, asked, got, few.empty() ? answer : answer + " (" + few + ")"});
    (reached ? yes_ : no_).push_back(goal);
    few_ = few_ || !few.empty();
  }
  /// Nothing of that kind happened.
  void unknown(const std::string& goal, const std::string& asked) {
    rows.push_back({goal, asked_ ? asked : "", "none happened", asked_ ? "not known" : ""});
    if (asked_) not_known_.push_back(goal);
  }
  /// From now on numbers are only told.
  void ask_no_more() { asked_ = false; }
  std::string words() const {
    std::string text =
        fmt::format("{} of {} goals reached.", yes_.size(), yes_.size() + no_.size() + not_known_.size());
    if (!no_.empty()) text += " Not reached: " + joined(no_) + ".";
    if (!not_known_.empty()) text += " Not known: " + joined(not_known_) + ".";
    if (few_) text += " Too few games for the study: where it says so, the number may be chance.";
    return text;
  }
  std::vector<std::vector<std::string>> rows;

 private:
  std::vector<std::string> yes_, no_, not_known_;
  bool few_ = false;
  bool asked_ = true;
};

void add_exits(std::span<const GameResult> games, const Wanted& wanted, Goals& goals) {
  const ExitClasses exits(cases_of(games, acting_name, is_exit));
  const std::string few = too_few(exits.clear, wanted.exits, "clear exits");
  const std::string team = fmt::format("at least {}", wanted.last_team);
  const std::string extra = fmt::format("at most {} in 1000", wanted.extra_exits);
  const int called = exits.correct + exits.wrong;
  if (exits.clear == 0) {
    goals.unknown("last team", team);
    if (!wanted.all_goals) goals.ask_no_more();
    goals.unknown("missed exits", "none");
    goals.unknown("extra exits", extra);
    return;
  }
  goals.add("last team", team, share(exits.correct, called), part(exits.correct, called) >= wanted.last_team,
            few);
  if (!wanted.all_goals) goals.ask_no_more();
  goals.add("missed exits", "none", fmt::format("{} of {}", exits.all_missed(), exits.all()),
            exits.all_missed() == 0, few);
  goals.add(
      "extra exits", extra,
      fmt::format("{} and {} in the air: {:.2f} in 1000", exits.extra, exits.chip, exits.extra_in_1000()),
      exits.extra_in_1000() <= wanted.extra_exits, few);
}

void add_goals(std::span<const GameResult> games, const Wanted& wanted, Goals& goals) {
  const GoalClasses all(games, acting_name);
  const std::string few = too_few(all.goals, wanted.goals, "goals");
  const int extra = all.extra + all.chip_extra;
  if (all.found + extra == 0) {
    goals.unknown("false goals", "none");
  } else {
    goals.add("false goals", "none", fmt::format("{} of {} called", extra, all.found + extra), extra == 0,
              few);
  }
  if (all.goals == 0) return goals.unknown("missed goals", "none");
  goals.add("missed goals", "none", fmt::format("{} of {}", all.missed, all.goals), all.missed == 0, few);
}

/// Precision or recall of every event that was called, or happened.
void add_events(std::span<const GameResult> games, const Wanted& wanted, bool precision, Goals& goals) {
  std::vector<std::string> below, few, never;
  int known = 0;
  for (const Event event : all_events()) {
    if (event == Event::Exit || event == Event::Goal) continue;
    const EventClasses all(games, acting_name, event);
    const int of = precision ? all.called() : all.happened();
    const std::string what(name(event));
    if (of == 0) {
      never.push_back(what);
      continue;
    }
    ++known;
    const bool enough = all.happened() >= wanted.events && all.near_misses >= wanted.near_misses;
    if (!enough) few.push_back(what);
    if (part(all.found, of) >= wanted.event) continue;
    below.push_back(fmt::format("{} {}/{}{}", what, all.found, of, enough ? "" : " (too few)"));
  }
  const std::string goal = fmt::format("{} of other events", precision ? "precision" : "recall");
  const std::string asked = fmt::format("at least {} each", wanted.event);
  if (known == 0) return goals.unknown(goal, asked);
  std::string got = fmt::format("{} of {} events", known - std::ssize(below), known);
  if (!below.empty()) got += ", below: " + joined(below);
  if (!never.empty()) got += fmt::format("; {} never {}", never.size(), precision ? "called" : "happened");
  goals.add(goal, asked, got, below.empty(),
            few.empty() ? "" : fmt::format("too few cases in {} events", few.size()));
}

void add_likelihood(std::span<const GameResult> games, const Wanted& wanted, Goals& goals) {
  const Sayings sayings = sayings_of(games);
  const auto likelihood = sayings.witness("likelihood");
  const auto three = sayings.witness("all three");
  const std::string goal = "likelihood better than all three";
  const std::string asked = fmt::format("p < {}", wanted.p);
  if (!likelihood || !three || sayings.exits.empty()) return goals.unknown(goal, asked);
  const auto [only_it, only_three] = sayings.against(*likelihood, *three);
  const double p = stats::sign_test(only_it, only_three);
  goals.add(goal, asked, fmt::format("p = {:.2g} ({}:{})", p, only_it, only_three),
            only_it > only_three && p < wanted.p,
            too_few(std::ssize(sayings.exits), wanted.exits, "clear exits"));
}

}  // namespace

Table summary_table(std::span<const GameResult> games, const Wanted& wanted) {
  Table table{"summary", "Summary: what is reached", "", {"goal", "asked", "got", "reached"}, {}};
  Goals goals;
  add_exits(games, wanted, goals);
  add_goals(games, wanted, goals);
  add_events(games, wanted, true, goals);
  add_events(games, wanted, false, goals);
  add_likelihood(games, wanted, goals);
  table.note = goals.words();
  table.rows = std::move(goals.rows);
  return table;
}

}  // namespace judge
