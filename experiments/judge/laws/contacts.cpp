#include "experiments/judge/laws/contacts.h"

namespace judge {
namespace {

constexpr double touching = 0.001;  // [m]
constexpr double apart = 0.02;      // [m]

}  // namespace

void Contacts::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  if (!moment.in_play() || moment.entered) {
    for (auto& row : meetings_) {
      for (Meeting& meeting : row) {
        if (meeting.close && !moment.in_play()) part(moment, meeting, out);
        meeting = {};
      }
    }
  }
  if (!moment.in_play()) return;
  for (const truth::Robot& yellow : moment.now.robots) {
    if (yellow.id.team != world::Team::Yellow || yellow.id.number >= numbers) continue;
    for (const truth::Robot& blue : moment.now.robots) {
      if (blue.id.team != world::Team::Blue || blue.id.number >= numbers) continue;
      meet(moment, yellow, blue, meetings_[yellow.id.number][blue.id.number], out);
    }
  }
}

void Contacts::meet(const Moment& moment, const truth::Robot& yellow, const truth::Robot& blue,
                    Meeting& meeting, std::vector<TrueEvent>& out) {
  const world::Field& field = moment.rules.field;
  const world::Vector2d way = blue.position - yellow.position;
  const double between = way.norm() - 2 * field.robot_radius;
  const bool close = between < near_bands * moment.bands.length;
  if (!close || (meeting.met && between > apart)) {
    if (meeting.close) part(moment, meeting, out);
    meeting = {};
    if (!close) return;
  }
  meeting.close = true;
  meeting.least = std::min(meeting.least, between);

  const truth::Robot* a = find_robot(moment.before, yellow.id);
  const truth::Robot* b = find_robot(moment.before, blue.id);
  if (a == nullptr || b == nullptr) return;
  const world::Vector2d line = (b->position - a->position).normalized();
  const double yellows = a->velocity.dot(line);
  const double blues = -b->velocity.dot(line);
  // Once they have met they have been slowed down, and push.
  if (!meeting.met && yellows + blues > meeting.speed) {
    meeting.speed = yellows + blues;
    meeting.nearest.event = Event::Collision;
    meeting.nearest.time = moment.now.time;
    meeting.nearest.value = meeting.speed;
    meeting.nearest.by = yellows > blues ? yellow.id : blue.id;
    meeting.nearest.place = (yellow.position + blue.position) / 2;
  }
  watch_keeper(moment, yellow, blue, between, meeting);
  if (between > touching) return;
  if (!meeting.met) {
    meeting.met = true;
    meeting.nearest.time = moment.now.time;
    meeting.speed = yellows + blues;
    meeting.nearest.event = Event::Collision;
    meeting.nearest.value = meeting.speed;
    meeting.nearest.place = (yellow.position + blue.position) / 2;
    meeting.nearest.by = yellows > blues ? yellow.id : blue.id;
  }
  meeting.last = moment.now.time;
}

void Contacts::watch_keeper(const Moment& moment, const truth::Robot& yellow, const truth::Robot& blue,
                            double between, Meeting& meeting) {
  const world::Field& field = moment.rules.field;
  const bool touch = between <= touching;
  for (const world::Team team : world::both_teams) {
    const truth::Robot& keeper = team == world::Team::Yellow ? yellow : blue;
    if (keeper.id.number != moment.state.keeper[team]) continue;
    const world::Vector2d place = (yellow.position + blue.position) / 2;
    const double depth =
        -world::distance_to_defense_area(field, world::defended_side(moment.state, team), place);
    const double inside = depth / moment.bands.length;
    const double margin = touch ? inside : std::min(inside, -between / moment.bands.length);
    const bool touched = meeting.keeper && meeting.touched_keeper;
    if (touched && !touch) continue;
    const bool first = touch && !touched;
    if (!first && meeting.keeper && meeting.keeper->margin >= margin) continue;
    const world::Time began = touched ? meeting.keeper->time : moment.now.time;
    meeting.touched_keeper = touch;
    meeting.keeper = TrueEvent{.event = Event::KeeperTouched,
                               .time = began,
                               .margin = margin,
                               .value = depth,
                               .by = team == world::Team::Yellow ? blue.id : yellow.id,
                               .place = place};
  }
}

void Contacts::part(const Moment& moment, Meeting& meeting, std::vector<TrueEvent>& out) {
  TrueEvent& hit = meeting.nearest;
  const double too_fast = (meeting.speed - moment.rules.crash_speed) / moment.bands.speed;
  const double missed_by = meeting.met ? 0 : std::max(meeting.least, 1e-9) / moment.bands.length;
  hit.event = Event::Collision;
  hit.margin = meeting.met ? too_fast : std::min(too_fast, -missed_by);
  if (meeting.speed > 0) report(out, hit);
  if (meeting.keeper) {
    TrueEvent& keeper = *meeting.keeper;
    if (meeting.touched_keeper) {
      const double lasted =
          (world::seconds(meeting.last - keeper.time) + world::tick_length) / moment.bands.time;
      keeper.margin = std::min(keeper.margin, lasted);
    }
    report(out, keeper);
  }
}

}  // namespace judge
