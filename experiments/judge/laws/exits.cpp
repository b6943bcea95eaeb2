#include "experiments/judge/laws/exits.h"

#include <utility>

namespace judge {

using world::Vector2d;

namespace {

constexpr double robot_height = 0.15;  // [m]
constexpr double crowd = 0.15;         // [m] centre of a robot's hull to the ball (reference football, 4.4)
constexpr double on_carpet = 0.001;    // [m]
constexpr int ticks_on_carpet = 3;     // a hop of 1 mm lasts less than two
constexpr world::Duration settle = std::chrono::milliseconds{500};  // for the margin
constexpr world::Duration back_in = std::chrono::seconds{1};        // inside again for so long: in play again
constexpr world::Duration kept = std::chrono::seconds{5};
constexpr world::Duration at_line = 2 * one_tick;

Vector2d centre(const truth::Ball& ball) { return ball.position.head<2>(); }

}  // namespace

void Exits::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  seen_.emplace_back(moment.now.time, moment.ball_seen);
  while (seen_.front().first + kept < moment.now.time) seen_.pop_front();

  const double outside = moment.outside(moment.now.ball);
  if (moment.in_play() && moment.entered) {
    armed_ = outside <= 0;
    out_since_.reset();
    chips_ = {};
    low_ = {};
    approach_.reset();
    if (!armed_ && !moment.by_hand && moment.outside(moment.before.ball) <= 0) early_ = crossing(moment);
    if (!armed_ && early_) {
      out_since_ = moment.now.time;
      pending_ = std::move(early_);
    }
    early_.reset();
  }
  watch_heights(moment);

  if (pending_) {
    Pending& pending = *pending_;
    if (!moment.by_hand) pending.deepest = std::max(pending.deepest, outside);
    const bool over = moment.by_hand || outside <= 0 || moment.now.time >= pending.event.time + settle;
    pending.event.until = moment.now.time;
    if (over) finish(moment.bands, out);
  }
  if (!moment.in_play() || moment.by_hand) {
    if (approach_ && !moment.by_hand) out.push_back(*approach_);
    approach_.reset();
    if (moment.by_hand || outside <= 0) {
      early_.reset();
    } else if (moment.outside(moment.before.ball) <= 0) {
      early_ = crossing(moment);
    }
    return;
  }
  if (armed_ && outside > 0) {
    out_since_ = moment.now.time;
    pending_ = crossing(moment);
    armed_ = false;
    approach_.reset();
    inside_since_.reset();
    return;
  }
  if (!armed_) {
    if (outside > 0 && !pending_) inside_since_.reset();
    if (outside <= 0 && !inside_since_) inside_since_ = moment.now.time;
    if (outside <= 0 && inside_since_ && moment.now.time >= *inside_since_ + back_in) {
      armed_ = true;
      out_since_.reset();
    }
    return;
  }
  const double margin = outside / moment.bands.length;
  if (margin > -near_bands && (!approach_ || margin > approach_->margin)) {
    approach_ = TrueEvent{.event = Event::Exit, .time = moment.now.time, .margin = margin, .value = outside};
    approach_->place = moment.ball();
  }
  if (approach_) approach_->until = moment.now.time;
  if (approach_ && margin < -near_bands - 0.5) {
    out.push_back(*approach_);
    approach_.reset();
  }
}

void Exits::finish(const Bands& bands, std::vector<TrueEvent>& out) {
  if (!pending_) return;
  TrueEvent& event = pending_->event;
  event.value = pending_->deepest;
  event.margin = std::max(std::min(pending_->deepest / bands.length, pending_->most), 1e-9);  // it did happen
  // Nobody need have seen it: the next one is judged at once.
  if (event.margin < 1) inside_since_ = event.time - back_in;
  out.push_back(event);
  if (pending_->nearly) report(out, *pending_->nearly);
  if (pending_->icing) {
    pending_->icing->margin = std::min(pending_->icing->margin, event.margin);
    report(out, *pending_->icing);
  }
  pending_.reset();
}

void Exits::watch_heights(const Moment& moment) {
  const world::Field& field = moment.rules.field;
  for (const TrueTouches::Contact& contact : moment.touches.fresh()) {
    const TrueTouch& touch = moment.touches[contact.touch];
    crowd_touch_ = contact.touch;
    world::PerTeam<bool> there{};
    for (const truth::Robot& robot : moment.now.robots) {
      if ((robot.position - moment.ball()).norm() < crowd) there[robot.id.team] = true;
    }
    crowded_ = there.yellow && there.blue;
    const bool low = moment.now.ball.position.z() + field.ball_radius <= moment.rules.chip_height;
    std::optional<Chip>& chip = chips_[touch.robot.team];
    if (low && chip && chip->by != touch.robot) chip.reset();
    std::optional<Chip>& flight = low_[touch.robot.team];
    if (flight && flight->by != touch.robot) flight.reset();
  }
  // What it does behind the line is no matter any more.
  if (std::abs(moment.ball().x()) > field.half_length()) return;
  rolling_ = moment.now.ball.position.z() - field.ball_radius < on_carpet ? rolling_ + 1 : 0;
  if (rolling_ >= ticks_on_carpet) {
    chips_ = {};
    low_ = {};
  }
  const double top = moment.now.ball.position.z() + field.ball_radius;
  const auto* last = moment.touches.last_at(moment.now.time);
  if (last == nullptr || top <= moment.rules.chip_height - near_bands * moment.bands.length) return;
  const world::RobotId by = moment.touches[last->touch].robot;
  if (top <= moment.rules.chip_height) {
    std::optional<Chip>& flight = low_[by.team];
    if (!flight) flight = Chip{by, top};
    flight->highest = std::max(flight->highest, top);
    return;
  }
  std::optional<Chip>& chip = chips_[by.team];
  if (!chip || chip->by != by) chip = Chip{by, top};
  chip->highest = std::max(chip->highest, top);
}

