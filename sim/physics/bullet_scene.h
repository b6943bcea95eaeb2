#pragma once

// Inside this folder only: the one header that shows Bullet's types.

#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <span>
#include <vector>

#include "sim/physics/bullet_world.h"
#include "sim/physics/dispatcher.h"
#include "sim/physics/fixtures.h"
#include "sim/physics/params.h"
#include "sim/physics/state.h"
#include "sim/truth/truth.h"
#include "sim/world/robot_specs.h"

namespace physics {

/// A robot's pose and motion in the plane.
struct RobotBody {
  world::Vector2d position = world::Vector2d::Zero();  ///< [m]
  world::Vector2d forward = world::Vector2d::UnitX();  ///< unit vector of the heading
  world::Vector2d velocity = world::Vector2d::Zero();  ///< [m/s]
  double angular_velocity = 0;                         ///< [rad/s]
};

/// One contact of the ball in the last step.
struct BallContact {
  static constexpr int with_fixture = -1;
  int robot = with_fixture;  ///< index of the robot
  double impulse = 0;        ///< [N s]
  bool from_above = false;   ///< the ball lies on something
};

/// The Bullet world: bodies, shapes, settings. Knows nothing of kicks, carpets or commands.
class BulletScene {
 public:
  BulletScene(const world::Field& field, std::span<const world::RobotSpecs> robots, const Params& params);
  ~BulletScene();
  BulletScene(const BulletScene&) = delete;
  BulletScene& operator=(const BulletScene&) = delete;

  void add_robot(std::size_t robot, const world::Vector2d& position, double orientation);
  void add_robot(std::size_t robot, const BodyPose& pose);
  void move_robot(std::size_t robot, const world::Vector2d& position, double orientation);
  void remove_robot(std::size_t robot);

  RobotBody robot(std::size_t robot) const;
  double orientation(std::size_t robot) const;
  void set_robot_velocity(std::size_t robot, const world::Vector2d& velocity, double angular_velocity);

  BodyPose robot_pose(std::size_t robot) const;
  BodyPose ball_pose() const;
  void set_ball_pose(const BodyPose& pose);

  void add_robot_velocity(std::size_t robot, const world::Vector2d& velocity, double angular_velocity);

  /// Teleports: the ball's contact caches are cleared too.
  void move_ball(const world::Vector3d& position);
  void set_ball(const truth::Ball& ball);
  void read_ball(truth::Ball& ball) const;
  void set_ball_restitution(bool at_dribbler);

  /// One Bullet step; fills `ball_contacts`, at most one for each robot and one for all fixtures together.
  void step(double duration, std::vector<BallContact>& ball_contacts);

 private:
  void add_robot(std::size_t robot, const btTransform& pose);
  btRigidBody& add_body(double mass, const btVector3& inertia, btCollisionShape& shape, double restitution,
                        double friction);
  void teleport(btRigidBody& body, const btTransform& pose);
  void read_contacts(std::vector<BallContact>& contacts) const;

  btDefaultCollisionConfiguration configuration_;
  Dispatcher dispatcher_;
  btAxisSweep3 broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  BulletWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;  // fixtures, ball, robots
  std::vector<btRigidBody*> robots_;
  std::vector<double> robot_height_;  // of the body's origin [m]
  std::vector<float> reach_;          // [m] of ball and robots from their axes
  btRigidBody* ball_ = nullptr;
  float ball_restitution_ = 0;
  float ball_dribbler_restitution_ = 0;
};

}  // namespace physics
