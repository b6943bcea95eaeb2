#include "sim/physics/bullet_world.h"

#include <array>
#include <cstddef>

namespace physics {

void BulletWorld::step(float duration) {
  foresee(duration);
  getDispatchInfo().m_timeStep = duration;
  getDispatchInfo().m_stepCount = 0;
  performDiscreteCollisionDetection();
  const int contacts = mark_touched();
  getSolverInfo().m_timeStep = duration;
  if (contacts == 1) {
    solve(first_);
  } else if (contacts > 1) {
    calculateSimulationIslands();  // they decide the order in which the solver takes them
    solveConstraints(getSolverInfo());
  }
  move(duration);
}

// The pose after the step if nothing touches; the broadphase's boxes span it too.
void BulletWorld::foresee(float duration) {
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    btRigidBody& body = *m_nonStaticRigidBodies[i];
    // The solver adds the impulse of all forces, which is null, to every body: -0 becomes +0.
    body.setLinearVelocity(body.getLinearVelocity() + btVector3(0, 0, 0));
    body.setAngularVelocity(body.getAngularVelocity() + btVector3(0, 0, 0));
    body.predictIntegratedTransform(duration, body.getInterpolationWorldTransform());
  }
}

void BulletWorld::solve(btPersistentManifold* contact) {
  std::array<btCollisionObject*, 2> moved{};
  int count = 0;
  for (const btCollisionObject* object : {contact->getBody0(), contact->getBody1()}) {
    if (!object->isStaticObject())
      moved[static_cast<std::size_t>(count++)] = const_cast<btCollisionObject*>(object);
  }
  getConstraintSolver()->solveGroup(moved.data(), count, &contact, 1, nullptr, 0, getSolverInfo(), nullptr,
                                    getDispatcher());
}

// Returns how many pairs touch.
int BulletWorld::mark_touched() {
  touched_.assign(static_cast<std::size_t>(getNumCollisionObjects()), 0);
  int count = 0;
  for (int i = 0; i < getDispatcher()->getNumManifolds(); ++i) {
    btPersistentManifold& manifold = *getDispatcher()->getManifoldByIndexInternal(i);
    if (manifold.getNumContacts() == 0) continue;
    for (const btCollisionObject* object : {manifold.getBody0(), manifold.getBody1()}) {
      touched_[static_cast<std::size_t>(object->getWorldArrayIndex())] = 1;
    }
    if (++count == 1) first_ = &manifold;
  }
  return count;
}

void BulletWorld::move(float duration) {
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    btRigidBody& body = *m_nonStaticRigidBodies[i];
    btTransform pose = body.getInterpolationWorldTransform();
    if (touched_[static_cast<std::size_t>(body.getWorldArrayIndex())] != 0) {
      body.predictIntegratedTransform(duration, pose);
    }
    body.proceedToTransform(pose);
  }
}

}  // namespace physics
