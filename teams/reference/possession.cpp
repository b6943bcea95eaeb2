#include "teams/reference/possession.h"

namespace reference {
namespace {

constexpr double near_gap = 0.04;   // [m]
constexpr double near_for = 0.1;    // [s]
constexpr double far_gap = 0.08;    // [m]
constexpr double lost_after = 1.5;  // [s]
constexpr double too_high = 0.12;   // [m]

Possession of(bool ours, bool theirs) {
  if (ours && theirs) return Possession::Contested;
  if (ours) return Possession::Ours;
  return theirs ? Possession::Theirs : Possession::None;
}

}  // namespace

const char* name(Possession possession) {
  switch (possession) {
    case Possession::None:
      return "none";
    case Possession::Ours:
      return "ours";
    case Possession::Theirs:
      return "theirs";
    case Possession::Contested:
      return "contested";
  }
  return "unknown";
}

void PossessionTracker::watch(const kit::View& view, const std::vector<kit::Robot>& robots,
                              Side& side) const {
  bool near = false;
  if (view.ball.known && view.ball.height < too_high) {
    for (const kit::Robot& robot : robots) {
      const double gap =
          (robot.position - view.ball.position).norm() - robot.specs.radius - view.field().ball_radius;
      near = near || gap < near_gap;
      if (gap < far_gap) side.last_near = view.time;
    }
  }
  if (!near) {
    side.near_since = -1;
  } else if (side.near_since < 0) {
    side.near_since = view.time;
  }
  side.has = side.near_since >= 0 && view.time - side.near_since >= near_for - 1e-9;
}

Possession PossessionTracker::update(const kit::View& view) {
  const bool we_had = ours_.has, they_had = theirs_.has;
  Side ours = ours_, theirs = theirs_;
  watch(view, view.own, ours);
  watch(view, view.opponents, theirs);
  at_ball_ = of(ours.has, theirs.has);
  // Who had it keeps it for a while, unless the others have it now.
  ours.has = ours.has || (we_had && !theirs.has && view.time - ours.last_near < lost_after);
  theirs.has =
      theirs.has || (they_had && at_ball_ != Possession::Ours && view.time - theirs.last_near < lost_after);
  ours_ = ours;
  theirs_ = theirs;
  return of(ours.has, theirs.has);
}

}  // namespace reference
