#pragma once

// Inside this folder only, as bullet_scene.h: shows Bullet's types.

#include <btBulletDynamicsCommon.h>

#include <vector>

namespace physics {

/// Bullet's discrete world without the work that changes nothing here: the same bits, fewer instructions.
///
/// Bullet's own step integrates each body's pose three times: to foresee it, to look for continuous contacts
/// (we have none) and to move it. Here a body that nothing touches is moved to the pose that was foreseen.
/// Islands and solver run only while something touches. Damping, gravity, forces, sleeping, motion states and
/// profiling are left away: all of them are switched off or null in our scene.
///
/// Source  Bullet 3.24, btDiscreteDynamicsWorld: the order of a step is its own. `BulletWorld` tests compare
///         the two to the bit.
class BulletWorld final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  /// Advances by `duration` [s].
  /// @pre no kinematic bodies, no constraints, no forces, no continuous collision detection
  void step(float duration);

 private:
  void foresee(float duration);
  bool mark_touched();
  void move(float duration);

  std::vector<char> touched_;  // by index in the world's array of objects
};

}  // namespace physics
