// Frozen: see the header. Written for clarity once, never to be optimised or shared.
#include "sim/physics/reference_scene.h"

#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

namespace physics {
namespace {

constexpr int robot_count = 12;
constexpr int team_size = 6;
constexpr float step_length = 1.0F / 240;
constexpr double ball_radius = 0.0215;
constexpr double pi = std::numbers::pi;

enum Group { fixtures = 1, balls = 2, robots = 4 };

class ReferenceScene {
 public:
  ReferenceScene()
      : dispatcher_(&configuration_),
        broadphase_(btVector3(-6, -4, -1), btVector3(6, 4, 4), 256, nullptr, true),  // no ray accelerator
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.setGravity(btVector3(0, 0, 0));
    world_.getSolverInfo().m_numIterations = 10;
    world_.getSolverInfo().m_splitImpulsePenetrationThreshold = -0.0005F;
    add_walls_and_goals();
    add_ball();
    for (int i = 0; i < robot_count; ++i) add_robot(i);
  }
  ~ReferenceScene() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  ReferenceScene(const ReferenceScene&) = delete;
  ReferenceScene& operator=(const ReferenceScene&) = delete;

  void tick() {
    decide();
    for (int substep = 0; substep < 4; ++substep) {
      for (int i = 0; i < robot_count; ++i) servo(i);
      step_ball_before();
      world_.stepSimulation(step_length, 0);
      step_ball_after();
    }
    add_to_hash();
    ++ticks_;
  }

  ReferenceResult result() const { return {hash_, ticks_}; }

 private:
  struct Robot {
    btRigidBody* body = nullptr;
    double target_x = 0, target_y = 0;             // [m]
    double wish_x = 0, wish_y = 0, wish_turn = 0;  // [m/s], field frame, and [rad/s]
    int until_new_target = 0;                      // ticks
    int until_kick = 0;                            // ticks
  };

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1.0p-53;
  }

