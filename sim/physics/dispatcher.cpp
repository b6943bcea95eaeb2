#include "sim/physics/dispatcher.h"

namespace physics {
namespace {

// Bullet makes contact points up to 2 % of a body's size before they touch,
// margins included: 3 mm here. Ours.
constexpr float room = 0.01F;  // [m]

const btCollisionObject& object(const btBroadphaseProxy* proxy) {
  return *static_cast<const btCollisionObject*>(proxy->m_clientObject);
}

}  // namespace

Dispatcher::Dispatcher(btCollisionConfiguration* configuration) : btCollisionDispatcher(configuration) {
  manifolds_.reserve(4);
  setNearCallback(look_at);
}

// The pointer is never written through.
void Dispatcher::set_reach(btCollisionObject& body, const float& radius) {
  body.setUserPointer(const_cast<float*>(&radius));
}

void Dispatcher::look_at(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                         const btDispatcherInfo& info) {
  if (!static_cast<Dispatcher&>(dispatcher).apart(pair)) defaultNearCallback(pair, dispatcher, info);
}

bool Dispatcher::apart(btBroadphasePair& pair) {
  if (pair.m_algorithm == nullptr) return false;
  const btCollisionObject& a = object(pair.m_pProxy0);
  const btCollisionObject& b = object(pair.m_pProxy1);
  const auto* reach_a = static_cast<const float*>(a.getUserPointer());
  const auto* reach_b = static_cast<const float*>(b.getUserPointer());
  if (reach_a == nullptr || reach_b == nullptr) return false;
  const btVector3 way = a.getWorldTransform().getOrigin() - b.getWorldTransform().getOrigin();
  const float least = *reach_a + *reach_b + room;
  if (way.x() * way.x() + way.y() * way.y() < least * least) return false;
  manifolds_.resize(0);
  pair.m_algorithm->getAllContactManifolds(manifolds_);
  for (int i = 0; i < manifolds_.size(); ++i) {
    if (manifolds_[i]->getNumContacts() > 0) return false;
  }
  return true;
}

}  // namespace physics
