#include "sim/physics/world.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "sim/physics/actuators.h"
#include "sim/physics/ball.h"
#include "sim/physics/bullet_scene.h"
#include "sim/physics/dribbler.h"
#include "sim/physics/drive.h"
#include "sim/physics/fixtures.h"
#include "sim/physics/hull.h"
#include "sim/physics/kicker.h"
#include "sim/physics/placement.h"

namespace physics {
namespace {

using world::Vector2d;
using world::Vector3d;

Vector2d left_of(const Vector2d& forward) { return {-forward.y(), forward.x()}; }

Vector2d to_local(const Vector2d& vector, const Vector2d& forward) {
  return {forward.dot(vector), left_of(forward).dot(vector)};
}

Vector2d to_field(const Vector2d& local, const Vector2d& forward) {
  return forward * local.x() + left_of(forward) * local.y();
}

struct RobotState {
  RobotState(const world::RobotSpecs& specs_, const ActuatorErrors& errors, std::uint64_t seed)
      : specs(specs_), actuators(errors, specs_.id, seed), limits(specs_) {
    memory.command.number = specs.id.number;
    for (double* limit : {&limits.max_acceleration, &limits.max_acceleration_sideways, &limits.max_brake,
                          &limits.max_brake_sideways}) {
      *limit *= actuators.acceleration_factor();
    }
  }

  world::RobotSpecs specs;
  Actuators actuators;
  world::RobotSpecs limits;  // of the drive, with this robot's errors
  RobotMemory memory;
  RobotBody body;  // at the start of the substep
  // half of this substep's change by the drive, to be applied after the step
  Vector2d velocity_step = Vector2d::Zero();
  double angular_velocity_step = 0;
  double ball_impulse = 0;  // [N s] in this substep
};

}  // namespace

struct World::Impl {
  Impl(const world::Field& field_, std::span<const world::RobotSpecs> specs_, const Params& params_,
       std::uint64_t seed)
      : field(field_),
        specs(specs_.begin(), specs_.end()),
        params(with_radius(params_, field_.ball_radius)),
        scene(std::in_place, field, specs, params),
        fixtures(physics::fixtures(field_)) {
    for (const world::RobotSpecs& one : specs) robots.emplace_back(one, params.actuators, seed);
    ball.position.z() = params.ball.radius;
  }

  static Params with_radius(Params params, double radius) {
    params.ball.radius = radius;
    return params;
  }

  // Kicker and dribbler count time in substeps, so that it does not depend on rounding.
  int substeps(double seconds) const { return static_cast<int>(std::lround(seconds / h)); }

  BallLocal ball_local(const RobotState& robot) const {
    return {to_local(ball.position.head<2>() - robot.body.position, robot.body.forward), ball.position.z()};
  }
  bool ball_may_be_near(const RobotState& robot) const {
    const double reach = robot.specs.radius + 2 * params.ball.radius + 0.05;
    return (ball.position.head<2>() - robot.body.position).squaredNorm() < reach * reach;
  }
  bool in_box(const RobotState& robot, double reach, double highest) const {
    return in_front(ball_local(robot), robot.specs, params.ball.radius, reach, highest);
  }
  Vector2d front_velocity(const RobotState& robot) const {
    return robot.body.velocity +
           left_of(robot.body.forward) * (robot.body.angular_velocity * robot.specs.center_to_dribbler);
  }

  // An impulse between ball and robot that Bullet does not know of; [N s] on the ball.
  void exchange(RobotState& robot, const Vector3d& impulse) {
    ball.velocity += impulse / params.ball.mass;
    robot.body.velocity -= impulse.head<2>() / robot.specs.mass;
    robot.ball_impulse += impulse.norm();
  }

  void drive(RobotState& robot);
  void kick(RobotState& robot, world::Time end, std::vector<truth::Kick>& kicks);
  bool dribble(RobotState& robot);
  void roll_off();
  void bring_out(const RobotState& robot);
  void ride(const RobotState& robot);
  int bullet_steps(bool near_robot) const;