  btRigidBody& add_body(float mass, const btVector3& inertia, btCollisionShape& shape, float restitution,
                        float friction, const btVector3& position) {
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_restitution = restitution;
    info.m_friction = friction;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    body.setFlags(0);
    body.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), position));
    if (mass > 0) body.setActivationState(DISABLE_DEACTIVATION);
    return body;
  }

  void add_box(const btVector3& center, const btVector3& half, float restitution) {
    shapes_.push_back(std::make_unique<btBoxShape>(half));
    world_.addRigidBody(&add_body(0, {0, 0, 0}, *shapes_.back(), restitution, 0.5F, center), fixtures,
                        balls | robots);
  }

  void add_walls_and_goals() {
    for (const float s : {-1.0F, 1.0F}) {
      add_box({s * 4.9F, 0, 1.5F}, {0.1F, 3.5F, 1.5F}, 0.3F);
      add_box({0, s * 3.4F, 1.5F}, {5.0F, 0.1F, 1.5F}, 0.3F);
      add_box({s * 4.69F, 0, 0.08F}, {0.01F, 0.52F, 0.08F}, 0.1F);
      for (const float t : {-1.0F, 1.0F}) add_box({s * 4.59F, t * 0.51F, 0.08F}, {0.09F, 0.01F, 0.08F}, 0.3F);
    }
  }

  void add_ball() {
    shapes_.push_back(std::make_unique<btSphereShape>(static_cast<float>(ball_radius)));
    const float inertia = static_cast<float>(0.4 * 0.046 * ball_radius * ball_radius);
    ball_ = &add_body(0.046F, {inertia, inertia, inertia}, *shapes_.back(), 1, 1,
                      {0, 0, static_cast<float>(ball_radius)});
    world_.addRigidBody(ball_, balls, fixtures | robots);
  }

  void add_robot(int index) {
    const double margin = 0.001, radius = 0.09 - margin, front = 0.073 - margin, half_height = 0.075 - margin;
    const double edge = std::acos(front / radius);
    auto shape = std::make_unique<btConvexHullShape>();
    for (int i = 0; i <= 16; ++i) {
      const double angle = edge + 2 * (pi - edge) * i / 16;
      for (const double s : {-1.0, 1.0}) {
        shape->addPoint({static_cast<float>(radius * std::cos(angle)),
                         static_cast<float>(radius * std::sin(angle)), static_cast<float>(s * half_height)},
                        false);
      }
    }
    shape->setMargin(static_cast<float>(margin));
    shape->recalcLocalAabb();
    const bool blue = index >= team_size;
    const int place = index % team_size;
    const float x = blue ? 1.0F + static_cast<float>(place % 3) : -1.0F - static_cast<float>(place % 3);
    const float y = place < 3 ? 1.0F : -1.0F;
    const float inertia = 0.5F * 2.5F * 0.09F * 0.09F;
    Robot& robot = robots_[static_cast<std::size_t>(index)];
    robot.body = &add_body(2.5F, {inertia, inertia, inertia}, *shape, 0.6F, 0.22F, {x, y, 0.075F});
    robot.body->setLinearFactor({1, 1, 0});
    robot.body->setAngularFactor(btVector3(0, 0, 1));
    world_.addRigidBody(robot.body, robots, fixtures | balls | robots);
    shapes_.push_back(std::move(shape));
  }

  static double heading(const Robot& robot) {
    const btMatrix3x3& basis = robot.body->getWorldTransform().getBasis();
    return std::atan2(static_cast<double>(basis[1].x()), static_cast<double>(basis[0].x()));
  }

  int chaser(int first) const {
    const btVector3& ball = ball_->getWorldTransform().getOrigin();
    int best = first;
    float best_distance = 1e9F;
    for (int i = first; i < first + team_size; ++i) {
      const btVector3& place = robots_[static_cast<std::size_t>(i)].body->getWorldTransform().getOrigin();
      const float distance = (place - ball).length2();
      if (distance < best_distance) {
        best_distance = distance;
        best = i;
      }
    }
    return best;
  }

  // One chaser of each team drives at the ball and kicks it; the others drive to random
  // targets, facing the ball.
  void decide() {
    const btVector3 ball = ball_->getWorldTransform().getOrigin();
    for (int i = 0; i < robot_count; ++i) {
      Robot& robot = robots_[static_cast<std::size_t>(i)];
      const btVector3& place = robot.body->getWorldTransform().getOrigin();
      const double x = place.x(), y = place.y();
      double aim = 0;
      if (i == chaser(i < team_size ? 0 : team_size)) {
        aim = std::atan2(ball.y() - y, ball.x() - x);
        robot.target_x = ball.x();
        robot.target_y = ball.y();
        robot.until_new_target = 0;
        try_kick(robot);
      } else {
        if (--robot.until_new_target < 0) {
          robot.target_x = uniform(-4.4, 4.4);
          robot.target_y = uniform(-2.9, 2.9);
          robot.until_new_target = 60 + static_cast<int>(uniform(0, 120));
        }
        aim = std::atan2(ball.y() - y, ball.x() - x);
      }
      robot.until_kick = std::max(robot.until_kick - 1, 0);
      const double dx = robot.target_x - x, dy = robot.target_y - y;
      const double distance = std::sqrt(dx * dx + dy * dy);
      const double speed = std::min(4.0 * distance, 3.0);
      robot.wish_x = distance > 0 ? dx / distance * speed : 0;
      robot.wish_y = distance > 0 ? dy / distance * speed : 0;
      robot.wish_turn = std::clamp(8 * std::remainder(aim - heading(robot), 2 * pi), -10.0, 10.0);
    }
    rescue_ball();
  }

  void try_kick(Robot& robot) {
    if (robot.until_kick > 0) return;
    const btVector3 local = robot.body->getWorldTransform().invXform(ball_->getWorldTransform().getOrigin());
    if (local.x() > 0.073F + 0.0215F + 0.01F || local.x() < 0.073F || std::abs(local.y()) > 0.035F) return;
    if (ball_->getWorldTransform().getOrigin().z() > 0.05F) return;
    const double speed = uniform(2, 8);
    const double elevation = uniform(0, 1) < 0.15 ? pi / 4 : 0;
    const double angle = heading(robot);
    ball_->setLinearVelocity({static_cast<float>(speed * std::cos(elevation) * std::cos(angle)),
                              static_cast<float>(speed * std::cos(elevation) * std::sin(angle)),
                              static_cast<float>(speed * std::sin(elevation))});
    ball_->setAngularVelocity({0, 0, 0});
    robot.until_kick = 6;
  }

  // A ball that lies still or in a goal for 3 s, comes back to a random place.
  void rescue_ball() {
    const btVector3& ball = ball_->getWorldTransform().getOrigin();
    still_ = ball_->getLinearVelocity().length() < 0.05F || std::abs(ball.x()) > 4.52F ? still_ + 1 : 0;
    if (still_ < 180) return;
    still_ = 0;
    ball_->setCenterOfMassTransform(btTransform(
        btQuaternion::getIdentity(), {static_cast<float>(uniform(-3, 3)), static_cast<float>(uniform(-2, 2)),
                                      static_cast<float>(ball_radius)}));
    ball_->setLinearVelocity({0, 0, 0});
    ball_->setAngularVelocity({0, 0, 0});
  }

  static void servo(Robot& robot) {
    const btVector3& velocity = robot.body->getLinearVelocity();
    double dx = robot.wish_x - velocity.x(), dy = robot.wish_y - velocity.y();
    const double size = std::sqrt(dx * dx + dy * dy), limit = 4.0 * step_length;
    if (size > limit) {
      dx *= limit / size;
      dy *= limit / size;
    }
    robot.body->setLinearVelocity(
        {static_cast<float>(velocity.x() + dx), static_cast<float>(velocity.y() + dy), 0});
    const double turn = robot.body->getAngularVelocity().z(), turn_limit = 50.0 * step_length;
    robot.body->setAngularVelocity(
        {0, 0, static_cast<float>(turn + std::clamp(robot.wish_turn - turn, -turn_limit, turn_limit))});
  }
  void servo(int index) { servo(robots_[static_cast<std::size_t>(index)]); }

  bool ball_on_ground() const {
    return ball_->getWorldTransform().getOrigin().z() < static_cast<float>(ball_radius) + 1e-4F &&
           std::abs(ball_->getLinearVelocity().z()) < 0.02F;
  }

  // Slides at 3 m/s^2 until it rolls, then rolls at 0.26 m/s^2; in the air it falls.
  void step_ball_before() {
    btVector3 v = ball_->getLinearVelocity(), w = ball_->getAngularVelocity();
    const float radius = static_cast<float>(ball_radius);
    if (!ball_on_ground()) {
      ball_->setLinearVelocity({v.x(), v.y(), v.z() - 9.81F * step_length});
      return;
    }
    const btVector3 slip(v.x() - radius * w.y(), v.y() + radius * w.x(), 0);
    const float slip_size = slip.length();
    if (slip_size > 3.5F * 3.0F * step_length) {
      const btVector3 change = slip * (-3.0F * step_length / slip_size);
      v += change;
      w += btVector3(change.y(), -change.x(), 0) * (2.5F / radius);
    } else {
      const float speed = v.length();
      v *= speed > 0.26F * step_length ? 1 - 0.26F * step_length / speed : 0.0F;
      w = btVector3(-v.y() / radius, v.x() / radius, 0);
    }
    ball_->setLinearVelocity({v.x(), v.y(), 0});
    ball_->setAngularVelocity(w);
  }

  void step_ball_after() {
    btTransform pose = ball_->getWorldTransform();
    const float radius = static_cast<float>(ball_radius);
    if (pose.getOrigin().z() > radius) return;
    pose.getOrigin().setZ(radius);
    ball_->setWorldTransform(pose);
    const btVector3 v = ball_->getLinearVelocity();
    if (v.z() >= 0) return;
    const float rise = v.z() < -0.9F ? -0.5F * v.z() : 0.0F;
    const float keep = rise > 0 ? 0.75F : 1.0F;
    ball_->setLinearVelocity({keep * v.x(), keep * v.y(), rise});
  }

  void add_to_hash(float value) {
    std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    for (int i = 0; i < 4; ++i) {
      hash_ = (hash_ ^ (bits & 0xFFU)) * 0x100000001b3U;
      bits >>= 8;
    }
  }
  void add_to_hash(const btRigidBody& body) {
    const btVector3& place = body.getWorldTransform().getOrigin();
    const btVector3& velocity = body.getLinearVelocity();
    for (const float value : {place.x(), place.y(), place.z(), velocity.x(), velocity.y(), velocity.z()}) {
      add_to_hash(value);
    }
    add_to_hash(body.getWorldTransform().getBasis()[0].x());
    add_to_hash(body.getAngularVelocity().z());
  }
  void add_to_hash() {
    add_to_hash(*ball_);
    for (const Robot& robot : robots_) add_to_hash(*robot.body);
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btAxisSweep3 broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  btRigidBody* ball_ = nullptr;
  std::array<Robot, robot_count> robots_;
  std::mt19937_64 random_{1};
  int still_ = 0;  // ticks
  std::uint64_t hash_ = 0xcbf29ce484222325U;
  std::int64_t ticks_ = 0;
};

}  // namespace

ReferenceResult run_reference_scene(double seconds) {
  ReferenceScene scene;
  const std::int64_t ticks = std::llround(seconds * 60);
  for (std::int64_t i = 0; i < ticks; ++i) scene.tick();
  return scene.result();
}

}  // namespace physics
