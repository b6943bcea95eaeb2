#include "experiments/judge/failures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace judge {
namespace {

constexpr double longest_before = 6.0;  // [s] of a passage that shall show the last touch too

std::string robot_text(const std::optional<world::RobotId>& robot) {
  return robot ? fmt::format("{} {}", world::name(robot->team), robot->number) : std::string("nobody");
}

}  // namespace

std::string sentence(const Case& one) {
  const auto at = [](world::Time time, const world::Vector2d& place) {
    return fmt::format("at {:.3f} s, ({:.2f}, {:.2f}) m", world::seconds(time), place.x(), place.y());
  };
  std::string text;
  if (one.truth) {
    const TrueEvent& truth = *one.truth;
    text = fmt::format("truth: {}, by {}, measured {:.3f}, margin {:.1f} bands", at(truth.time, truth.place),
                       robot_text(truth.by), truth.value, truth.margin);
    if (truth.last) {
      text += fmt::format(", {} {:.2f} s earlier{}{}{}", name(truth.last->kind),
                          world::seconds(truth.time - truth.last->time), truth.last->chip ? ", chip" : "",
                          truth.last->crowded ? ", crowded" : "", truth.over_goal ? ", over the goal" : "");
      if (truth.ambiguous) text += ", ambiguous";
      if (truth.last->lost > 0) text += fmt::format(", ball lost for {} ticks", truth.last->lost);
    }
  } else {
    text = "truth: nothing";
    if (!one.remark.empty()) text += " but: " + one.remark;
  }
  if (!one.call) return text + "; call: none";
  const Call& call = *one.call;
  text += fmt::format("; call: {}, by {}", at(call.time, call.place), robot_text(call.by));
  if (call.last) text += fmt::format(" (probability {:.2f})", call.last->probability);
  if (one.chip) text += ", the ball was in the air";
  return text;
}

std::vector<Failure> failures(std::span<const GameResult> games, const std::string& shadow) {
  std::vector<Failure> failed;
  for (const Event event : all_events()) {
    for (const GameResult& game : games) {
      for (const Case& one : game.cases) {
        if (one.shadow != shadow || one.event != event || one.close()) continue;
        // Of an exit or a goal that was missed it does not matter who touched last.
        const bool leaves = event == Event::Exit || event == Event::Goal;
        if (one.ambiguous() && !(leaves && one.result == Result::Missed)) continue;
        const bool wrong_team = event == Event::Exit && one.result == Result::Found && !one.team_is_right();
        if (one.result == Result::Found && !wrong_team && !one.late()) continue;
        const double tick = world::seconds(one.time()) * world::ticks_per_second;
        const std::string what = wrong_team   ? "last touch wrong"
                                 : one.late() ? "late"
                                              : std::string(name(one.result));
        double before = 2.0;  // [s]
        if (one.truth && one.truth->last) {
          before = std::clamp(world::seconds(one.time() - one.truth->last->time) + 1, before, longest_before);
        }
        failed.push_back({game.game, shadow, std::string(name(event)), what + "; " + sentence(one),
                          std::max(0LL, std::llround(tick - before * world::ticks_per_second)),
                          std::llround(tick) + world::ticks_per_second});
      }
    }
  }
  return failed;
}

}  // namespace judge
