#include "experiments/judge/laws/areas.h"

namespace judge {
namespace {

constexpr world::Duration same_offence = std::chrono::milliseconds{300};  // the window of matching
constexpr world::Duration let_go = std::chrono::milliseconds{500};
constexpr double at_hull = 0.005;  // [m]

/// Whether an opponent touched the ball within a tick before or in this tick.
bool among_opponents(const Moment& moment, const TrueTouches::Contact& contact) {
  const world::Team team = moment.touches[contact.touch].robot.team;
  return moment.touches.ambiguous(contact) ||
         std::ranges::any_of(moment.touches.fresh(), [&](const TrueTouches::Contact& other) {
           return moment.touches[other.touch].robot.team != team;
         });
}

}  // namespace

void Areas::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  const world::Field& field = moment.rules.field;
  const bool play = moment.in_play() && moment.outside(moment.now.ball) <= 0;
  for (Open& open : open_) {
    if (open.worst && (!play || moment.now.time - moment.touches[open.touch].end > TrueTouches::apart)) {
      finish(open, out);
    }
    if (moment.in_play() && moment.entered) open.told.reset();
  }
  if (!play) return;
  for (const TrueTouches::Contact& contact : moment.touches.fresh()) {
    const TrueTouch& touch = moment.touches[contact.touch];
    const truth::Robot* robot = find_robot(moment.now, touch.robot);
    if (robot == nullptr || contact.time < moment.state.location_time) continue;
    const world::Side own = world::defended_side(moment.state, touch.robot.team);
    for (std::size_t n = 0; n < open_.size(); ++n) {
      const bool defender = n == 0;
      if (defender && touch.robot.number == moment.state.keeper[touch.robot.team]) continue;
      const world::Side side = defender ? own : world::other(own);
      const double depth = field.robot_radius - world::distance_to_defense_area(field, side, robot->position);
      const double margin = depth / moment.bands.length;
      if (margin <= -near_bands) continue;
      Open& open = open_[n];
      const Event kind = defender ? Event::DefenderInArea : Event::AttackerInArea;
      if (open.told && contact.time - *open.told < same_offence) {
        open.told = contact.time;
        std::ranges::find(out.rbegin(), out.rend(), kind, &TrueEvent::event)->until = contact.time;
        continue;
      }
      if (open.worst && open.touch != contact.touch) {
        // A near miss or a close one hides no clear one.
        const bool more = margin >= 1 ? open.worst->margin < 1 : margin > 0 && !open.worst->happened();
        if (!more) continue;
        finish(open, out);
      }
      if (!open.worst) {
        open.worst.emplace();
        open.worst->event = kind;
        open.worst->by = touch.robot;
        open.worst->margin = -near_bands;
        open.touch = contact.touch;
      }
      TrueEvent& worst = *open.worst;
      if (margin >= 1 && !worst.clear && !among_opponents(moment, contact)) worst.clear = contact.time;
      // Who dribbles into the area offends when the hull is in it.
      if (!worst.happened() && margin > worst.margin) worst.time = contact.time;
      if (margin > 0) worst.until = contact.time;
      if (margin <= worst.margin) continue;
      worst.margin = margin;
      worst.value = depth;
      worst.place = robot->position;
    }
  }
}

void Areas::finish(Open& open, std::vector<TrueEvent>& out) {
  TrueEvent& worst = *open.worst;
  worst.ambiguous = worst.margin >= 1 && !worst.clear;
  if (worst.clear) open.told = worst.until;
  report(out, worst);
  open.worst.reset();
}

void KeeperHolds::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  const world::Field& field = moment.rules.field;
  const auto finish = [&] {
    if (!hold_->reported) {
      const double held = world::seconds(hold_->last - hold_->since);
      report(out, {.event = Event::KeeperHeldBall,
                   .time = hold_->last,
                   .margin = (held - world::seconds(moment.rules.keeper_hold)) / moment.bands.time,
                   .value = held,
                   .by = hold_->keeper,
                   .place = moment.ball()});
    }
    hold_.reset();
  };
  if (hold_ && (!moment.in_play() || moment.entered || moment.now.time - hold_->last > let_go)) finish();
  if (!moment.in_play()) return;
  for (const world::Team team : world::both_teams) {
    const world::Side side = world::defended_side(moment.state, team);
    const world::RobotId id{team, static_cast<std::uint8_t>(moment.state.keeper[team])};
    const truth::Robot* keeper = find_robot(moment.now, id);
    if (keeper == nullptr || world::distance_to_defense_area(field, side, moment.ball()) > 0) continue;
    if (!keeper->ball_contact && gap(field, *keeper, moment.now.ball) > at_hull) continue;
    if (hold_ && hold_->keeper != id) finish();
    if (!hold_) hold_ = Hold{id, moment.now.time, moment.now.time};
    hold_->last = moment.now.time;
    if (!hold_->reported && hold_->last - hold_->since > moment.rules.keeper_hold) {
      hold_->reported = true;
      report(out, {.event = Event::KeeperHeldBall,
                   .time = hold_->last,
                   .margin = near_bands,
                   .value = world::seconds(hold_->last - hold_->since),
                   .by = id,
                   .place = moment.ball()});
    }
  }
}

std::optional<world::RobotId> KeeperHolds::holder() const {
  if (!hold_) return std::nullopt;
  return hold_->keeper;
}

}  // namespace judge
