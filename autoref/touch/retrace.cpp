#include "autoref/touch/retrace.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "autoref/touch/free_ball.h"

namespace touch {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector4d;

constexpr std::size_t most = 20;            // hypotheses kept
constexpr std::size_t most_branches = 512;  // of one step
constexpr double least_weight = 1e-6;       // of all
constexpr double robot_height = 0.15;       // [m]
constexpr double front_half_width = 0.05;   // [m] dribbler zone

struct Hypothesis {
  double weight = 0;
  double age = 1;                  // [s] of the course
  std::size_t last = robot_slots;  // toucher
  world::Time touched;
  Vector2d place = Vector2d::Zero();
  Vector4d x = Vector4d::Zero();  // position, velocity
  Matrix4d p = Matrix4d::Zero();
  FreeBall ball{};         // its spin, and how high it hops; the velocity is in x
  bool spin_known = true;  // else what friction does is anybody's guess until it rolls
};

double phi(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

/// A robot at an instant.
struct Hull {
  std::size_t slot;
  Vector2d position;
  double orientation;
  Vector2d velocity;
  double turn;  // [rad/s]
};

class Retracing {
 public:
  Retracing(const Trail& trail, const world::Field& field, double noise, const RetraceParams& params)
      : trail_(trail), field_(field), noise_(noise), params_(params) {}

  Retraced run() {
    Retraced result;
    int n = 0;
    while (n < trail_.count() && !trail_[n].seen) ++n;
    if (n == trail_.count()) return result;
    begin(trail_[n]);
    for (++n; n < trail_.count(); ++n) {
      under_ = 0;
      for (int near = std::max(0, n - 3); near < std::min(trail_.count(), n + 3); ++near)
        under_ |= trail_[near].under;
      step(trail_[n - 1], trail_[n]);
    }
    std::array<double, robot_slots> best{};
    for (std::size_t h = 0; h < count_; ++h) {
      const Hypothesis& one = now_[h];
      if (one.last >= robot_slots) continue;
      result.probability[one.last] += one.weight;
      if (one.weight <= best[one.last]) continue;
      best[one.last] = one.weight;
      result.time[one.last] = one.touched;
      result.place[one.last] = one.place;
    }
    return result;
  }

 private:
  void begin(const TrailPoint& point) {
    Hypothesis h;
    h.x << point.ball, 0, 0;
    h.p.diagonal() << noise_ * noise_, noise_ * noise_, 9, 9;
    h.touched = point.time;
    h.place = point.ball;
    h.last = point.told;
    h.weight = point.told < robot_slots ? point.probability : 1;
    now_[count_++] = h;
    if (h.weight < 1) {
      h.last = robot_slots;
      h.weight = 1 - h.weight;
      now_[count_++] = h;
    }
  }

  void step(const TrailPoint& from, const TrailPoint& to) {
    next_count_ = 0;
    const double dt = world::seconds(to.time - from.time);
    airborne_ = to.airborne;
    leaving_ = from.airborne;
    flies_ = from.height > 0 && to.height > 0;
    above_ = std::min(from.height, to.height) > robot_height;
    gather(from, to, dt);
    double near = 1;
    for (std::size_t r = 0; r < hull_count_; ++r) near = std::min(near, gap_to(to.ball, hulls_[r], dt));
    sigma_ = std::hypot(noise_, to.sigma, near < params_.beside ? params_.beside_sigma : 0.0);
    for (std::size_t h = 0; h < count_; ++h) advance(now_[h], from, to, dt);
    prune();
  }

  /// Robots of both points, as they move in between.
  void gather(const TrailPoint& from, const TrailPoint& to, double dt) {
    hull_count_ = 0;
    const auto add = [&](const Sighting::Robot& was, const Sighting::Robot& is) {
      if (hull_count_ == hulls_.size() || (under_ >> was.slot & 1U) != 0) return;
      hulls_[hull_count_++] = {was.slot, was.position, was.orientation, (is.position - was.position) / dt,
                               world::wrap_angle(is.orientation - was.orientation) / dt};
    };
    for (std::size_t r = 0; r < from.robot_count; ++r) {
      const Sighting::Robot* is = to.find(from.robots[r].slot);
      add(from.robots[r], is ? *is : from.robots[r]);
    }
    for (std::size_t r = 0; r < to.robot_count; ++r) {
      if (!from.find(to.robots[r].slot)) add(to.robots[r], to.robots[r]);
    }
  }

  double gap_to(const Vector2d& ball, const Hull& hull, double t) const {
    const Vector2d arm = ball - (hull.position + hull.velocity * t);
    return hull_gap(world::rotated(arm, -(hull.orientation + hull.turn * t)), field_);
  }

  void predict(Hypothesis& h, double dt) const {
    if (dt <= 0) return;
    const Vector2d v = h.x.tail<2>();
    const double speed = v.norm();
    const Vector2d u = speed > 0.02 ? Vector2d(v / speed) : Vector2d(1, 0);
    double along = params_.roll_sigma, across = params_.roll_curve;
    h.age += dt;
    if (flies_) {
      h.x.head<2>() += v * dt;
    } else if (!h.spin_known && h.age < params_.slide_least + params_.slide_per_speed * speed) {
      const double loss = std::min(speed, params_.slide_friction * dt);
      h.x.head<2>() += (v - u * (loss / 2)) * dt;
      h.x.tail<2>() = v - u * loss;
      along = params_.slide_sigma;
      across = params_.slide_curve;
    } else {
      if (!h.spin_known) {
        h.spin_known = true;
        h.ball = {.velocity = v, .spin = v};
      }
      h.ball.velocity = v;
      if (h.ball.hops()) {
        along = across = params_.hop_sigma;
      } else if (!h.ball.rolls()) {
        along = across = params_.spin_sigma;
      }
      h.x.head<2>() += move(h.ball, dt, {});
      h.x.tail<2>() = h.ball.velocity;
    }
    // P = F P F' + Q, by blocks.
    const Matrix2d pv = h.p.block<2, 2>(0, 2);
    const Matrix2d vv = h.p.block<2, 2>(2, 2);
    h.p.block<2, 2>(0, 0) += dt * (pv + pv.transpose()) + dt * dt * vv;
    h.p.block<2, 2>(0, 2) += dt * vv;
    along = std::pow(along * dt, 2);
    across = speed > 0.1 ? std::pow(across * dt, 2) : along;
    if (airborne_ > 0.2) along = across = std::pow(params_.air_sigma * dt, 2);
    const Matrix2d q = across * Matrix2d::Identity() + (along - across) * u * u.transpose();
    h.p.block<2, 2>(2, 2) += q;
    h.p.block<2, 2>(0, 2) += q * (dt / 2);
    h.p.block<2, 2>(0, 0) += q * (dt * dt / 4);
    h.p.block<2, 2>(2, 0) = h.p.block<2, 2>(0, 2).transpose();
  }

  /// Where the camera shows a ball that hops: on the ground, beyond it.
  Vector2d as_seen(const Hypothesis& h, const TrailPoint& to) const {
    const Vector2d place = h.x.head<2>();
    if (!(h.ball.height > 0) || to.height > 0 || !h.spin_known) return place;
    const world::Vector3d camera = trail_.camera_near(to.ball);
    return place + (place - camera.head<2>()) * (h.ball.height / (camera.z() - h.ball.height));
  }

  /// The sighting at the end of a step; false when it speaks against the course.
  bool correct(Hypothesis& h, const TrailPoint& to) {
    if (!to.seen) return true;
    if (to.other_camera) h.p.topLeftCorner<2, 2>().diagonal().array() += std::pow(params_.switch_sigma, 2);
    Matrix2d s = h.p.topLeftCorner<2, 2>();
    s.diagonal().array() += sigma_ * sigma_;
    const double det = s.determinant();
    Matrix2d inverse;
    inverse << s(1, 1), -s(0, 1), -s(1, 0), s(0, 0);
    inverse /= det;
    const Vector2d off = to.ball - as_seen(h, to);
    const double chi2 = off.dot(inverse * off);
    const double wide2 = params_.wide * params_.wide;
    const double density =
        (1 - params_.outliers) *
        ((1 - params_.rough) * std::exp(-chi2 / 2) + params_.rough / wide2 * std::exp(-chi2 / (2 * wide2))) /
        (2 * std::numbers::pi * std::sqrt(det));
    const double floor = params_.outliers / (std::numbers::pi * 0.15 * 0.15);
    h.weight *= density + floor;
    if (density < floor) return false;
    const Eigen::Matrix<double, 4, 2> gain = h.p.leftCols<2>() * inverse;
    const bool rolls = h.spin_known && h.ball.rolls();
    h.x += gain * off;
    h.ball.velocity = h.x.tail<2>();
    if (rolls) h.ball.spin = h.ball.velocity;
    h.p -= (gain * h.p.topRows<2>()).eval();
    return chi2 < 16;
  }

  void keep(const Hypothesis& h) {
    if (next_count_ < next_.size() && h.weight > 0) next_[next_count_++] = h;
  }

  void advance(const Hypothesis& h, const TrailPoint& from, const TrailPoint& to, double dt) {
    // Where it would go if nobody touched it, and how near it would come to whom.
    const double speed = h.x.tail<2>().norm();
    const int parts = std::clamp(static_cast<int>(std::ceil(speed * dt / 0.006)), 2, 12);
    double untouched = 1;
    for (std::size_t r = 0; r < hull_count_ && !above_; ++r) {
      const Hull& hull = hulls_[r];
      double least = 1;
      double when = 0;
      bool met = false;
      for (int part = 0; part <= parts; ++part) {
        const double t = dt * part / parts;
        const double gap = gap_to(h.x.head<2>() + h.x.tail<2>() * t, hull, t);
        if (met || gap >= least) continue;
        least = gap;
        when = t;
        met = gap < 0;  // the first meeting counts
      }
      const double own =
          std::sqrt(std::max(h.p(0, 0), h.p(1, 1)) + dt * dt * std::max(h.p(2, 2), h.p(3, 3)) / 4);
      const double sigma = std::hypot(std::hypot(params_.hull_sigma, airborne_ * params_.air_gap),
                                      sigma_ > noise_ ? params_.beside_sigma : 0.0, own);
      if (least > 5 * sigma + params_.reach) continue;
      const double ground = 1 - airborne_;
      if (hull.slot != h.last) {
        const double chance = std::max(params_.overlap_floor, phi((least + sigma) / sigma));
        untouched *= ground * chance + airborne_;
      }
      touched_by(h, hull, when, dt, from, to, (1 - 0.9 * std::min(leaving_, airborne_)) * params_.touch);
    }
    Hypothesis free = h;
    free.weight *= untouched;
    const Hypothesis before = free;
    predict(free, dt);
    const bool fits = correct(free, to);
    keep(free);
    if (fits || !to.seen) return;
    find_anew(before, to);
    Hypothesis broken = before;  // a post, a hop, a wall
    predict(broken, dt / 2);
    broken.weight *= near_post(broken.x.head<2>()) ? params_.post_break : params_.free_break;
    if (airborne_ > 0.2) broken.weight *= 10;
    broken.p.block<2, 2>(2, 2) += Matrix2d::Identity() * 1.5 * 1.5;
    broken.age = 0;
    broken.spin_known = false;
    predict(broken, dt / 2);
    correct(broken, to);
    keep(broken);
  }

  /// The ball is not where any course leads: whatever happened, it goes on from here.
  void find_anew(const Hypothesis& h, const TrailPoint& to) {
    Hypothesis anew = h;
    anew.x << to.ball, 0, 0;
    anew.p.setZero();
    anew.age = 0;
    anew.ball = {};
    anew.spin_known = false;
    anew.p.diagonal() << noise_ * noise_, noise_ * noise_, 9, 9;
    anew.weight *= 1e-3;
    keep(anew);
    for (std::size_t r = 0; r < to.robot_count && !above_; ++r) {
      const Sighting::Robot& robot = to.robots[r];
      if (robot.slot == h.last ||
          hull_gap(world::rotated(to.ball - robot.position, -robot.orientation), field_) > 0.03)
        continue;
      Hypothesis by = anew;
      by.last = robot.slot;
      by.touched = to.time;
      by.place = to.ball;
      by.weight *= 0.3;
      keep(by);
    }
  }

  bool near_post(const Vector2d& ball) const {
    return std::abs(std::abs(ball.x()) - field_.half_length()) < 0.15 &&
           std::abs(std::abs(ball.y()) - field_.goal_width / 2) < 0.1;
  }

  void touched_by(const Hypothesis& h, const Hull& hull, double when, double dt, const TrailPoint& from,
                  const TrailPoint& to, double weight) {
    const Vector2d arm_now = h.x.head<2>() - hull.position;
    const Vector2d local = world::rotated(arm_now, -hull.orientation);
    const bool at_front = local.x() > 0 && std::abs(local.y()) < front_half_width;
    // A fast ball is seen to turn round a little after it met the hull: contact lasts, or, in simulators, is
    // found at the next step.
    const double speed = (h.x.tail<2>() - hull.velocity).norm();
    const int instants = std::clamp(static_cast<int>(std::ceil(speed * params_.dwell / 0.005)), 1, 5);
    for (int n = 0; n < instants; ++n) {
      const double t = instants > 1 ? when + params_.dwell * n / (instants - 1) : when;
      if (n > 0 && t > dt) break;
      touch_at(h, hull, t, dt, from, to, weight / instants, at_front, false);
    }
    if (!at_front) return;
    for (const double share : {0.1, 0.37, 0.63, 0.9}) {
      touch_at(h, hull, share * dt, dt, from, to, weight / 4, true, true);
    }
  }

  void touch_at(const Hypothesis& h, const Hull& hull, double t, double dt, const TrailPoint& from,
                const TrailPoint& to, double weight, bool at_front, bool kick) {
    Hypothesis at = h;
    predict(at, t);
    const Vector2d centre = hull.position + hull.velocity * t;
    const double heading = hull.orientation + hull.turn * t;
    const Vector2d arm = at.x.head<2>() - centre;
    const double gap = hull_gap(world::rotated(arm, -heading), field_);
    const Vector2d ahead(std::cos(heading), std::sin(heading));
    const Vector2d normal = at_front ? ahead : Vector2d(arm.normalized());
    const Vector2d side(-normal.y(), normal.x());
    // It lay against the hull then.
    const Matrix2d pp = at.p.topLeftCorner<2, 2>();
    const double own = normal.dot(pp * normal);
    const double hull2 = std::pow(params_.hull_sigma, 2) + std::pow(airborne_ * params_.air_gap, 2) +
                         (sigma_ > noise_ ? std::pow(params_.beside_sigma, 2) : 0.0);
    const double total = own + hull2;
    // Kicker and dribbler reach before the front.
    double beyond = gap;
    if (gap > 0 && kick) beyond = std::max(0.0, gap - params_.reach);
    const double deep = gap < 0 ? (at.x.tail<2>() - hull.velocity).norm() * params_.dwell : 0.0;
    if (gap < 0) beyond = std::min(0.0, gap + deep);
    const double fit = std::exp(-beyond * beyond / (2 * total)) * std::sqrt(2.5e-5 / (2.5e-5 + own));
    if (fit * weight < 1e-5) return;
    if (beyond != 0) {
      const Vector4d gain = at.p.leftCols<2>() * normal / total;
      at.x -= gain * beyond;
      at.p -= (gain * (normal.transpose() * at.p.topRows<2>())).eval();
    }
    at.weight *= weight * fit;
    const bool out = world::distance_outside_lines(field_, at.x.head<2>()) > field_.ball_radius;
    if (!out) {
      at.last = hull.slot;
      at.touched = from.time + world::from_seconds(t);
      at.place = at.x.head<2>();
    }
    const Vector2d surface = hull.velocity + hull.turn * Vector2d(-arm.y(), arm.x());
    const Vector2d relative = at.x.tail<2>() - surface;
    const double into = -relative.dot(normal);
    const double slip = relative.dot(side);
    const auto branch = [&](double share, const Vector2d& velocity, double sigma_n, double sigma_t,
                            bool added, bool hard, double off = 0, const FreeBall* ball = nullptr) {
      if (share * weight * fit < 1e-6) return;
      Hypothesis b = at;
      b.weight *= share;
      b.x.tail<2>() = velocity;
      if (hard) {
        b.age = 0;
        b.spin_known = ball != nullptr && to.seen;
        b.ball = ball != nullptr ? *ball : FreeBall{};
      } else if (b.spin_known && b.ball.rolls()) {
        b.ball = {.velocity = velocity, .spin = velocity};
      }
      if (off > 0) {  // deep in a hull it may come out somewhere else
        b.p.topLeftCorner<2, 2>() +=
            off * off * normal * normal.transpose() + off * off / 8 * side * side.transpose();
      }
      const Matrix2d spread =
          sigma_n * sigma_n * normal * normal.transpose() + sigma_t * sigma_t * side * side.transpose();
      if (added) {
        b.p.block<2, 2>(2, 2) += spread;
      } else {
        b.p.block<2, 2>(2, 2) = spread;
        b.p.block<2, 2>(0, 2).setZero();
        b.p.block<2, 2>(2, 0).setZero();
      }
      predict(b, dt - t);
      correct(b, to);
      keep(b);
    };
    const Vector2d v = at.x.tail<2>();
    if (kick) {
      const FreeBall kicked{};  // leaves without spin
      branch(params_.kick, surface + 3.5 * normal, 2.2, 0.12, false, true, 0, &kicked);
      branch(params_.grip, v, 0.1, 0.1, true, false);
      return;
    }
    const double in = std::max(0.0, into);
    const double deeper = params_.recoil * in * params_.dwell;
    const auto bounced = [&](double share, double restitution) {
      FreeBall ball = at.ball;
      ball.velocity = v;
      if (!at.spin_known) ball.spin = v;
      if (in > 0) bounce(ball, normal, surface, restitution);
      branch(share, ball.velocity, params_.bounce_sigma * in + 0.05, params_.bounce_side * in + 0.03, true,
             in > 0.3, deeper, &ball);
    };
    const double dead = at_front ? params_.dead : 0;
    bounced(params_.bounce * (1 - dead), params_.restitution);
    if (dead > 0) bounced(params_.bounce * dead, params_.dead_restitution);
    branch(params_.other_bounce, v + 1.3 * in * normal - 0.15 * slip * side, 0.35 * in + 0.05,
           0.2 * in + 0.1 * std::abs(slip) + 0.03, true, in > 0.3, deeper);
    branch(params_.carry, surface, 0.15, 0.15, false, true);
    branch(params_.graze, v + 0.06 * normal, 0.08, 0.04, true, false);
    branch(params_.wild, v + 0.8 * normal, 1.2, 1.0, true, true, deeper);
  }

  void prune() {
    double sum = 0;
    for (std::size_t n = 0; n < next_count_; ++n) sum += next_[n].weight;
    count_ = 0;
    if (!(sum > 0)) return;
    // The heaviest first; equal ones in the order in which they came.
    std::array<std::size_t, most_branches> order;
    for (std::size_t n = 0; n < next_count_; ++n) order[n] = n;
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(next_count_),
              [this](std::size_t a, std::size_t b) {
                return next_[a].weight != next_[b].weight ? next_[a].weight > next_[b].weight : a < b;
              });
    double kept = 0;
    for (std::size_t n = 0; n < next_count_; ++n) {
      const Hypothesis& h = next_[order[n]];
      if (h.weight < least_weight * sum) break;
      if (Hypothesis* same = alike(h)) {
        same->weight += h.weight;
        kept += h.weight;
        continue;
      }
      if (count_ == most) continue;
      now_[count_++] = h;
      kept += h.weight;
    }
    for (std::size_t n = 0; n < count_; ++n) now_[n].weight /= kept;
  }

  static bool alike(const FreeBall& a, const FreeBall& b) {
    return std::abs(a.climb - b.climb) < 0.1 && std::abs(a.height - b.height) < 0.005 &&
           (a.spin - b.spin).squaredNorm() < 0.3 * 0.3;
  }
  Hypothesis* alike(const Hypothesis& h) {
    for (std::size_t n = 0; n < count_; ++n) {
      Hypothesis& other = now_[n];
      if (other.last != h.last || other.spin_known != h.spin_known) continue;
      if (h.spin_known && !alike(h.ball, other.ball)) continue;
      const Vector4d off = h.x - other.x;
      const double p2 = std::max(other.p(0, 0), other.p(1, 1));
      const double v2 = std::max(other.p(2, 2), other.p(3, 3));
      if (off.head<2>().squaredNorm() < 4 * p2 && off.tail<2>().squaredNorm() < 4 * v2) return &other;
    }
    return nullptr;
  }

  const Trail& trail_;
  const world::Field& field_;
  double noise_;
  const RetraceParams& params_;
  std::array<Hypothesis, most> now_;
  std::size_t count_ = 0;
  std::array<Hypothesis, most_branches> next_;
  std::size_t next_count_ = 0;
  std::array<Hull, 2 * Sighting::most_robots> hulls_;
  std::size_t hull_count_ = 0;
  double airborne_ = 0, leaving_ = 0;  // at the end of the step, and at its beginning
  bool flies_ = false;                 // all the time, in a flight that is known
  bool above_ = false;
  std::uint32_t under_ = 0;  // robots it flies over, as bits
  double sigma_ = 0;
};

}  // namespace

Retraced retrace(const Trail& trail, const world::Field& field, double noise, const RetraceParams& params) {
  return Retracing(trail, field, noise, params).run();
}

}  // namespace touch
