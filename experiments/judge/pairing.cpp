#include "experiments/judge/pairing.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace judge {
namespace {

/// 0: clear; 1: close to the limit; 2: a near miss; 3: nothing.
int rank(const TrueEvent& event) {
  if (event.ambiguous && event.event != Event::Exit) return 1;
  if (event.margin >= 1) return 0;
  return event.margin > -1 ? 1 : 2;
}

/// In time, between a call and an event [s].
double distance(const TrueEvent& event, world::Time call) {
  const double late = world::seconds(call - event.time);
  // A clear exit or goal has its moment; what goes on may be called while it does.
  const bool moment = (event.event == Event::Exit || event.event == Event::Goal) && !event.close();
  if (late < 0 || moment || !event.until) return std::abs(late);
  return std::max(0.0, world::seconds(call - *event.until));
}

}  // namespace

std::string_view name(Result result) {
  constexpr std::array<std::string_view, 3> names = {"found", "missed", "extra"};
  return names[static_cast<std::size_t>(result)];
}

bool Case::late() const {
  return truth && call && truth->clear && call->time > *truth->clear + world::from_seconds(match_window);
}

std::vector<Case> pair(const std::string& shadow, std::vector<TrueEvent> truth,
                       const std::vector<Call>& calls, const world::RuleSet& rules) {
  const bool knows_chips = world::runs(rules, detector_of(Event::ChippedGoal));
  for (TrueEvent& event : truth) {
    if (event.event == Event::ChippedGoal && !knows_chips) event.event = Event::Goal;
  }

  std::vector<Case> cases;
  for (const Event event : all_events()) {
    if (!world::runs(rules, detector_of(event))) continue;
    std::vector<const TrueEvent*> happened;
    std::vector<const Call*> called;
    for (const TrueEvent& one : truth) {
      if (one.event == event) happened.push_back(&one);
    }
    for (const Call& one : calls) {
      if (one.event == event) called.push_back(&one);
    }
    std::ranges::stable_sort(happened, {}, &TrueEvent::time);
    std::ranges::stable_sort(called, {}, &Call::time);
    struct Pair {
      int rank;
      bool other_robot;
      double apart;  // from its beginning
      std::size_t truth, call;
    };
    std::vector<Pair> pairs;
    for (std::size_t t = 0; t < happened.size(); ++t) {
      for (std::size_t c = 0; c < called.size(); ++c) {
        if (distance(*happened[t], called[c]->time) > match_window) continue;
        pairs.push_back({rank(*happened[t]), happened[t]->by != called[c]->by,
                         std::abs(world::seconds(called[c]->time - happened[t]->time)), t, c});
      }
    }
    std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) {
      return std::tuple(a.rank, a.other_robot, a.apart) < std::tuple(b.rank, b.other_robot, b.apart);
    });
    std::vector<bool> truth_used(happened.size());
    std::vector<bool> call_used(called.size());
    for (const Pair& one : pairs) {
      if (truth_used[one.truth] || call_used[one.call]) continue;
      truth_used[one.truth] = true;
      const TrueEvent& it = *happened[one.truth];
      if (one.rank == 2) continue;  // the call stays extra; what it was nearly is its remark
      call_used[one.call] = true;
      cases.push_back({shadow, event, Result::Found, it, *called[one.call]});
    }
    for (std::size_t t = 0; t < happened.size(); ++t) {
      const bool is_case = !truth_used[t] && happened[t]->margin > -1 && !happened[t]->late;
      if (is_case) cases.push_back({shadow, event, Result::Missed, *happened[t], std::nullopt});
    }
    for (std::size_t c = 0; c < called.size(); ++c) {
      if (call_used[c] || called[c]->late) continue;
      Case extra{shadow, event, Result::Extra, std::nullopt, *called[c]};
      for (const TrueEvent& other : truth) {
        if (std::abs(world::seconds(other.time - called[c]->time)) > match_window) continue;
        if (other.event != event && !other.happened()) continue;
        extra.remark += (extra.remark.empty() ? "" : ", ") + std::string(judge::name(other.event)) +
                        (other.happened() ? "" : " nearly");
      }
      cases.push_back(std::move(extra));
    }
  }
  return cases;
}

}  // namespace judge
