#include "sim/physics/bullet_world.h"

#include <cstddef>

namespace physics {

void BulletWorld::step(float duration) {
  foresee(duration);
  getDispatchInfo().m_timeStep = duration;
  getDispatchInfo().m_stepCount = 0;
  performDiscreteCollisionDetection();
  if (mark_touched()) {
    calculateSimulationIslands();
    getSolverInfo().m_timeStep = duration;
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

bool BulletWorld::mark_touched() {
  touched_.assign(static_cast<std::size_t>(getNumCollisionObjects()), 0);
  bool any = false;
  for (int i = 0; i < getDispatcher()->getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *getDispatcher()->getManifoldByIndexInternal(i);
    if (manifold.getNumContacts() == 0) continue;
    for (const btCollisionObject* object : {manifold.getBody0(), manifold.getBody1()}) {
      touched_[static_cast<std::size_t>(object->getWorldArrayIndex())] = 1;
    }
    any = true;
  }
  return any;
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
