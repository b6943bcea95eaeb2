#include "autoref/touch/origin.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace touch {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double deceleration = 1.2;     // [m/s^2] between rolling and sliding, and how far from it:
constexpr double deceleration_s = 1.2;   // football.md 5
constexpr double curve_s = 0.7;          // [m/s^2] across: a ball that slides with spin
constexpr double gate = 4;               // sigmas, per axis
constexpr double beside_robot = 0.04;    // [m] a robot so near hides a part of the ball now and then
constexpr double beside_sigma = 0.0012;  // [m] what this does
constexpr double clear_sigma = 0.0005;   // [m] what a straight course leaves out
constexpr double step = 1.0 / 240;       // [s] of the search for the instant
constexpr double hull_sigma = 0.002;     // [m] of a robot's hull in an image
constexpr double hidden_sigma = 0.02;    // [m/s] more of it, per second without a sighting: the robot moved
constexpr double leaves_sigma = 0.15;    // [m/s]
constexpr double friction = 0.5;         // of a push goes sideways
constexpr double sideways = 0.3;         // [m/s] and so much more
constexpr double sideways_share = 0.15;  // of the change, too
constexpr double far_share = 0.1;        // of contacts are seen less well,
constexpr double far_factor = 4;         // by so much
constexpr double any_push = 0.05;        // weight of a push in a direction that none has

/// Straight with friction, in a frame along the newest sightings: x = a + b t + c t^2 / 2 along, y = d + e t.
class Line {
 public:
  Line(const View& view, double noise) : zero_(view[0].time), origin_(view[0].ball), noise_(noise) {
    const Vector2d way = view[0].ball - view[Course::samples - 1].ball;
    along_ = way.norm() > 0 ? Vector2d(way.normalized()) : Vector2d(1, 0);
    information_(2, 2) = 1 / (deceleration_s * deceleration_s);
    right_x_(2) = -deceleration / (deceleration_s * deceleration_s);
    information_y_(2, 2) = 1 / (curve_s * curve_s);
  }

  void add(const Sighting& sighting) {
    const double sigma = sigma_of(sighting);
    const Vector3d row = row_at(sighting.time);
    const Vector2d at = local(sighting.ball);
    information_ += row * row.transpose() / (sigma * sigma);
    information_y_ += row * row.transpose() / (sigma * sigma);
    right_x_ += row * at.x() / (sigma * sigma);
    right_y_ += row * at.y() / (sigma * sigma);
  }
  void solve() {
    inverse_ = information_.inverse();
    inverse_y_ = information_y_.inverse();
    x_ = inverse_ * right_x_;
    y_ = inverse_y_ * right_y_;
  }
  bool holds(const Sighting& sighting) const {
    const Vector3d row = row_at(sighting.time);
    const double sigma2 = std::pow(sigma_of(sighting), 2);
    const Vector2d off = local(sighting.ball) - Vector2d(row.dot(x_), row.dot(y_));
    return off.x() * off.x() < gate * gate * (sigma2 + row.dot(inverse_ * row)) &&
           off.y() * off.y() < gate * gate * (sigma2 + row.dot(inverse_y_ * row));
  }
  Vector2d at(world::Time time) const {
    const Vector3d row = row_at(time);
    return global(Vector2d(row.dot(x_), row.dot(y_))) + origin_;
  }
  Vector2d velocity(world::Time time) const {
    const double t = world::seconds(time - zero_);
    return global({x_(1) + x_(2) * t, y_(1) + y_(2) * t});
  }
  double sigma(world::Time time) const {
    const Vector3d row = row_at(time);
    return std::sqrt(std::max(row.dot(inverse_ * row), row.dot(inverse_y_ * row)));
  }

 private:
  Vector3d row_at(world::Time time) const {
    const double t = world::seconds(time - zero_);
    return {1, t, t * t / 2};
  }
  double sigma_of(const Sighting& sighting) const {
    return std::hypot(noise_, sighting.gap < beside_robot ? beside_sigma : clear_sigma);
  }
  Vector2d local(const Vector2d& place) const {
    const Vector2d off = place - origin_;
    return {off.dot(along_), along_.x() * off.y() - along_.y() * off.x()};
  }
  Vector2d global(const Vector2d& v) const {
    return v.x() * along_ + v.y() * Vector2d(-along_.y(), along_.x());
  }

  world::Time zero_;
  Vector2d origin_;
  Vector2d along_;
  double noise_;
  Matrix3d information_ = Matrix3d::Zero();
  Matrix3d information_y_ = Matrix3d::Zero();
  Vector3d right_x_ = Vector3d::Zero();
  Vector3d right_y_ = Vector3d::Zero();
  Matrix3d inverse_, inverse_y_;
  Vector3d x_, y_;
};

