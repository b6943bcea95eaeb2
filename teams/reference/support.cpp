#include "teams/reference/support.h"

#include <algorithm>

#include "teams/reference/legal.h"
#include "teams/skills/motion.h"

namespace reference {
namespace {

constexpr int think_every = 12;     // ticks: 5 Hz
constexpr int think_rarely = 30;    // while places are kept
constexpr double kept_after = 1.0;  // [s] of a stoppage: places in it are chosen by then (reference_team)
constexpr double replan = 1.0;      // [s] (reference "football", 2.10)
constexpr double late_start = 0.3;  // [s] a receiver needs to see that the ball was kicked
constexpr double most_ahead = 0.3;  // [m] from the place of the pass
constexpr double undecided = 0.15;  // [m] the ball must be over the middle line to change its side

// How far a robot gets from rest to rest in that time [m].
double way_in(double time, const skills::Limits& limits) {
  return time * time / (2 * (1 / limits.acceleration + 1 / limits.brake));
}

}  // namespace

// Who goes to which zone: new when the ball's zone or the robots change, or after a second.
void Supports::plan_zones(const kit::View& view, std::span<const kit::Robot* const> robots) {
  const Vector2d ball = view.ball.position;
  const bool side_before = left_;
  if (std::abs(ball.y()) > undecided) left_ = ball.y() > 0;
  const Zone zone = partition_.zone_of(ball);
  const bool changed = !(zone == ball_zone_) || left_ != side_before || robots.size() != planned_for_ ||
                       std::any_of(robots.begin(), robots.end(),
                                   [this](const auto* robot) { return of(robot->number).zone < 0; });
  if (!changed && view.time - planned_at_ < replan) return;
  ball_zone_ = zone;
  planned_at_ = view.time;
  planned_for_ = robots.size();
  const ZoneList list = zones_for(zone, left_);
  std::array<int, most_supports> before{};
  for (std::size_t i = 0; i < robots.size(); ++i) before[i] = of(robots[i]->number).zone;
  const auto order = assign_zones(partition_, list, robots, before);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    Member& member = of(robots[i]->number);
    const int assigned = index_of(list[static_cast<std::size_t>(order[i])]);
    if (assigned != member.zone) member.place = {};
    member.zone = assigned;
  }
}

void Supports::think(const kit::View& view, const Situation& situation, const Roles& roles,
                     const Parameters& parameters, const std::optional<Kick>& coming) {
  target_count_ = 0;
  anchor_ = anchor_of(view.field(), view.ball.position.x(), anchor_);
  partition_ = Partition(view.field(), anchor_);
  std::array<const kit::Robot*, most_supports> found{};
  std::size_t count = 0;
  for (const kit::Robot& robot : view.own) {
    Member& member = of(robot.number);
    const bool support = roles.of(robot.number) == Role::Support && count < found.size();
    if (support) found[count++] = &robot;
    if (!support || !member.support) {
      member = {};
      member.support = support;
    }
  }
  if (count == 0) return;
  const std::span robots(found.data(), count);
  const bool kept = is_dead(view.game.phase) && view.game.age > kept_after;
  map_.refresh(view, situation.model, partition_, !kept && situation.possession != Possession::Theirs);

  // Until the pass can be played: nobody knows while the ball is not ours.
  double kick_time = 9;
  const kit::Robot* winner = kit::find(view.own, roles.winner);
  if (situation.possession == Possession::Ours && winner != nullptr) {
    kick_time = std::min(time_to_ball(view, situation, *winner) + 0.2, 8.9);
  }
  const int every = kept ? think_rarely : think_every;
  const bool zones = parameters.attack == "zones";
  if (zones) plan_zones(view, robots);

  std::array<Vector2d, most_supports> taken;
  std::size_t taken_count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const kit::Robot& robot = *robots[i];
    Member& member = of(robot.number);
    member.set_place = set_play_place(view, static_cast<int>(i));
    member.expected = coming && coming->kind == Kick::Kind::Pass && coming->receiver == robot.number;
    const Chooser waiting{&robot, kick_time, member.place.grid};
    const Chooser receiving{&robot, kick_time, member.expected ? member.target.grid : -1};
    if (member.place.grid < 0 || (view.tick + 2 * robot.number) % every == 0) {
      if (zones) {
        const Zone zone{member.zone / 3, member.zone % 3 - 1};
        member.place = best_in_zone(map_, zone, waiting);
        member.target = best_in_zone(map_, zone, receiving);
      } else {
        member.place = best_anywhere(map_, std::span(taken.data(), taken_count), waiting);
        member.target = member.place;
      }
    }
    if (member.set_place && set_play(view) != SetPlay::NeutralStart) {
      targets_[target_count_++] = {robot.number, set_play_target(view, *member.set_place)};
    } else if (member.place.grid >= 0 && set_play(view) != SetPlay::Kickoff) {
      targets_[target_count_++] = {robot.number, member.target.position};
      taken[taken_count++] = member.place.position;
    }
  }
}

skills::Order Supports::play(const kit::View& view, const kit::Robot& robot) const {
  const Member& member = of(robot.number);
  skills::Order order;
  order.why = "support";
  order.heading = world::angle_of(view.ball.position - robot.position);
  order.ball_distance = 0.15;
  order.their_area = 0.1;
  order.target = robot.position;
  if (member.set_place) {
    order.why = "set play";
    order.target = *member.set_place;
  } else if (member.place.grid >= 0) {
    // Pass ahead: not on the place itself but as far from it as the time of the pass lets it come
    // (reference "football", 2.6: a receiver that stands is marked).
    const Place& place = member.expected && member.target.grid >= 0 ? member.target : member.place;
    order.target = place.position;
    const Vector2d back = robot.position - order.target;
    const double distance = back.norm();
    const double ahead =
        std::min({way_in(std::max(0.0, place.ball_time - late_start), skills::driving_limits(robot.specs)),
                  most_ahead, distance});
    if (distance > 1e-6) order.target += back * (ahead / distance);
  }
  return order;
}

}  // namespace reference
