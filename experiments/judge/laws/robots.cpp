#include "experiments/judge/laws/robots.h"

namespace judge {

void RobotsOff::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  if (!moment.in_play() || moment.entered) {
    for (Watched& watched : robots_) {
      finish(watched, out);
      watched = {.window = Window(moment.rules.run_off_time), .told = watched.told};
    }
    too_many_since_ = {};
    reported_ = {};
    for (const world::Team team : world::both_teams) {
      allowed_[team] = moment.rules.robots_per_team - moment.state.red_cards[team] -
                       static_cast<int>(moment.state.yellow_times[team].size());
    }
  }
  if (!moment.in_play()) return;

  world::PerTeam<int> there{};
  for (const truth::Robot& robot : moment.now.robots) {
    ++there[robot.id.team];
    Watched& watched = robots_[slot(robot.id)];
    const double beyond =
        world::distance_outside_lines(moment.rules.field, robot.position) - moment.rules.run_off;
    const double margin = beyond / moment.bands.length;
    if (margin <= -near_bands) watched.told = false;
    if (watched.told) continue;
    if (margin <= -near_bands) {
      finish(watched, out);
      watched = {.window = Window(moment.rules.run_off_time)};
      continue;
    }
    watched.window.add(moment.now.time, margin);
    if (!watched.window.full()) continue;
    const double least = watched.window.least();
    if (watched.worst && least > 0) watched.worst->until = moment.now.time;
    if (watched.worst && watched.worst->margin >= least) continue;
    const world::Time time = watched.passed ? watched.worst->time : moment.now.time;
    watched.passed = watched.passed || least > 0;
    auto clear = watched.worst ? watched.worst->clear : std::nullopt;
    if (!clear && least >= 1) clear = moment.now.time;
    watched.worst = TrueEvent{.event = Event::RobotLeftField,
                              .time = time,
                              .until = moment.now.time,
                              .clear = clear,
                              .margin = least,
                              .value = least * moment.bands.length + moment.rules.run_off,
                              .by = robot.id,
                              .place = robot.position};
  }
  for (const world::Team team : world::both_teams) {
    std::optional<world::Time>& since = too_many_since_[team];
    if (there[team] <= allowed_[team]) {
      since.reset();
      continue;
    }
    if (!since) since = moment.now.time;
    if (reported_[team] || moment.now.time - *since < moment.rules.surplus_robot_time) continue;
    reported_[team] = true;
    report(out, {.event = Event::TooManyRobots,
                 .time = moment.now.time,
                 .margin = near_bands,
                 .value = static_cast<double>(there[team]),
                 .by = world::RobotId{team, 0}});
  }
}

void RobotsOff::finish(Watched& watched, std::vector<TrueEvent>& out) {
  if (watched.worst) {
    report(out, *watched.worst);
    watched.told = watched.worst->margin > 0;
  }
  watched.worst.reset();
}

}  // namespace judge
