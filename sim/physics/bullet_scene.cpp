#include "sim/physics/bullet_scene.h"

#include <cmath>

#include "sim/physics/hull.h"
#include "sim/physics/prism_shape.h"

namespace physics {
namespace {

using world::Vector2d;
using world::Vector3d;

// Collision groups: fixtures never meet each other.
constexpr int fixture_group = 1, ball_group = 2, robot_group = 4;

// User indices of bodies that are not robots.
constexpr int ball_index = -2, fixture_index = -3;

float f(double value) { return static_cast<float>(value); }
btVector3 bt(const Vector3d& v) { return {f(v.x()), f(v.y()), f(v.z())}; }
Vector3d eigen(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

// Pools for some hundred contact pairs; Bullet's default of 4096 would be 4 MB for nothing.
btDefaultCollisionConstructionInfo pools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 512;
  info.m_defaultMaxCollisionAlgorithmPoolSize = 512;
  return info;
}

// 32 robots, the ball, 12 fixtures, and room to spare.
constexpr unsigned short most_bodies = 128;

// Bounds of the axis sweep: the walls and a little more.
btVector3 bound(const world::Field& field, double s) {
  const double margin = field.boundary_width + 0.5;
  return bt({s * (field.half_length() + margin), s * (field.half_width() + margin), s > 0 ? 3.5 : -0.5});
}

// Bullet multiplies the two bodies' numbers, so one number each is chosen to give the wanted products.
struct Material {
  double restitution, friction;
};
Material robot_material(const ContactParams& c) {
  return {std::sqrt(c.robot_robot_restitution), std::sqrt(c.robot_robot_friction)};
}
Material ball_material(const ContactParams& c) {
  const Material robot = robot_material(c);
  return {c.ball_robot_restitution / robot.restitution, c.ball_robot_friction / robot.friction};
}
Material fixture_material(const ContactParams& c, Fixture::Kind kind) {
  const Material ball = ball_material(c);
  switch (kind) {
    case Fixture::Kind::Wall:
      return {c.ball_wall_restitution / ball.restitution, c.ball_wall_friction / ball.friction};
    case Fixture::Kind::GoalBack:
      return {c.ball_goal_back_restitution / ball.restitution, c.ball_goal_friction / ball.friction};
    case Fixture::Kind::GoalSide:
    case Fixture::Kind::GoalRoof:
      break;
  }
  return {c.ball_goal_side_restitution / ball.restitution, c.ball_goal_friction / ball.friction};
}

BodyPose exact(const btTransform& transform) {
  BodyPose pose;
  for (int row = 0; row < 3; ++row) {
    pose.origin[static_cast<std::size_t>(row)] = transform.getOrigin()[row];
    for (int column = 0; column < 3; ++column) {
      pose.basis[static_cast<std::size_t>(3 * row + column)] = transform.getBasis()[row][column];
    }
  }
  return pose;
}
btTransform exact(const BodyPose& pose) {
  const auto& b = pose.basis;
  return btTransform(btMatrix3x3(b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7], b[8]),
                     btVector3(pose.origin[0], pose.origin[1], pose.origin[2]));
}

btTransform pose(const Vector2d& position, double height, double orientation) {
  btTransform transform;
  transform.setOrigin(bt({position.x(), position.y(), height}));
  // From the angle itself: half of it as a float would turn a heading of pi by 9e-8.
  const float c = f(std::cos(orientation)), s = f(std::sin(orientation));
  transform.setBasis(btMatrix3x3(c, -s, 0, s, c, 0, 0, 0, 1));
  return transform;
}

}  // namespace

