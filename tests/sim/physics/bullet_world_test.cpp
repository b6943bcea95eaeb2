// Second method: Bullet's own step, which our shorter one must follow to the bit.

#include "sim/physics/bullet_world.h"

#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "sim/physics/dispatcher.h"
#include "sim/world/random.h"

namespace physics {
namespace {

constexpr float substep = 1.0F / 240;
constexpr float hull_radius = 0.09F + 0.04F, ball_radius = 0.0215F;  // [m] the hull's with Bullet's margin

// Eight flat hulls in a pen with a ball among them, driven anew every quarter of a second: they meet each
// other, the ball and the walls all the time, and part again.
template <class World, class Dispatch>
class Pen {
 public:
  Pen() : dispatcher_(&configuration_), broadphase_({-3, -3, -1}, {3, 3, 3}, 64, nullptr, true) {
    world_ = std::make_unique<World>(&dispatcher_, &broadphase_, &solver_, &configuration_);
    world_->setGravity({0, 0, 0});
    world_->setForceUpdateAllAabbs(false);
    for (int i = 0; i < 12; ++i) {
      hull_.addPoint({0.09F * std::cos(0.5F * static_cast<float>(i)),
                      0.09F * std::sin(0.5F * static_cast<float>(i)), i % 2 == 0 ? 0.07F : -0.07F},
                     i == 11);
    }
    for (const float x : {-1.0F, 1.0F}) add(wall_, 0, {x, 0, 0}, 1, -1);
    add(ball_, 0.046F, {0, 0, 0.0215F}, 2, -1);
    for (int i = 0; i < 8; ++i) {
      btRigidBody& robot = add(
          hull_, 2.5F,
          {0.3F * static_cast<float>(i % 4) - 0.45F, 0.4F * static_cast<float>(i / 4) - 0.2F, 0.075F}, 4, -1);
      robot.setLinearFactor({1, 1, 0});
      robot.setAngularFactor(btVector3(0, 0, 1));
    }
  }
  ~Pen() {
    for (const auto& body : bodies_) world_->removeRigidBody(body.get());
  }
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  void drive(world::RandomStream& random) {
    for (const auto& body : bodies_) {
      if (body->isStaticObject()) continue;
      const auto some = [&] { return static_cast<float>(4 * random.uniform() - 2); };
      const btVector3 home = body->getWorldTransform().getOrigin() * -1.0F;
      const bool lies = random.uniform() < 0.2;  // some rest, at -0
      body->setLinearVelocity(lies ? btVector3(-0.0F, 0, 0)
                                   : btVector3(home.x() + some(), home.y() + some(), 0));
      body->setAngularVelocity({0, 0, lies ? -0.0F : some()});
    }
  }

  // All that a caller can read, as bits.
  std::vector<float> state() const {
    std::vector<float> all;
    for (const auto& body : bodies_) {
      const btTransform& pose = body->getWorldTransform();
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) all.push_back(pose.getBasis()[row][column]);
        all.push_back(pose.getOrigin()[row]);
        all.push_back(body->getLinearVelocity()[row]);
        all.push_back(body->getAngularVelocity()[row]);
      }
    }
    return all;
  }

  int touching() const {
    int points = 0;
    for (int i = 0; i < const_cast<Dispatch&>(dispatcher_).getNumManifolds(); ++i) {
      points += const_cast<Dispatch&>(dispatcher_).getManifoldByIndexInternal(i)->getNumContacts();
    }
    return points;
  }

  World& world() { return *world_; }

 private:
  btRigidBody& add(btCollisionShape& shape, float mass, const btVector3& place, int group, int mask) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_restitution = 0.6F;
    info.m_startWorldTransform.setOrigin(place);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setFlags(0);
    if (mass > 0) bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    if (mass > 0) Dispatcher::set_reach(*bodies_.back(), mass > 1 ? hull_radius : ball_radius);
    world_->addRigidBody(bodies_.back().get(), group, mask);
    return *bodies_.back();
  }

  btDefaultCollisionConfiguration configuration_;
  Dispatch dispatcher_;
  btAxisSweep3 broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btConvexHullShape hull_;
  btSphereShape ball_{0.0215F};
  btBoxShape wall_{btVector3(0.1F, 2, 1)};
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::unique_ptr<World> world_;
};

void step(BulletWorld& world) { world.step(substep); }
void step(btDiscreteDynamicsWorld& world) { world.stepSimulation(substep, 0); }

// Both ways through a step must be taken often.
template <class Ours>
void expect_bullets_bits(Ours& ours) {
  Pen<btDiscreteDynamicsWorld, btCollisionDispatcher> bullets;
  world::RandomStream random_ours(1, "pen"), random_bullets(1, "pen");
  int steps_with_touch = 0, steps_without = 0;
  for (int n = 0; n < 6000; ++n) {
    if (n % 60 == 0) {
      ours.drive(random_ours);
      bullets.drive(random_bullets);
    }
    physics::step(ours.world());
    physics::step(bullets.world());
    const std::vector<float> a = ours.state(), b = bullets.state();
    ASSERT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0) << "step " << n;
    (ours.touching() > 0 ? steps_with_touch : steps_without) += 1;
  }
  EXPECT_GT(steps_with_touch, 500);
  EXPECT_GT(steps_without, 500);
}

TEST(BulletWorld, StepsAsBulletsOwnWorldToTheBit) {
  Pen<BulletWorld, btCollisionDispatcher> ours;
  expect_bullets_bits(ours);
}

TEST(Dispatcher, LeavesOutOnlyPairsThatDoNotMatter) {
  Pen<btDiscreteDynamicsWorld, Dispatcher> ours;
  expect_bullets_bits(ours);
}

}  // namespace
}  // namespace physics
