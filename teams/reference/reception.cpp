#include "teams/reference/reception.h"

#include <algorithm>
#include <cmath>

#include "teams/skills/aim.h"
#include "teams/skills/pass.h"

namespace reference {
namespace {

constexpr double weight_of_goal = 0.7;  // w_s; w_a is the rest (ours)
// From farther than this [m] a shot is no threat: the goalie has all the time (ours).
constexpr double far_shot = 5.5;
constexpr double shot_from = 4.0;     // [m] from their goal: a pass there is played for a shot (ours)
constexpr double hopeless = 0.03;     // safety below which nobody asks what would follow
constexpr double time_to_turn = 0.6;  // [s] to stop the ball and turn with it (ours)

// [0..1] by how far it is up the field and how far the pass goes.
double advance_of(const world::Field& field, const Vector2d& point, double length) {
  const double up = std::clamp((point.x() + field.half_length()) / field.length, 0.0, 1.0);
  const double apart = std::clamp((length - 0.5) / 1.0, 0.0, 1.0);  // 1.5 m and more are far enough
  return up * apart;
}

// Of the chance of a goal: what distance leaves of it.
double share_from(double distance, bool guarded) {
  return guarded ? std::clamp((far_shot - distance) / 2.0, 0.0, 1.0) : 1.0;
}

}  // namespace

double Reception::value() const { return safety * (weight_of_goal * goal + (1 - weight_of_goal) * advance); }

bool is_guarded(const kit::View& view) {
  return kit::find(view.opponents, view.game.their_keeper) != nullptr;
}

double goal_chance(double opening_width, double distance, bool guarded) {
  // 0.3 rad: reference "football", 2.5
  return std::min(1.0, opening_width / 0.3) * share_from(distance, guarded);
}

double goal_chance(const kit::View& view, const Vector2d& point, double shot_speed, int shooter,
                   double later) {
  const double distance = (view.their_goal() - point).norm();
  const bool guarded = is_guarded(view);
  if (guarded && distance >= far_shot) return 0;
  return goal_chance(skills::width_to_goal(view, point, shot_speed, shooter, later), distance, guarded);
}

double redirect_share(const kit::View& view, const Vector2d& from, const Vector2d& point) {
  const Vector2d in = from - point;
  const Vector2d out = view.their_goal() - point;
  const double cosine = in.dot(out) / std::max(std::sqrt(in.squaredNorm() * out.squaredNorm()), 1e-9);
  // cos 60 = 0.5, cos 120 = -0.5; linear in the cosine between.
  return 0.4 + 0.6 * std::clamp(cosine + 0.5, 0.0, 1.0);
}

double reach_chance(double own_time, double ball_time) {
  return 1 / (1 + std::exp(-(ball_time + 0.1 - own_time) / 0.1));  // reference "football", 2.6
}

Reception pass_at(const kit::View& view, const kit::BallModel& model, const Vector2d& from,
                  const Vector2d& point, std::optional<double> arrival) {
  Reception r;
  r.share = redirect_share(view, from, point);
  // 3.5 m/s where the ball may be shot on at once, 2.2 where it is to be held (reference "football", 2.6).
  const bool near = (view.their_goal() - point).norm() < shot_from;
  const bool one_touch = near && r.share >= 1 && !arrival;
  const skills::Pass pass =
      skills::plan_pass(view, model, from, point, arrival.value_or(one_touch ? 3.5 : 2.2));
  r.speed = pass.speed;
  r.ball_time = pass.time;
  r.safety = pass.safety;
  r.later = pass.time + (one_touch ? 0.0 : time_to_turn);
  r.advance = advance_of(view.field(), point, (point - from).norm());
  return r;
}

double goal_after(const kit::View& view, const Vector2d& point, const Reception& r, int receiver) {
  return r.safety > hopeless ? r.share * goal_chance(view, point, 6.5, receiver, r.later) : 0;
}

Reception reception_at(const kit::View& view, const kit::BallModel& model, const Vector2d& from,
                       const Vector2d& point, int receiver, std::optional<double> arrival) {
  Reception r = pass_at(view, model, from, point, arrival);
  r.goal = goal_after(view, point, r, receiver);
  return r;
}

// Each factor is at least reception_at's and everything grows with each, rounded too: a true bound.
Reception best_case_at(const kit::View& view, const Vector2d& from, const Vector2d& point) {
  Reception r;
  r.safety = 1;
  r.goal =
      redirect_share(view, from, point) *
      goal_chance(skills::width_of_goal(view, point), (view.their_goal() - point).norm(), is_guarded(view));
  r.advance = advance_of(view.field(), point, (point - from).norm());
  return r;
}

}  // namespace reference
