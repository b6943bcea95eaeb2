#include "sim/vision/occlusion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <numbers>
#include <optional>

namespace vision {
namespace {

using world::Vector2d;
using world::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// A convex polygon, counter-clockwise, in a plane where the ball is the unit disc.
// Room for what two robots hide together: 23 corners each at most. None of them allocates.
using Polygon = boost::container::small_vector<Vector2d, 48>;

// Area and first moments of a part of the unit disc.
struct Part {
  double area = 0;
  Vector2d moment = Vector2d::Zero();
};

// What polygon and disc share. Walks round the polygon and adds triangles from the centre for the pieces of
// its edges inside the disc, and sectors for the arcs between leaving the disc and coming back.
Part shared_with_disc(const Polygon& polygon) {
  Part part;
  if (polygon.size() < 3) return part;
  const auto add_sector = [&](const Vector2d& from, const Vector2d& to) {
    double angle = std::atan2(cross(from, to), from.dot(to));
    constexpr double rounding = 1e-9;  // leaving and coming back at a corner on the circle
    if (angle < -rounding) angle += 2 * std::numbers::pi;
    part.area += angle / 2;
    part.moment += Vector2d(to.y() - from.y(), from.x() - to.x()) / 3;
  };
  bool meets = false, contains_center = true;
  Vector2d first_entry, exit;  // on the circle
  bool first_is_on_circle = false, outside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d& p = polygon[i];
    const Vector2d step = polygon[i + 1 == polygon.size() ? 0 : i + 1] - p;
    contains_center = contains_center && cross(p, step) >= 0;
    const double a = step.squaredNorm(), b = p.dot(step), c = p.squaredNorm() - 1;
    const double discriminant = b * b - a * c;
    if (discriminant <= 0) continue;
    const double root = std::sqrt(discriminant);
    const double begin = std::max((-b - root) / a, 0.0), end = std::min((-b + root) / a, 1.0);
    if (begin >= end) continue;
    const Vector2d from = p + begin * step, to = p + end * step;
    if (outside) add_sector(exit, from);
    if (!meets) {
      meets = true;
      first_entry = from;
      first_is_on_circle = begin > 0;
    }
    const double twice = cross(from, to);
    part.area += twice / 2;
    part.moment += (twice / 6) * (from + to);
    outside = end < 1;
    exit = to;
  }
  if (!meets) {
    if (contains_center) part.area = std::numbers::pi;
  } else if (outside && first_is_on_circle) {
    add_sector(exit, first_entry);
  }
  return part;
}

// Leaves the intersection of two convex polygons in `subject`: cut along each edge of `knife`.
void intersect(Polygon& subject, const Polygon& knife) {
  Polygon kept;
  for (std::size_t i = 0; i < knife.size() && !subject.empty(); ++i) {
    const Vector2d& origin = knife[i];
    const Vector2d edge = knife[i + 1 == knife.size() ? 0 : i + 1] - origin;
    kept.clear();
    for (std::size_t j = 0; j < subject.size(); ++j) {
      const Vector2d& here = subject[j];
      const Vector2d& next = subject[j + 1 == subject.size() ? 0 : j + 1];
      const double inside_here = cross(edge, here - origin), inside_next = cross(edge, next - origin);
      if (inside_here >= 0) kept.push_back(here);
      if ((inside_here >= 0) != (inside_next >= 0)) {
        kept.push_back(here + (next - here) * (inside_here / (inside_here - inside_next)));
      }
    }
    subject = kept;
  }
}

// A polygon with what it hides of the disc.
struct Cover {
  Polygon polygon;
  Part part;
};

// Adds `sign` times what `cover` and its intersections with those from `others` on hide: inclusion and
// exclusion. Branches that do not meet the disc end at once.
void add_hidden(const Cover& cover, double sign, std::span<const Cover> others, Part& hidden) {
  if (cover.part.area <= 0) return;
  hidden.area += sign * cover.part.area;
  hidden.moment += sign * cover.part.moment;
  for (std::size_t i = 0; i < others.size(); ++i) {
    Cover common = cover;
    intersect(common.polygon, others[i].polygon);
    common.part = shared_with_disc(common.polygon);
    add_hidden(common, -sign, others.subspan(i + 1), hidden);
  }
}

// The plane across the line of sight; its axes and the direction to the camera are right-handed, so that what
// goes round counter-clockwise on the field does so here.
struct SightPlane {
  Vector3d camera, sight, right, up;  // [m]; unit vectors
  double distance, disc_radius;       // [m]

  SightPlane(const Vector3d& from, const Vector3d& ball, double ball_radius) : camera(from) {
    const Vector3d way = ball - from;
    distance = way.norm();
    sight = way / distance;
    const double flat = sight.head<2>().norm();
    right = flat > 0 ? Vector3d(-sight.y() / flat, sight.x() / flat, 0) : Vector3d::UnitX();
    up = right.cross(sight);
    disc_radius = ball_radius / std::sqrt(1 - (ball_radius / distance) * (ball_radius / distance));
  }
  Vector2d seen(const Vector2d& point, double height) const {
    const Vector3d way(point.x() - camera.x(), point.y() - camera.y(), height - camera.z());
    const double scale = distance / (way.dot(sight) * disc_radius);
    return {way.dot(right) * scale, way.dot(up) * scale};
  }
  // Whether an upright cylinder comes near the ball's disc: its axis as it is seen, with room for its radius
  // as large as that can be seen, at the nearest point of its top.
  bool may_meet(const Vector2d& axis, double radius, double height) const {
    const Vector3d top(axis.x() - camera.x(), axis.y() - camera.y(), height - camera.z());
    const double nearest = top.dot(sight) - radius;
    if (nearest <= 0) return true;
    const double room = 1 + radius * distance / (nearest * disc_radius);
    const Vector2d nowhere = Vector2d::Zero();
    return world::distance({seen(axis, 0), seen(axis, height)}, nowhere) < room;
  }
};

// The outline of a prism of this base as the camera sees it: far edges at the top, near edges on the carpet.
template <std::size_t count>
void silhouette(const std::array<Vector2d, count>& base, double height, const SightPlane& plane,
                Polygon& outline) {
  const Vector2d foot = plane.camera.head<2>();
  const auto is_far = [&](std::size_t i) {  // edge from corner i to the next
    return cross(base[i] - foot, base[(i + 1) % count] - foot) > 0;
  };
  outline.clear();
  bool before = is_far(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const bool after = is_far(i);
    outline.push_back(plane.seen(base[i], before ? height : 0));
    if (before != after) outline.push_back(plane.seen(base[i], after ? height : 0));
    before = after;
  }
}

}  // namespace

