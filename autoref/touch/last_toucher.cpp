#include "autoref/touch/last_toucher.h"

#include <algorithm>
#include <cmath>

#include "autoref/touch/origin.h"
#include "autoref/touch/retrace.h"

namespace touch {
namespace {

constexpr double likely = 0.1;  // a touch worth remembering; ours
constexpr double sure = 0.5;    // a touch worth telling at once; ours
constexpr double news = 0.05;   // change of a probability worth telling; ours

// How long the ball is outside, in quarters of a sighting: a frame in which it is hidden there counts as one.
constexpr int sighting = 4;
constexpr int first_look = 3 * sighting;  // when the exit is certain (paper, Algorithm 2)
constexpr int last_look = 6 * sighting;   // when it is, behind the mouth of a goal
constexpr double weight_of_others = 3;    // odds for the team that the paper's three name; ours
constexpr double no_witness = 1e-3;       // chance that either is wrong about everything; ours

constexpr double robot_height = 0.15;  // [m] laws of 2015, Law 4 (reference "requirements", R-3.2-1)
constexpr double gravity = 9.81;       // [m/s^2]
// a longer pause ends a contact; ours
constexpr world::Duration one_contact = std::chrono::milliseconds{100};

using Shares = std::array<double, robot_slots>;

/// Each counts half, as logarithms: what is impossible to one is unlikely to both.
/// Source  Genest and Zidek, "Combining probability distributions", Statistical Science, 1986.
Shares pooled(const Shares& one, const Shares& other) {
  const auto both = [](double a, double b) {
    return std::sqrt((std::max(a, 0.0) + no_witness) * (std::max(b, 0.0) + no_witness));
  };
  double nobody_one = 1, nobody_other = 1, all = 0;
  Shares shares{};
  for (std::size_t n = 0; n < robot_slots; ++n) {
    nobody_one -= one[n];
    nobody_other -= other[n];
    if (one[n] > 0 || other[n] > 0) shares[n] = both(one[n], other[n]);
    all += shares[n];
  }
  all += both(nobody_one, nobody_other);
  for (double& share : shares) share /= all;
  return shares;
}

bool at_front(const Vector2d& ball_local) {  // requirements 1.10: the dribbler zone is |y| < 50 mm
  return ball_local.x() > 0 && std::abs(ball_local.y()) < 0.05;
}

}  // namespace

void LastToucher::reset() {
  views_.reset();
  trail_.reset();
  outside_ = 0;
  visit_.reset();
  belief_.fill(0);
  told_.reset();
  flew_.reset();
  struck_.reset();
}

void LastToucher::update(const world::TrackedFrame& frame, std::span<const world::Detection> images,
                         const std::optional<world::Touch>& second_opinion, std::vector<world::Touch>& out) {
  const View* view = views_.add(frame, images, field_);
  fresh_.reset();
  trail_.add(frame, images, told_.value_or(robot_slots), told_ ? belief_[*told_] : 0);
  const int before = outside_;
  if (frame.ball && frame.ball->observed) {
    const double out_by = world::distance_outside_lines(field_, frame.ball->position.head<2>());
    outside_ = out_by > field_.ball_radius ? outside_ + sighting : 0;
  } else if (frame.ball && is_out(frame.ball->position.head<2>())) {
    ++outside_;
  }
  if (before < first_look && outside_ >= first_look) at_the_time_ = belief_;
  for (const int look : {first_look, last_look}) {
    if (before < look && outside_ >= look) look_back(second_opinion, out);
  }
  if (outside_ >= first_look) return;
  if (frame.ball && !frame.ball->observed) {
    if (!is_out(frame.ball->position.head<2>())) judge_hidden(frame);
    tell({}, out);
    return;
  }
  if (frame.ball && frame.ball->airborne > 0.5) flew_ = frame.time;
  if (frame.ball && frame.ball->flight && frame.ball->flight->struck) {
    believe_strike(*frame.ball);
    if (fresh_) return tell(fresh_, out);
  }
  if (!view || frame.ball->position.z() > robot_height) return;  // above everybody
  const bool flew = flew_ && frame.time - *flew_ < params_.after_flight;
  const double airborne = std::max(frame.ball->airborne, flew ? params_.flies_on : 0.0);
  const Sighting& now = (*view)[0];
  if (!visit_ && now.gap < params_.visit) {
    visit_.emplace(Visit{});  // clang: emplace() does not see the defaults of a nested class
    visit_->begin = now.time;
    visit_->before = belief_;
    visit_->course = view->course;
    visit_->camera = view->camera;
  }
  if (!visit_) return;
  // Between two sightings a fast ball may have been nearer than in either.
  const double gap = now.gap - (now.ball - (*view)[1].ball).norm() / 2;
  if (gap < visit_->closest) {
    visit_->closest = gap;
    visit_->nearest = now.nearest;
  }
  if ((*view)[2].robot_count > 0 && (*view)[3].robot_count > 0) judge_window(*view, *frame.ball, airborne);
  if (view->clear >= Course::samples) end_visit(*view);
  tell(fresh_, out);
}

bool LastToucher::is_out(const Vector2d& ball) const {
  return world::distance_outside_lines(field_, ball) > field_.ball_radius + params_.just_out;
}

void LastToucher::believe_strike(const world::TrackedBall& ball) {
  const world::Flight::Struck& strike = *ball.flight->struck;
  if (struck_ == strike.time || strike.robot.number > world::max_robot_number) return;
  struck_ = strike.time;
  const double share = ball.airborne * params_.struck;
  for (double& b : belief_) b *= 1 - share;
  const std::size_t robot = slot(strike.robot);
  belief_[robot] += share;
  visit_.reset();
  remember(robot, strike.time, ball.position.head<2>());
  fresh_ = robot;
  sure_[robot] = last_[robot];
}

void LastToucher::judge_hidden(const world::TrackedFrame& frame) {
  if (!visit_) return;
  const Vector2d ball = frame.ball->position.head<2>();
  for (const world::TrackedRobot& robot : frame.robots) {
    const Vector2d arm = ball - robot.position;
    if (robot.id.number > world::max_robot_number || arm.squaredNorm() > 0.15 * 0.15) continue;
    const double gap =
        std::max(0.0, hull_gap(world::rotated(arm, -robot.orientation), field_)) / params_.hidden_gap;
    const double share = params_.hidden_touch * std::exp(-gap * gap / 2);
    for (double& b : belief_) b *= 1 - share;
    for (double& b : visit_->within) b *= 1 - share;
    visit_->untouched *= 1 - share;
    belief_[slot(robot.id)] += share;
    visit_->within[slot(robot.id)] += share;
    if (share > params_.hidden_touch / 2) remember(slot(robot.id), frame.time, ball);
  }
}

void LastToucher::judge_window(const View& view, const world::TrackedBall& ball, double airborne) {
  const Sighting& s3 = view[3];
  const Sighting& s2 = view[2];
  struct Near {
    std::size_t robot;
    double weight;
  };
  std::array<Near, Sighting::most_robots> near;
  std::size_t count = 0;
  const double noise = noise_of(view);
  const Broken broken = fit(view, noise);
  if (is_out(broken.place)) return;
  const double free = free_density(broken, airborne, std::min(s2.gap, s3.gap) < params_.hiding, params_);
  double sum = free;
  for (std::size_t n = 0; n < s2.robot_count; ++n) {
    const Sighting::Robot& r2 = s2.robots[n];
    const Sighting::Robot* r3 = s3.find(r2.slot);
    if (!r3) continue;
    const Vector2d moved = r2.position - r3->position;
    const double turn = world::wrap_angle(r2.orientation - r3->orientation);
    const Vector2d arm = broken.place - (r3->position + moved * broken.share);
    const Vector2d local = world::rotated(arm, -(r3->orientation + turn * broken.share));
    const double gap = hull_gap(local, field_);
    if (gap > params_.visit) continue;
    const Vector2d velocity = moved / world::seconds(s2.time - s3.time);
    const bool passes = ball.flight && flies_past(ball, world::seconds(view[0].time - s2.time), *r3);
    const double weight =
        (passes ? params_.unseen_touch : 1 - airborne * params_.too_high) *
        contact_density(broken, {gap, arm.normalized(), velocity, at_front(local)}, noise, free, params_);
    near[count++] = {r2.slot, weight};
    sum += weight;
  }
  if (count == 0 || !(sum > 0)) return;
  ++visit_->windows;

  double touched = 0;
  for (std::size_t n = 0; n < count; ++n) touched += near[n].weight / sum;
  for (double& b : belief_) b *= 1 - touched;
  for (double& b : visit_->within) b *= 1 - touched;
  visit_->untouched *= 1 - touched;
  for (std::size_t n = 0; n < count; ++n) {
    const double share = near[n].weight / sum;
    const std::size_t robot = near[n].robot;
    belief_[robot] += share;
    visit_->within[robot] += share;
    if (share > likely) remember(robot, s2.time, broken.place);
    if (share > sure) {
      fresh_ = robot;
      sure_[robot] = last_[robot];
    }
  }
}

bool LastToucher::flies_past(const world::TrackedBall& ball, double ago, const Sighting::Robot& robot) const {
  const Vector2d there = ball.position.head<2>() - ball.velocity.head<2>() * ago;
  const double height = ball.position.z() - ball.velocity.z() * ago - gravity / 2 * ago * ago;
  const double gap = (there - robot.position).norm() - field_.robot_radius - field_.ball_radius;
  return height > robot_height || gap > params_.flight_gap;
}

void LastToucher::end_visit(const View& view) {
  const Visit visit = *visit_;
  visit_.reset();
  if (!view.course) return;
  const Origin origin = trace_origin(view, noise_of(view), field_);
  double touched = 1 - visit.untouched;
  if (visit.course && visit.camera == view.camera) {
    const double free = passed_freely(*visit.course, *view.course, noise_of(view), params_);
    const double changed = passage_changed(*visit.course, *view.course, params_);
    // The windows have said whether it was touched, unless some of it was hidden from them.
    const double close = std::max(0.0, visit.closest) / params_.trace_sigma;
    const double frames = world::seconds(view[0].time - visit.begin) / world::tick_length;
    const double hidden = std::clamp(1 - (visit.windows + 1) / (frames + 1 - Course::samples), 0.0, 1.0);
    const double prior =
        std::clamp((1 - visit.untouched) + visit.untouched * hidden * 0.5 * std::exp(-close * close / 2),
                   params_.least_prior, 1 - params_.least_prior);
    touched = prior * changed / (prior * changed + (1 - prior) * free);
    if (touched < likely) {
      belief_ = visit.before;
      return;
    }
  }
  if (!origin.found || origin.best() < params_.least_fit) return;
  // Whoever touched it last, the ball came from there.
  Beliefs shares{};
  double sum = 0;
  for (std::size_t n = 0; n < robot_slots; ++n) {
    const Origin::Candidate* candidate = origin.find(n);
    const double fit = (candidate ? candidate->fit : 0) + params_.no_origin;
    shares[n] = touched * (visit.within[n] + (candidate ? params_.unseen_touch : 0)) * fit;
    sum += shares[n];
  }
  // Or nobody did, and something else bent its course.
  const double free = (1 - touched + params_.unseen_touch) * params_.bent;
  sum += free;
  if (!(sum > 0)) return;
  for (std::size_t n = 0; n < robot_slots; ++n) {
    const double share = shares[n] / sum;
    belief_[n] = free / sum * visit.before[n] + share;
    const Origin::Candidate* candidate = origin.find(n);
    if (candidate && share > likely && last_[n].time < origin.earliest)
      remember(n, candidate->time, candidate->place);
  }
}

void LastToucher::look_back(const std::optional<world::Touch>& second_opinion,
                            std::vector<world::Touch>& out) {
  const Retraced retraced = retrace(trail_, field_, views_.noise());
  belief_ = pooled(at_the_time_, retraced.probability);
  if (second_opinion && trail_.count() > 0 && second_opinion->time >= trail_[0].time) {
    const bool yellow = second_opinion->robot.team == world::Team::Yellow;
    double theirs = 0, sum = 0;
    for (std::size_t n = 0; n < robot_slots; ++n) {
      sum += belief_[n];
      if ((robot_in(n).team == world::Team::Yellow) == yellow) theirs += belief_[n];
    }
    const double rest = sum + (weight_of_others - 1) * theirs;
    for (std::size_t n = 0; n < robot_slots && rest > 0; ++n) {
      const bool named = (robot_in(n).team == world::Team::Yellow) == yellow;
      belief_[n] *= sum / rest * (named ? weight_of_others : 1);
    }
  }
  const auto top = static_cast<std::size_t>(std::ranges::max_element(belief_) - belief_.begin());
  if (!(retraced.probability[top] > 0)) return tell({}, out);
  const world::Touch touch{robot_in(top), retraced.time[top], retraced.place[top]};
  first_[top] = last_[top] = touch;
  if (told_ == top) told_touch_ = touch;
  tell({}, out);
}

void LastToucher::remember(std::size_t robot, world::Time when, const Vector2d& place) {
  const world::Touch touch{robot_in(robot), when, place};
  const bool same = last_[robot].robot == touch.robot && when - last_[robot].time < one_contact;
  if (!same) first_[robot] = touch;
  last_[robot] = touch;
}

void LastToucher::tell(std::optional<std::size_t> fresh, std::vector<world::Touch>& out) {
  const auto top = static_cast<std::size_t>(std::ranges::max_element(belief_) - belief_.begin());
  const double probability = belief_[top];
  const bool is_news = fresh == top || told_ != top || std::abs(told_touch_.probability - probability) > news;
  if (!is_news || probability <= 0 || last_[top].robot != robot_in(top)) return;
  const bool known_sure = sure_[top].robot == robot_in(top) && sure_[top].time >= first_[top].time;
  world::Touch touch;
  if (told_ == top) {
    touch = fresh == top ? last_[top] : told_touch_;
  } else {
    touch = fresh != top && known_sure ? sure_[top] : first_[top];
  }
  touch.rival.reset();
  touch.probability = probability;
  double second = 0;
  for (std::size_t n = 0; n < robot_slots; ++n) {
    if (n == top || belief_[n] <= second) continue;
    second = belief_[n];
    touch.rival = robot_in(n);
  }
  told_ = top;
  told_touch_ = touch;
  out.push_back(touch);
}

}  // namespace touch