std::optional<Exits::Pending> Exits::crossing(const Moment& moment) const {
  const world::Field& field = moment.rules.field;
  const double before = moment.outside(moment.before.ball);
  const double now = moment.outside(moment.now.ball);
  const double share = before < 0 ? before / (before - now) : 0;
  const Vector2d from = centre(moment.before.ball);
  const Vector2d to = centre(moment.now.ball);

  Pending pending;
  TrueEvent& event = pending.event;
  event.event = Event::Exit;
  event.time =
      moment.before.time + world::from_seconds(share * world::seconds(moment.now.time - moment.before.time));
  event.place = from + (to - from) * share;
  pending.deepest = now;

  const auto* contact = moment.touches.last_at(event.time);
  if (contact == nullptr) return std::nullopt;  // nobody ever touched it
  event.last = last_touch(moment, *contact);
  event.by = event.last->robot;
  event.ambiguous = moment.touches.ambiguous(*contact);

  const double z = (1 - share) * moment.before.ball.position.z() + share * moment.now.ball.position.z();
  const bool over_goal_line = std::abs(event.place.x()) > field.half_length();
  const bool between_posts = over_goal_line && std::abs(event.place.y()) < field.goal_width / 2;
  const double below_bar = field.goal_height - z;
  if (between_posts && below_bar > 0) {
    const world::Side side = event.place.x() > 0 ? world::Side::Positive : world::Side::Negative;
    const world::Team attackers = world::opponent(world::defending_team(moment.state, side));
    const std::optional<Chip>& chip = chips_[attackers];
    event.event = chip ? Event::ChippedGoal : Event::Goal;
    pending.most = below_bar / moment.bands.length;
    if (chip) {
      event.by = chip->by;
      pending.most = (chip->highest - moment.rules.chip_height) / moment.bands.length;
    } else if (const std::optional<Chip>& flight = low_[attackers]) {
      const double below = (moment.rules.chip_height - flight->highest) / moment.bands.length;
      pending.most = std::min(pending.most, below);
      pending.nearly = event;
      pending.nearly->event = Event::ChippedGoal;
      pending.nearly->by = flight->by;
      pending.nearly->value = flight->highest;
      pending.nearly->margin = std::min(-below, -1e-9);
    }
  } else {
    event.over_goal = between_posts;
    pending.icing = icing(moment, event);
  }
  return pending;
}

LastTouch Exits::last_touch(const Moment& moment, const TrueTouches::Contact& contact) const {
  const TrueTouch& touch = moment.touches[contact.touch];
  LastTouch last;
  last.robot = touch.robot;
  last.time = contact.time;
  last.kind = touch.kind();
  last.chip = touch.highest > robot_height;
  last.crowded = crowd_touch_ == contact.touch && crowded_;
  last.at_line = moment.now.time - contact.time < at_line;
  last.impulse = touch.impulse;
  last.alone = moment.touches.alone(contact);
  last.lost = longest_unseen(contact.time);
  return last;
}

int Exits::longest_unseen(world::Time from) const {
  int longest = 0;
  int unseen = 0;
  for (const auto& [time, seen] : seen_) {
    unseen = seen ? 0 : unseen + 1;
    if (time >= from) longest = std::max(longest, unseen);
  }
  return longest;
}

std::optional<TrueEvent> Exits::icing(const Moment& moment, const TrueEvent& exit) const {
  const world::Field& field = moment.rules.field;
  if (std::abs(exit.place.x()) <= field.half_length() || std::abs(exit.place.y()) < field.goal_width / 2) {
    return std::nullopt;
  }
  const TrueTouch& touch = moment.touches[moment.touches.last_at(exit.time)->touch];
  const double own = world::sign(world::defended_side(moment.state, touch.robot.team));
  if (exit.place.x() * own > 0) return std::nullopt;
  TrueEvent icing = exit;
  icing.event = Event::AimlessKick;
  icing.by = touch.robot;
  icing.value = touch.place.x() * own - moment.rules.icing_margin;
  icing.margin = icing.value / moment.bands.length;
  return icing;
}

}  // namespace judge
