#include "autoref/touch/algorithms.h"

#include <algorithm>
#include <cassert>

#include "sim/world/time.h"

namespace touch {
namespace {

constexpr double between_tolerance = 0.1;  // of the length of the piece (paper, 6.5.2)
constexpr double straight_cosine = 0.99;   // (paper, 6.5.2)

/// `middle` is "between" the two others (paper, 6.5.2). A piece without length has no middle: false.
bool is_between(const Vector2d& newer, const Vector2d& middle, const Vector2d& older) {
  return (middle - (newer + older) / 2).norm() < between_tolerance * (newer - older).norm();
}

bool passes_within(std::span<const Vector2d> d, double bound) {
  for (std::size_t n = 0; n + 1 < d.size(); ++n) {
    if (world::distance({d[n], d[n + 1]}, Vector2d::Zero()) < bound) return true;
  }
  return false;
}

/// The course fitted to four positions was within `inside` of the centre one or two frames before them.
bool comes_from_within(std::span<const Vector2d> d, double inside) {
  // Least squares over n = 0..3: the mean is at n = 1.5, the slope is sum((n - 1.5) d_n) / 5.
  const Vector2d mean = (d[0] + d[1] + d[2] + d[3]) / 4;
  const Vector2d slope = (-1.5 * d[0] - 0.5 * d[1] + 0.5 * d[2] + 1.5 * d[3]) / 5;
  const auto course = [&](int n) -> Vector2d { return mean + slope * (n - 1.5); };
  return course(4).norm() < inside || course(5).norm() < inside;
}

}  // namespace

double accel_measure(std::span<const Vector2d> ball) {
  assert(ball.size() >= 3);
  constexpr double f = world::ticks_per_second;
  return (ball[1] - (ball[0] + ball[2]) / 2).norm() * f * f;
}

bool line_says_touch(std::span<const Vector2d> d, double reach) {
  assert(d.size() >= 6);
  if (!is_between(d[0], d[1], d[2]) || !is_between(d[3], d[4], d[5])) return false;
  const Vector2d newer = d[2] - d[0];
  const Vector2d older = d[5] - d[3];
  if (newer.dot(older) >= straight_cosine * newer.norm() * older.norm()) return false;
  const auto meeting = world::line_intersection({d[0], d[2]}, {d[3], d[5]});
  return meeting && meeting->norm() < reach;
}

bool line_says_touch_as_coded(std::span<const Vector2d> d, double reach) {
  if (!line_says_touch(d, reach)) return false;
  constexpr double inner = 0.9;  // of the way from a piece's outer end to its inner one (requirements, I-23)
  const Vector2d meeting = *world::line_intersection({d[0], d[2]}, {d[3], d[5]});
  const auto share = [&](const Vector2d& outer_end, const Vector2d& inner_end) {
    const Vector2d way = inner_end - outer_end;
    return (meeting - outer_end).dot(way) / way.squaredNorm();
  };
  return share(d[0], d[2]) >= inner && share(d[5], d[3]) >= inner &&
         meeting.norm() < std::min(d[0].norm(), d[5].norm());
}

bool backtrack_says_touch(std::span<const Vector2d> d, double contact, double inside) {
  assert(d.size() >= 4);
  return !passes_within(d.first(4), contact) && comes_from_within(d.first(4), inside);
}

bool backtrack_says_touch_as_coded(std::span<const Vector2d> d, double over, double inside) {
  assert(d.size() >= 8);
  return !passes_within(d.subspan(4, 4), over) && comes_from_within(d.first(4), inside);
}

}  // namespace touch
