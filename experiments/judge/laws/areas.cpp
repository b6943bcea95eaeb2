#include "experiments/judge/laws/areas.h"

namespace judge {
namespace {

constexpr world::Duration same_offence = std::chrono::seconds{2};
constexpr world::Duration let_go = std::chrono::milliseconds{500};
constexpr double at_hull = 0.005;  // [m]

}  // namespace

namespace {

/// Whether another robot, also of the same team, touched the ball within a tick before or in this tick: then
/// nobody outside can say which of them did.
bool among_others(const Moment& moment, const TrueTouches::Contact& contact) {
  const auto other = [&](const TrueTouches::Contact& one) {
    return moment.touches[one.touch].robot != moment.touches[contact.touch].robot;
  };
  if (std::ranges::any_of(moment.touches.fresh(), other)) return true;
  return std::ranges::any_of(
      moment.touches.all().rbegin(),
      moment.touches.all().rbegin() + std::min<std::ptrdiff_t>(6, std::ssize(moment.touches.all())),
      [&](const TrueTouch& touch) {
        return touch.robot != moment.touches[contact.touch].robot && contact.time - touch.end <= one_tick;
      });
}

}  // namespace

void Areas::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  const world::Field& field = moment.rules.field;
  const bool play = moment.in_play() && moment.outside(moment.now.ball) <= 0;
  for (Open& open : open_) {
    if (open.worst && (!play || moment.now.time - moment.touches[*open.touch].end > TrueTouches::apart)) {
      finish(open, out);
    }
    if (moment.in_play() && moment.entered) open.reported.reset();
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
      const Event kind = defender ? Event::DefenderInArea : Event::AttackerInArea;
      Open& open = open_[n];
      const world::Side side = defender ? own : world::other(own);
      const double depth = field.robot_radius - world::distance_to_defense_area(field, side, robot->position);
      const double margin = depth / moment.bands.length;
      if (margin <= -near_bands) continue;
      if (open.worst && open.touch != contact.touch) continue;
      const bool among = among_others(moment, contact);
      if (open.worst && margin > 0 && open.worst->happened()) {
        open.worst->until = contact.time;
        open.worst->ambiguous = open.worst->ambiguous && among;
      }
      if (open.worst && open.worst->margin >= margin) continue;
      if (open.reported && contact.time - *open.reported < same_offence) {
        const auto same = std::ranges::find(out.rbegin(), out.rend(), kind, &TrueEvent::event);
        if (same != out.rend() && same->by == touch.robot && margin > 0) same->until = contact.time;
        continue;
      }
      // Who dribbles into the area offends when the hull is in it.
      const bool went_on = open.worst && open.worst->happened();
      const world::Time began = went_on ? open.worst->time : contact.time;
      open.touch = contact.touch;
      open.worst = TrueEvent{.event = kind,
                             .time = began,
                             .until = contact.time,
                             .margin = margin,
                             .value = depth,
                             .by = touch.robot,
                             .place = robot->position,
                             .ambiguous = went_on ? open.worst->ambiguous : among};
    }
  }
}

void Areas::finish(Open& open, std::vector<TrueEvent>& out) {
  report(out, *open.worst);
  if (open.worst->happened()) open.reported = open.worst->time;
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