  world::Field field;
  std::vector<world::RobotSpecs> specs;
  Params params;
  double h = params.solver.substep_length;  // [s]
  std::optional<BulletScene> scene;         // always there; made anew to be rid of its history
  std::vector<Fixture> fixtures;
  std::vector<RobotState> robots;
  truth::Ball ball;
  std::vector<BallContact> contacts;
};

// Half of the change of velocity goes before Bullet's step and half after it, so that the step moves the
// robot with its mean velocity.
void World::Impl::drive(RobotState& robot) {
  const world::RobotCommand& command = robot.memory.command;
  const double turned = robot.body.angular_velocity * h / 2;
  // Turned by at most 0.05 rad in half a substep, so two terms of cosine and sine are good to 1e-6.
  const Vector2d forward = robot.body.forward * (1 - turned * turned / 2) +
                           left_of(robot.body.forward) * (turned - turned * turned * turned / 6);
  const Motion now{robot.body.velocity, robot.body.angular_velocity};
  Motion target{to_field(command.velocity_local * robot.actuators.speed_factor(), forward),
                command.angular_velocity};
  if (robot.actuators.heading_drift() != 0) {
    target.angular_velocity += robot.actuators.heading_drift() * now.velocity.norm();
  }
  const Motion next = driven(now, target, forward, robot.limits, h);
  robot.velocity_step = (next.velocity - now.velocity) / 2;
  robot.angular_velocity_step = (next.angular_velocity - now.angular_velocity) / 2;
  robot.body.velocity += robot.velocity_step;
  robot.body.angular_velocity += robot.angular_velocity_step;
}

void World::Impl::kick(RobotState& robot, world::Time end, std::vector<truth::Kick>& kicks) {
  RobotMemory& memory = robot.memory;
  if (memory.recharging > 0 || !(memory.command.kick_speed > 0)) return;
  if (!in_box(robot, params.kicker.reach, params.kicker.highest_ball)) return;
  const KickError error = robot.actuators.kick(memory.kicks++);
  memory.recharging = substeps(params.kicker.recharge);
  if (error.misfires) return;
  const auto velocity = kicked_velocity(memory.command, robot.specs, params.kicker, robot.body.forward,
                                        front_velocity(robot), error);
  exchange(robot, (*velocity - ball.velocity) * params.ball.mass);
  ball.velocity = *velocity;
  ball.spin.setZero();
  memory.letting_go = memory.recharging;
  kicks.push_back({end, robot.specs.id, ball.position, ball.velocity});
}

// Returns whether the dribbler holds the ball.
bool World::Impl::dribble(RobotState& robot) {
  RobotMemory& memory = robot.memory;
  const double strength = grip(memory.command.dribbler_speed, params.dribbler);
  if (strength <= 0 || memory.letting_go > 0) return false;
  if (!in_box(robot, params.dribbler.reach, params.dribbler.highest_ball)) return false;
  if (memory.holding == 0) memory.grip_factor = robot.actuators.grip_factor(memory.captures++);
  memory.holding = substeps(params.dribbler.same_capture);
  const Vector2d& forward = robot.body.forward;
  const Vector2d relative = to_local(ball.velocity.head<2>() - front_velocity(robot), forward);
  const Vector2d push =
      to_field(dribbler_push(ball_local(robot), relative, robot.specs, strength * memory.grip_factor,
                             params.ball.radius, h, params.dribbler),
               forward);
  exchange(robot, Vector3d(push.x(), push.y(), 0) * params.ball.mass);
  ball.spin = dribbled_spin(ball.spin, forward, memory.command.dribbler_speed, params.ball.radius, h,
                            params.dribbler);
  return true;
}

// A ball that was put into a robot: Bullet knows the way out of what overlaps by less than the ball's
// diameter, deeper it would press it into the carpet. It is moved, not accelerated. No hit goes so deep
// (tests: Tunnelling).
void World::Impl::bring_out(const RobotState& robot) {
  constexpr double shallow = 0.018;  // [m] of the ball's centre under the hull; Bullet manages up to 0.0215
  constexpr double speed = 1;        // [m/s] ours
  if (ball.position.z() > robot.specs.height) return;
  const Vector2d from_center = ball.position.head<2>() - robot.body.position;
  const double distance = from_center.norm();
  if (distance > robot.specs.radius - shallow ||
      from_center.dot(robot.body.forward) > robot.specs.center_to_dribbler - shallow) {
    return;
  }
  const Vector2d outward = distance > 1e-6 ? Vector2d(from_center / distance) : robot.body.forward;
  ball.position.head<2>() += outward * (speed * h);
}

// From a goal's roof over its back.
void World::Impl::roll_off() { ball.velocity.x() += std::copysign(params.perch.push * h, ball.position.x()); }

// A ball that touches a robot's cover from above: Bullet has done contact and friction, what is missing is
// the resistance to rolling, which lets it come to rest there and ride along.
void World::Impl::ride(const RobotState& robot) {
  const Vector2d arm = ball.position.head<2>() - robot.body.position;
  const Vector2d cover = robot.body.velocity + left_of(arm) * robot.body.angular_velocity;
  const Vector2d relative = ball.velocity.head<2>() - cover;
  const double speed = relative.norm();
  const double loss = params.perch.roll_deceleration * h;
  const double kept = speed > loss ? 1 - loss / speed : 0;
  ball.velocity.head<2>() = cover + relative * kept;
  ball.spin.head<2>() *= kept;
  if (std::abs(ball.velocity.z()) < gravity * h) ball.velocity.z() = 0;
}

// A ball must not get past the middle of what it hits in one step. 8 m/s is safe at 1/240 s (tests:
// Tunnelling); with a robot coming at it at 3 m/s that leaves 5 m/s for the ball. A faster one near a robot
// or a goal gets two steps.
int World::Impl::bullet_steps(bool near_robot) const {
  constexpr double fast = 5;    // [m/s]
  constexpr double near = 0.1;  // [m] more than ball radius and travel of a substep at 10 m/s
  if (ball.velocity.squaredNorm() < fast * fast) return 1;
  const bool near_goal = std::abs(ball.position.x()) > field.half_length() - near &&
                         std::abs(ball.position.y()) < field.goal_width / 2 + 2 * near;
  return near_robot || near_goal ? 2 : 1;
}

World::World(const world::Field& field, std::span<const world::RobotSpecs> robots, const Params& params,
             std::uint64_t seed)
    : impl_(std::make_unique<Impl>(field, robots, params, seed)) {
  assert(
      std::is_sorted(robots.begin(), robots.end(), [](const auto& a, const auto& b) { return a.id < b.id; }));
}
World::~World() = default;

std::size_t World::robot_count() const { return impl_->robots.size(); }
const world::RobotSpecs& World::specs(std::size_t robot) const { return impl_->robots[robot].specs; }
bool World::is_present(std::size_t robot) const { return impl_->robots[robot].memory.present; }

void World::set_command(std::size_t robot, const world::RobotCommand& command) {
  impl_->robots[robot].memory.command = command;
}

void World::substep(world::Time end, std::vector<truth::Contact>& contacts, std::vector<truth::Kick>& kicks) {
  Impl& impl = *impl_;
  truth::Ball& ball = impl.ball;
  const BallParams& ball_params = impl.params.ball;

  bool held = false;
  bool at_dribbler = false;
  bool near_robot = false;
  for (std::size_t i = 0; i < impl.robots.size(); ++i) {
    RobotState& robot = impl.robots[i];
    if (!robot.memory.present) continue;
    robot.body = impl.scene->robot(i);
    robot.ball_impulse = 0;
    for (int* left : {&robot.memory.recharging, &robot.memory.letting_go, &robot.memory.holding}) {
      *left = std::max(*left - 1, 0);
    }
    impl.drive(robot);
    if (impl.ball_may_be_near(robot)) {
      near_robot = true;
      impl.bring_out(robot);
      impl.kick(robot, end, kicks);
      if (impl.dribble(robot)) held = true;
      // A fast ball reaches the bar within the substep: 10 m/s cover 42 mm.
      if (robot.memory.command.dribbler_speed > 0 &&
          impl.in_box(robot, 0.045, impl.params.dribbler.highest_ball)) {
        at_dribbler = true;
      }
    }
    impl.scene->set_robot_velocity(i, robot.body.velocity, robot.body.angular_velocity);
  }

  // The ball's own motion: half of its change before Bullet's step, half after it. A held ball is carried by
  // the dribbler, whose limits include the carpet's friction.
  const bool grounded = on_ground(ball, ball_params);
  if (!grounded) {
    ball.velocity.z() -= gravity * impl.h / 2;
  } else if (!held) {
    apply_ground_friction(ball, impl.h / 2, ball_params);
  }
  impl.scene->set_ball(ball);
  impl.scene->set_ball_restitution(at_dribbler);
  const int steps = impl.bullet_steps(near_robot);
  for (int i = 0; i < steps; ++i) {
    impl.scene->step(impl.h / steps, impl.contacts);
    for (const BallContact& contact : impl.contacts) {
      if (contact.robot >= 0)
        impl.robots[static_cast<std::size_t>(contact.robot)].ball_impulse += contact.impulse;
    }
  }
  impl.scene->read_ball(ball);

  if (!grounded) {
    ball.velocity.z() -= gravity * impl.h / 2;
    bounce(ball, ball_params);
  } else if (on_ground(ball, ball_params)) {
    ball.position.z() = ball_params.radius;
    ball.velocity.z() = 0;
    if (!held) apply_ground_friction(ball, impl.h / 2, ball_params);
  }

  for (const BallContact& contact : impl.contacts) {
    if (!contact.from_above || grounded) continue;
    if (contact.robot < 0) {
      impl.roll_off();
    } else {
      impl.ride(impl.robots[static_cast<std::size_t>(contact.robot)]);
    }
  }
  for (std::size_t i = 0; i < impl.robots.size(); ++i) {
    RobotState& robot = impl.robots[i];
    if (!robot.memory.present) continue;
    impl.scene->add_robot_velocity(i, robot.velocity_step, robot.angular_velocity_step);
    if (robot.ball_impulse > 0) contacts.push_back({end, robot.specs.id, ball.position, robot.ball_impulse});
  }
}

const truth::Ball& World::ball() const { return impl_->ball; }

void World::read_robots(std::vector<truth::Robot>& out) const {
  out.clear();
  for (std::size_t i = 0; i < impl_->robots.size(); ++i) {
    RobotState& robot = impl_->robots[i];
    if (!robot.memory.present) continue;
    robot.body = impl_->scene->robot(i);
    const KickerParams& kicker = impl_->params.kicker;
    const bool contact =
        impl_->ball_may_be_near(robot) && impl_->in_box(robot, kicker.reach, kicker.highest_ball);
    out.push_back({robot.specs.id, robot.body.position, impl_->scene->orientation(i), robot.body.velocity,
                   robot.body.angular_velocity, contact});
  }
}

void World::place_ball(const truth::Ball& ball) {
  impl_->ball = ball;
  impl_->scene->move_ball(ball.position);
}

void World::place_ball(const Vector2d& spot) {
  truth::Ball ball;
  ball.position = {spot.x(), spot.y(), impl_->params.ball.radius};
  place_ball(ball);
}

void World::put_robot(std::size_t index, const Vector2d& position, double orientation) {
  RobotState& robot = impl_->robots[index];
  if (robot.memory.present) {
    impl_->scene->move_robot(index, position, orientation);
  } else {
    impl_->scene->add_robot(index, position, orientation);
  }
  robot.memory.present = true;
  robot.memory.recharging = robot.memory.letting_go = robot.memory.holding = 0;
  robot.memory.command = {};
  robot.body = impl_->scene->robot(index);
}

void World::set_motion(std::size_t robot, const Vector2d& velocity, double angular_velocity) {
  impl_->scene->set_robot_velocity(robot, velocity, angular_velocity);
}

void World::remove_robot(std::size_t index) {
  RobotState& robot = impl_->robots[index];
  if (!robot.memory.present) return;
  impl_->scene->remove_robot(index);
  robot.memory.present = false;
}

State World::state() const {
  State state;
  state.ball = impl_->ball;
  state.ball_pose = impl_->scene->ball_pose();
  for (std::size_t i = 0; i < impl_->robots.size(); ++i) {
    const RobotMemory& memory = impl_->robots[i].memory;
    state.robots.push_back({memory, {}, Vector2d::Zero(), 0});
    if (!memory.present) continue;
    const RobotBody body = impl_->scene->robot(i);
    state.robots.back().pose = impl_->scene->robot_pose(i);
    state.robots.back().velocity = body.velocity;
    state.robots.back().angular_velocity = body.angular_velocity;
  }
  return state;
}

void World::restore(const State& state) {
  Impl& impl = *impl_;
  assert(state.robots.size() == impl.robots.size());
  impl.scene.emplace(impl.field, impl.specs, impl.params);
  impl.ball = state.ball;
  impl.scene->set_ball_pose(state.ball_pose);
  for (std::size_t i = 0; i < impl.robots.size(); ++i) {
    const State::Robot& from = state.robots[i];
    impl.robots[i].memory = from.memory;
    if (!from.memory.present) continue;
    impl.scene->add_robot(i, from.pose);
    impl.scene->set_robot_velocity(i, from.velocity, from.angular_velocity);
    impl.robots[i].body = impl.scene->robot(i);
  }
}

double World::distance_to_robots(const Vector2d& point) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < impl_->robots.size(); ++i) {
    const RobotState& robot = impl_->robots[i];
    if (!robot.memory.present) continue;
    const RobotBody body = impl_->scene->robot(i);
    least = std::min(least, hull_distance_local(robot.specs, to_local(point - body.position, body.forward)));
  }
  return least;
}

void World::push_robots_out(const Vector2d& spot, double clearance) {
  std::vector<Placed> places;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < impl_->robots.size(); ++i) {
    if (!impl_->robots[i].memory.present) continue;
    places.push_back(
        {&impl_->robots[i].specs, impl_->scene->robot(i).position, impl_->scene->orientation(i)});
    indices.push_back(i);
  }
  const std::vector<bool> moved = push_out(places, impl_->fixtures, impl_->field, spot, clearance);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!moved[k]) continue;
    impl_->scene->move_robot(indices[k], places[k].position, places[k].orientation);
  }
}

}  // namespace physics