Occlusion::Occlusion(const world::RobotSpecs& body, double ball_radius)
    : radius_(body.radius),
      height_(body.height),
      front_(body.center_to_dribbler),
      half_front_(std::sqrt(radius_ * radius_ - front_ * front_)),
      ball_radius_(ball_radius) {
  const double begin = std::atan2(half_front_, front_);
  const double facet = 2 * (std::numbers::pi - begin) / facets;
  const double same_area = radius_ * std::sqrt(facet / std::sin(facet));  // as the cylinder has
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const bool end_of_front = i == 0 || i + 1 == outline_.size();
    outline_[i] =
        (end_of_front ? radius_ : same_area) * world::direction(begin + facet * static_cast<double>(i));
  }
}

bool Occlusion::ball_in_front(const Vector3d& camera, const Vector3d& ball, const truth::Robot& robot) const {
  const Vector2d local = world::rotated(ball.head<2>() - robot.position, -robot.orientation);
  const double distance = local.norm();
  const bool inside = distance <= radius_ && local.x() <= front_;
  if (inside && ball.z() >= height_) return true;  // on top
  Vector2d nearest, normal;                        // on the wall, and from there to the ball, local
  if (inside) {                                    // pressed into it: out by the shortest way
    normal = front_ - local.x() < radius_ - distance ? Vector2d(1, 0) : Vector2d(local / distance);
    nearest = local;
  } else {
    nearest = distance > radius_ ? Vector2d(local * (radius_ / distance)) : local;
    if (nearest.x() > front_) nearest = {front_, std::clamp(local.y(), -half_front_, half_front_)};
    normal = local - nearest;
  }
  const Vector2d eye = world::rotated(camera.head<2>() - robot.position, -robot.orientation) - nearest;
  const double above = std::max(ball.z() - height_, 0.0);
  return eye.dot(normal) + (camera.z() - std::min(ball.z(), height_)) * above > 0;
}

BallView Occlusion::view(const Vector3d& camera, const Vector3d& ball,
                         std::span<const truth::Robot> robots) const {
  BallView view;
  view.center = ball;
  const double depth = camera.z() - ball.z();
  if (ball.z() - ball_radius_ >= height_) return view;
  // Robots farther than this are nowhere near the ball's disc: what a robot hides moves away from the
  // camera's foot by at most height / (H - height) of the way there.
  const double foot_distance = (ball - camera).head<2>().norm();
  const double slack = 2 * ball_radius_ * (1 + foot_distance / depth);  // half of it: the disc on the carpet
  const double reach = radius_ + slack + (foot_distance + slack) * height_ / (camera.z() - height_);

  boost::container::small_vector<Cover, 4> covers;  // more than four robots between ball and camera are rare
  std::optional<SightPlane> plane;
  for (const truth::Robot& robot : robots) {
    if ((robot.position - ball.head<2>()).squaredNorm() > reach * reach) continue;
    if (ball_in_front(camera, ball, robot)) continue;
    if (!plane) plane.emplace(camera, ball, ball_radius_);
    if (!plane->may_meet(robot.position, radius_, height_)) continue;
    std::array<Vector2d, facets + 1> base;
    const Vector2d forward = world::direction(robot.orientation);
    for (std::size_t i = 0; i < base.size(); ++i) {
      const Vector2d& corner = outline_[i];
      base[i] = robot.position + Vector2d(forward.x() * corner.x() - forward.y() * corner.y(),
                                          forward.y() * corner.x() + forward.x() * corner.y());
    }
    Cover cover;
    silhouette(base, height_, *plane, cover.polygon);
    cover.part = shared_with_disc(cover.polygon);
    if (cover.part.area >= std::numbers::pi) {  // all of it: the others do not matter
      view.share = 0;
      return view;
    }
    if (cover.part.area > 0) covers.push_back(cover);
  }
  Part hidden;
  for (std::size_t i = 0; i < covers.size(); ++i) {
    add_hidden(covers[i], 1, std::span<const Cover>(covers.data(), covers.size()).subspan(i + 1), hidden);
  }
  if (hidden.area <= 0) return view;
  const double visible = std::numbers::pi - hidden.area;
  view.share = std::clamp(visible / std::numbers::pi, 0.0, 1.0);
  constexpr double least = 1e-6;  // of the disc; less has no middle, only rounding
  if (view.share > least) {
    const Vector2d middle = -hidden.moment / visible * plane->disc_radius;
    view.center = ball + middle.x() * plane->right + middle.y() * plane->up;
  }
  return view;
}

}  // namespace vision
