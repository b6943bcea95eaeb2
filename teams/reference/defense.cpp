#include "teams/reference/defense.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reference {
namespace {

constexpr double farthest_mark = 1.0;   // [m] opponents beyond are no threat yet (ours)
constexpr double keeps_mark = 0.2;      // [s] reference "football", 2.7
constexpr double urgent_threat = 1.3;   // [s] pass and shot together (ours)
constexpr std::size_t most_urgent = 3;  // more than that the wall's second robot does not wait for (ours)

constexpr double wall_aside = 0.15;  // [m] on the goal line (ours)
// [m] of the goalie from the line to the goal's middle, from which it is all
constexpr double goalie_aside = 0.2;

// Where on the goal line [m from its middle] a single robot in the wall aims:
// the half that the goalie has not.
double beside_goalie(const kit::View& view) {
  const kit::Robot* goalie = kit::find(view.own, view.game.own_keeper);
  if (goalie == nullptr) return 0;
  const Vector2d home = view.own_goal() - view.ball.position;
  const Vector2d across = Vector2d(home.y(), -home.x()).normalized();  // +y for a ball in front of the goal
  const double off = (goalie->position - view.ball.position).dot(across);
  return -wall_aside * std::clamp(off / goalie_aside, -1.0, 1.0);
}

}  // namespace

Vector2d wall_position(const kit::View& view, int index, int count) {
  const world::Field& field = view.field();
  const double aside = count == 1 ? beside_goalie(view) : 0;
  const Vector2d goal = view.own_goal() + Vector2d(0, aside);
  Vector2d to_ball = view.ball.position - goal;
  if (to_ball.x() < 0.1) to_ball.x() = 0.1;
  const Vector2d along = to_ball.normalized();
  const double clear = field.robot_radius + 0.06;  // [m] hull outside the line, with room for the steering
  // Out along the line until outside the area.
  double s = 0.5;
  for (int i = 0; i < 30; ++i) {
    // The distance grows by at most a metre per metre, so this step never goes too far.
    const double missing =
        clear - world::distance_to_defense_area(field, world::Side::Negative, goal + s * along);
    if (missing <= 0.005) break;
    s += missing;
  }
  const double spacing = 2 * field.robot_radius + 0.03;
  const double beside = (index - 0.5 * (count - 1)) * spacing;
  const Vector2d across(-along.y(), along.x());
  return world::moved_out_of_defense_area(field, world::Side::Negative, goal + s * along + beside * across,
                                          clear);
}

double threat_time(const kit::View& view, const kit::Robot& opponent) {
  const Vector2d goal = view.own_goal();
  const Vector2d to_goal = goal - opponent.position;
  const Vector2d to_ball = view.ball.position - opponent.position;
  const double turn = std::abs(world::wrap_angle(world::angle_of(to_goal) - world::angle_of(to_ball)));
  const double deflection = std::clamp((turn - M_PI / 4) / (M_PI / 4), 0.0, 1.0);
  return to_ball.norm() / 4.0 + 0.5 * deflection + to_goal.norm() / 6.5;
}

Vector2d mark_position(const kit::View& view, const kit::Robot& opponent) {
  const Vector2d position = opponent.position + 0.2 * opponent.velocity;
  const Vector2d to_goal = (view.own_goal() - position).normalized();
  const Vector2d to_ball = (view.ball.position - position).normalized();
  // Goal side, and a little into the pass.
  return position + 0.4 * (0.75 * to_goal + 0.25 * to_ball);
}

int robots_to_close(const kit::View& view) {
  const world::Field& field = view.field();
  const Vector2d ball = view.ball.position;
  const Vector2d goal = view.own_goal();
  const double half = field.goal_width / 2;
  const double width = std::abs(world::wrap_angle(world::angle_of(goal + Vector2d(0, half) - ball) -
                                                  world::angle_of(goal - Vector2d(0, half) - ball)));
  const double disc = field.robot_radius + field.ball_radius;
  const auto covers = [disc](double distance) { return 2 * std::asin(std::min(1.0, disc / distance)); };
  const double goalie = covers(std::max((goal - ball).norm() - 0.3, 0.1));
  const double each = covers(std::max((wall_position(view, 0, 1) - ball).norm(), 0.1));
  return std::max(1, static_cast<int>(std::ceil((width - goalie) / each)));
}

DefensePlan plan_defense(const kit::View& view, const Situation& situation, int defenders,
                         const DefensePlan& before) {
  DefensePlan plan;
  const auto wanted = std::min(static_cast<std::size_t>(std::max(defenders, 0)), plan.tasks.size());
  // The worst threats in order, but for the one at the ball.
  struct Threat {
    double time = 0;
    int number = -1;
  };
  std::array<Threat, 16> threats;
  std::size_t found = 0;
  for (const kit::Robot& opponent : view.opponents) {
    if (opponent.number == situation.their_first || opponent.number == view.game.their_keeper) continue;
    if (opponent.position.x() > farthest_mark || found == threats.size()) continue;
    double time = threat_time(view, opponent);
    for (std::size_t i = 0; i < before.count; ++i) {
      if (before.tasks[i].opponent == opponent.number) time -= keeps_mark;
    }
    threats[found++] = {time, opponent.number};
  }
  std::sort(threats.begin(), threats.begin() + static_cast<std::ptrdiff_t>(found),
            [](const Threat& a, const Threat& b) {
              return a.time != b.time ? a.time < b.time : a.number < b.number;
            });
  const auto urgent = static_cast<std::size_t>(
      std::count_if(threats.begin(), threats.begin() + static_cast<std::ptrdiff_t>(found),
                    [](const Threat& threat) { return threat.time < urgent_threat; }));
  // Who can shoot next is marked before a second robot joins the wall.
  const bool two = wanted >= 2 + std::min(urgent, most_urgent) && robots_to_close(view) > 1;
  const int wall = wanted == 0 ? 0 : two ? 2 : 1;
  for (int i = 0; i < wall; ++i) plan.tasks[plan.count++] = {DefenseTask::Kind::Wall, i, wall, -1};
  for (std::size_t i = 0; i < found && plan.count < wanted; ++i) {
    plan.tasks[plan.count++] = {DefenseTask::Kind::Mark, 0, 1, threats[i].number};
  }
  for (int place = 0; plan.count < wanted; ++place) {
    plan.tasks[plan.count++] = {DefenseTask::Kind::Cover, place, 1, -1};
  }
  return plan;
}

Vector2d task_position(const kit::View& view, const DefenseTask& task) {
  if (task.kind == DefenseTask::Kind::Wall) return wall_position(view, task.place, task.of);
  if (const kit::Robot* opponent = kit::find(view.opponents, task.opponent)) {
    return mark_position(view, *opponent);
  }
  // Nobody to mark: in front of the middle, ready for the second ball; the second one farther up.
  Vector2d place = 0.5 * (view.own_goal() + view.ball.position);
  place.x() = std::min(place.x(), -1.0) + 0.8 * task.place;
  place.y() *= 0.5;
  return place;
}

skills::Order play_defender(const kit::View& view, const kit::Robot& robot, const DefenseTask& task) {
  skills::Order order;
  order.heading = world::angle_of(view.ball.position - robot.position);
  order.ball_distance = 0.1;
  order.target = task_position(view, task);
  switch (task.kind) {
    case DefenseTask::Kind::Wall:
      order.why = "wall";
      break;
    case DefenseTask::Kind::Mark:
      order.why = "mark";
      break;
    case DefenseTask::Kind::Cover:
      order.why = "cover";
      break;
  }
  return order;
}

}  // namespace reference
