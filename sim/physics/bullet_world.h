#pragma once

// Inside this folder only, as bullet_scene.h: shows Bullet's types.

#include <btBulletDynamicsCommon.h>

#include <vector>

namespace physics {

/// Bullet's discrete world without the work that changes nothing here: the same bits, fewer instructions.
///
/// Bullet's own step integrates each body's pose three times: to foresee it, to look for continuous contacts
/// (we have none) and to move it. Here a body that nothing touches is moved to the pose that was foreseen.
/// The solver runs only while something touches, and over two bodies alone when no others do; islands are
/// sought only when there is more than one contact. Damping, gravity, forces, sleeping, motion states and
/// profiling are left out: all of them are switched off or null in our scene.
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
  int mark_touched();
  void solve(btPersistentManifold* contact);
  void move(float duration);

  std::vector<char> touched_;              // by index in the world's array of objects
  btPersistentManifold* first_ = nullptr;  // that touches
};

}  // namespace physics