double bell(double x) { return std::exp(-x * x / 2); }

/// How well a change of velocity is a push along the normal.
double as_push(const Vector2d& change, const Vector2d& normal) {
  const double along = change.dot(normal);
  const double across = std::abs(change.x() * normal.y() - change.y() * normal.x());
  const double beyond = std::max(0.0, across - friction * std::max(0.0, along));
  const double pulled = std::max(0.0, -along);
  return bell(std::hypot(beyond, pulled) / (sideways + sideways_share * change.norm()));
}

}  // namespace

double Origin::best() const {
  double best = 0;
  for (std::size_t n = 0; n < count; ++n) best = std::max(best, candidates[n].fit);
  return best;
}

const Origin::Candidate* Origin::find(std::size_t robot) const {
  for (std::size_t n = 0; n < count; ++n) {
    if (candidates[n].robot == robot) return &candidates[n];
  }
  return nullptr;
}

Origin trace_origin(const View& view, double noise, const world::Field& field) {
  Origin origin;
  const int kept = view.kept();
  if (kept <= Course::samples) return origin;
  Line line(view, noise);
  for (int n = 0; n < Course::samples; ++n) line.add(view[n]);
  line.solve();
  int first = Course::samples - 1;  // oldest on the course
  int before = -1;                  // the next older one
  for (int n = Course::samples; n < kept; ++n) {
    if (line.holds(view[n])) {
      line.add(view[n]);
      line.solve();
      first = n;
      continue;
    }
    if (n + 1 < kept && line.holds(view[n + 1])) continue;
    before = n;
    break;
  }
  if (before < 0) return origin;
  before = first + 1;
  origin.found = true;
  const Sighting& old = view[before];
  const Sighting& fresh = view[first];
  origin.earliest = old.time;
  origin.latest = first > 0 ? view[first - 1].time : fresh.time;
  const double hidden = world::seconds(fresh.time - old.time);

  // Velocity before the break, if the older sightings tell.
  const bool has_older = before + 1 < kept;
  const Vector2d older_velocity =
      has_older
          ? Vector2d((old.ball - view[before + 1].ball) / world::seconds(old.time - view[before + 1].time))
          : Vector2d(0, 0);
  const auto ask = [&](const Sighting::Robot& was, const Sighting::Robot& is, world::Time from,
                       world::Time to) {
    Origin::Candidate best;
    best.robot = is.slot;
    const double length = world::seconds(to - from);
    const Vector2d robot_velocity = (is.position - was.position) / length;
    const double turn = world::wrap_angle(is.orientation - was.orientation);
    for (world::Time time = origin.earliest; time <= origin.latest; time += world::from_seconds(step)) {
      const double share = world::seconds(time - from) / length;
      const Vector2d ball = line.at(time);
      const Vector2d arm = ball - (was.position + (is.position - was.position) * share);
      const double gap = hull_gap(world::rotated(arm, -(was.orientation + turn * share)), field);
      const double sigma = std::hypot(hull_sigma + hidden_sigma * hidden, noise, line.sigma(time));
      const double near = (1 - far_share) * bell(gap / sigma) + far_share * bell(gap / (far_factor * sigma));
      const Vector2d normal = arm.normalized();
      const Vector2d after = line.velocity(time);
      const double leaves =
          0.5 * std::erfc(-(after - robot_velocity).dot(normal) / (leaves_sigma * std::sqrt(2.0)));
      double push = any_push;
      if (has_older) push = std::max(push, as_push(after - older_velocity, normal));
      const double since = world::seconds(time - old.time);
      if (since > step / 2) push = std::max(push, as_push(after - (ball - old.ball) / since, normal));
      push = std::max(push, as_push(after - robot_velocity, normal));
      const double fit = near * leaves * push;
      if (fit <= best.fit) continue;
      best.fit = fit;
      best.time = time;
      best.place = ball;
    }
    if (best.fit > 0) origin.candidates[origin.count++] = best;
  };
  for (std::size_t n = 0; n < old.robot_count; ++n) {
    const Sighting::Robot& was = old.robots[n];
    const Sighting::Robot* is = fresh.find(was.slot);
    ask(was, is ? *is : was, old.time, fresh.time);
  }
  for (std::size_t n = 0; n < fresh.robot_count && origin.count < origin.candidates.size(); ++n) {
    const Sighting::Robot& is = fresh.robots[n];
    if (!old.find(is.slot)) ask(is, is, old.time, fresh.time);
  }
  return origin;
}

}  // namespace touch