BulletScene::BulletScene(const world::Field& field, std::span<const world::RobotSpecs> robots,
                         const Params& params)
    : configuration_(pools()),
      dispatcher_(&configuration_),
      broadphase_(bound(field, -1), bound(field, 1), most_bodies, nullptr, true),  // no accelerator for rays
      world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
  world_.setGravity(btVector3(0, 0, 0));
  world_.setForceUpdateAllAabbs(false);
  btContactSolverInfo& info = world_.getSolverInfo();
  info.m_numIterations = params.solver.iterations;
  info.m_splitImpulsePenetrationThreshold = f(params.solver.split_impulse_threshold);

  for (const Fixture& fixture : fixtures(field)) {
    const Vector3d half = (fixture.max - fixture.min) / 2;
    shapes_.push_back(std::make_unique<btBoxShape>(bt(half)));
    const Material material = fixture_material(params.contact, fixture.kind);
    btRigidBody& body = add_body(0, {0, 0, 0}, *shapes_.back(), material.restitution, material.friction);
    body.setCenterOfMassTransform(
        btTransform(btQuaternion::getIdentity(), bt((fixture.max + fixture.min) / 2)));
    body.setUserIndex(fixture_index);
    world_.addRigidBody(&body, fixture_group, ball_group | robot_group);
  }

  const BallParams& ball = params.ball;
  const double ball_inertia = 0.4 * ball.mass * ball.radius * ball.radius;  // solid sphere
  shapes_.push_back(std::make_unique<btSphereShape>(f(ball.radius)));
  const Material of_ball = ball_material(params.contact);
  ball_restitution_ = f(of_ball.restitution);
  ball_dribbler_restitution_ =
      f(params.contact.ball_dribbler_restitution / robot_material(params.contact).restitution);
  ball_ = &add_body(ball.mass, bt(Vector3d::Constant(ball_inertia)), *shapes_.back(), of_ball.restitution,
                    of_ball.friction);
  ball_->setUserIndex(ball_index);
  reach_.reserve(robots.size() + 1);  // the bodies keep pointers
  reach_.push_back(f(ball.radius));
  Dispatcher::set_reach(*ball_, reach_.back());
  ball_->setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, f(ball.radius))));
  world_.addRigidBody(ball_, ball_group, fixture_group | robot_group);

  for (const world::RobotSpecs& specs : robots) {
    const double margin = params.solver.hull_margin;
    auto shape = std::make_unique<PrismShape>(hull_corners(specs, params.solver.hull_segments, margin),
                                              specs.height / 2 - margin);
    shape->setMargin(f(margin));
    shape->recalcLocalAabb();
    const double inertia = 0.5 * specs.mass * specs.radius * specs.radius;  // solid cylinder
    const Material material = robot_material(params.contact);
    btRigidBody& body = add_body(specs.mass, bt(Vector3d::Constant(inertia)), *shape, material.restitution,
                                 material.friction);
    body.setLinearFactor({1, 1, 0});
    body.setAngularFactor(btVector3(0, 0, 1));
    body.setUserIndex(static_cast<int>(robots_.size()));
    reach_.push_back(f(specs.radius));
    Dispatcher::set_reach(body, reach_.back());
    shapes_.push_back(std::move(shape));
    robots_.push_back(&body);
    robot_height_.push_back(specs.height / 2);
  }
}

BulletScene::~BulletScene() {
  for (const auto& body : bodies_) world_.removeRigidBody(body.get());
}

btRigidBody& BulletScene::add_body(double mass, const btVector3& inertia, btCollisionShape& shape,
                                   double restitution, double friction) {
  btRigidBody::btRigidBodyConstructionInfo info(f(mass), nullptr, &shape, inertia);
  info.m_restitution = f(restitution);
  info.m_friction = f(friction);
  bodies_.push_back(std::make_unique<btRigidBody>(info));
  btRigidBody& body = *bodies_.back();
  body.setFlags(0);  // no gyroscopic term: it does nothing for a sphere and a body that turns about z only
  if (mass > 0) body.setActivationState(DISABLE_DEACTIVATION);
  return body;
}

void BulletScene::teleport(btRigidBody& body, const btTransform& pose) {
  body.setCenterOfMassTransform(pose);
  body.setLinearVelocity({0, 0, 0});
  body.setAngularVelocity({0, 0, 0});
  body.setInterpolationLinearVelocity({0, 0, 0});
  body.setInterpolationAngularVelocity({0, 0, 0});
  body.clearForces();
  if (btBroadphaseProxy* proxy = body.getBroadphaseProxy()) {
    broadphase_.getOverlappingPairCache()->cleanProxyFromPairs(proxy, &dispatcher_);
  }
}

void BulletScene::add_robot(std::size_t robot, const Vector2d& position, double orientation) {
  add_robot(robot, pose(position, robot_height_[robot], orientation));
}

void BulletScene::add_robot(std::size_t robot, const BodyPose& pose) { add_robot(robot, exact(pose)); }

void BulletScene::add_robot(std::size_t robot, const btTransform& pose) {
  btRigidBody& body = *robots_[robot];
  teleport(body, pose);
  world_.addRigidBody(&body, robot_group, fixture_group | ball_group | robot_group);
}

