#pragma once

// Inside this folder only, as bullet_scene.h: shows Bullet's types.

#include <btBulletDynamicsCommon.h>

namespace physics {

/// Bullet's dispatcher that leaves out pairs of upright bodies which circles round them show to be apart.
///
/// The broadphase works with boxes: many pairs of round bodies whose boxes meet are clearly apart. A pair is
/// left out only when it has no contact points and was looked at before, so that Bullet's lists keep the
/// order they would have otherwise: nothing else changes, to the bit.
class Dispatcher final : public btCollisionDispatcher {
 public:
  explicit Dispatcher(btCollisionConfiguration* configuration);

  /// Tells that nothing of an upright body is farther from its axis than `radius` [m]; bodies without are
  /// always looked at.
  static void set_reach(btCollisionObject& body, const float& radius);

 private:
  static void look_at(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                      const btDispatcherInfo& info);
  bool apart(btBroadphasePair& pair);

  btManifoldArray manifolds_;  // scratch
};

}  // namespace physics