void BulletScene::move_robot(std::size_t robot, const Vector2d& position, double orientation) {
  teleport(*robots_[robot], pose(position, robot_height_[robot], orientation));
}

void BulletScene::remove_robot(std::size_t robot) { world_.removeRigidBody(robots_[robot]); }

RobotBody BulletScene::robot(std::size_t robot) const {
  const btRigidBody& body = *robots_[robot];
  const btTransform& transform = body.getWorldTransform();
  const btVector3& origin = transform.getOrigin();
  const btMatrix3x3& basis = transform.getBasis();
  const btVector3& velocity = body.getLinearVelocity();
  return {{origin.x(), origin.y()},
          {basis[0].x(), basis[1].x()},
          {velocity.x(), velocity.y()},
          body.getAngularVelocity().z()};
}

double BulletScene::orientation(std::size_t robot) const {
  const btMatrix3x3& basis = robots_[robot]->getWorldTransform().getBasis();
  return std::atan2(static_cast<double>(basis[1].x()), static_cast<double>(basis[0].x()));
}

BodyPose BulletScene::robot_pose(std::size_t robot) const {
  return exact(robots_[robot]->getWorldTransform());
}
BodyPose BulletScene::ball_pose() const { return exact(ball_->getWorldTransform()); }
void BulletScene::set_ball_pose(const BodyPose& pose) { teleport(*ball_, exact(pose)); }

void BulletScene::set_robot_velocity(std::size_t robot, const Vector2d& velocity, double angular_velocity) {
  btRigidBody& body = *robots_[robot];
  body.setLinearVelocity(bt({velocity.x(), velocity.y(), 0}));
  body.setAngularVelocity({0, 0, f(angular_velocity)});
}

void BulletScene::add_robot_velocity(std::size_t robot, const Vector2d& velocity, double angular_velocity) {
  btRigidBody& body = *robots_[robot];
  body.setLinearVelocity(body.getLinearVelocity() + bt({velocity.x(), velocity.y(), 0}));
  body.setAngularVelocity(body.getAngularVelocity() + btVector3(0, 0, f(angular_velocity)));
}

void BulletScene::move_ball(const Vector3d& position) {
  teleport(*ball_, btTransform(btQuaternion::getIdentity(), bt(position)));
}

void BulletScene::set_ball(const truth::Ball& ball) {
  btTransform transform = ball_->getWorldTransform();
  transform.setOrigin(bt(ball.position));
  ball_->setWorldTransform(transform);
  ball_->setLinearVelocity(bt(ball.velocity));
  ball_->setAngularVelocity(bt(ball.spin));
}

void BulletScene::read_ball(truth::Ball& ball) const {
  ball.position = eigen(ball_->getWorldTransform().getOrigin());
  ball.velocity = eigen(ball_->getLinearVelocity());
  ball.spin = eigen(ball_->getAngularVelocity());
}

void BulletScene::set_ball_restitution(bool at_dribbler) {
  ball_->setRestitution(at_dribbler ? ball_dribbler_restitution_ : ball_restitution_);
}

void BulletScene::step(double duration, std::vector<BallContact>& ball_contacts) {
  world_.step(f(duration));
  read_contacts(ball_contacts);
}

void BulletScene::read_contacts(std::vector<BallContact>& contacts) const {
  contacts.clear();
  const int count = dispatcher_.getNumManifolds();
  btPersistentManifold* const* manifolds = const_cast<Dispatcher&>(dispatcher_).getInternalManifoldPointer();
  for (int i = 0; i < count; ++i) {
    const btPersistentManifold& manifold = *manifolds[i];
    const int points = manifold.getNumContacts();
    if (points == 0) continue;
    const bool first = manifold.getBody0() == ball_;
    if (!first && manifold.getBody1() != ball_) continue;
    const btCollisionObject* other = first ? manifold.getBody1() : manifold.getBody0();

    BallContact contact;
    contact.robot = other->getUserIndex() >= 0 ? other->getUserIndex() : BallContact::with_fixture;
    for (int p = 0; p < points; ++p) {
      const btManifoldPoint& point = manifold.getContactPoint(p);
      if (point.getAppliedImpulse() <= 0) continue;
      contact.impulse += point.getAppliedImpulse();
      const float up = point.m_normalWorldOnB.z() * (first ? 1.0F : -1.0F);  // the normal points at body 0
      contact.from_above = contact.from_above || up > 0.7F;
    }
    if (contact.impulse > 0) contacts.push_back(contact);
  }
}

}  // namespace physics
