#include "teams/reference/roles.h"

#include <algorithm>

#include "teams/reference/assignment.h"
#include "teams/skills/motion.h"

namespace reference {
namespace {

constexpr int plan_every = 6;            // ticks
constexpr double keeps_task = 0.2;       // [s] reference "football", 2.7
constexpr double keeps_ball = 0.15;      // [s] ours
constexpr double keeps_kick = 1.5;       // [s] ours: who went to take or to block a kick does it
constexpr double keeps_neighbour = 0.3;  // [m] ours

bool same(const Formation& a, const Formation& b) {
  return a.winners == b.winners && a.defenders == b.defenders && a.supports == b.supports;
}

int choose_winner(const kit::View& view, const Situation& situation, const Roles& roles, const Roles& before,
                  std::optional<int> receiver) {
  if (view.own.size() == 1) return roles.goalie;
  int winner = -1;
  double best = 1e9;
  for (const kit::Robot& robot : view.own) {
    if (robot.number == roles.goalie || view.game.forbidden == robot.number) continue;
    double time = situation.meetings[robot.number].time;
    if (before.winner == robot.number) {
      time -= view.game.phase == kit::Phase::Running ? keeps_ball : keeps_kick;
    }
    if (kit::holds_ball(robot, view.ball, view.field().ball_radius)) time -= 0.5;
    if (receiver == robot.number) time -= 5;
    if (time < best) {
      best = time;
      winner = robot.number;
    }
  }
  return winner;
}

// Everyone still has the role of the tick before, and nobody came or went.
bool still_fits(const kit::View& view, const Roles& roles, const Roles& before) {
  if (before.winner != roles.winner || before.goalie != roles.goalie ||
      !same(before.formation, roles.formation)) {
    return false;
  }
  int defenders = 0;
  for (const kit::Robot& robot : view.own) {
    if (before.of(robot.number) == Role::None) return false;
    defenders += before.of(robot.number) == Role::Defender;
  }
  return defenders == static_cast<int>(before.defense.count);
}

void assign_defense(const kit::View& view, const Situation& situation, const Roles& before, Roles& roles) {
  std::array<const kit::Robot*, most_to_assign> candidates{};
  Costs costs;
  for (const kit::Robot& robot : view.own) {
    if (roles.role[robot.number] == Role::None && costs.robots < candidates.size()) {
      candidates[costs.robots++] = &robot;
    }
  }
  const auto wanted =
      std::min(static_cast<std::size_t>(std::max(roles.formation.defenders, 0)), costs.robots);
  roles.defense = plan_defense(view, situation, static_cast<int>(wanted), before.defense);
  costs.tasks = roles.defense.count;
  for (std::size_t task = 0; task < costs.tasks; ++task) {
    const Vector2d place = task_position(view, roles.defense.tasks[task]);
    for (std::size_t i = 0; i < costs.robots; ++i) {
      const kit::Robot& robot = *candidates[i];
      double time =
          skills::travel_time(place - robot.position, robot.velocity, skills::driving_limits(robot.specs));
      if (before.of(robot.number) == Role::Defender) {
        const auto had = static_cast<std::size_t>(before.index[robot.number]);
        if (had < before.defense.count && before.defense.tasks[had] == roles.defense.tasks[task]) {
          time -= keeps_task;
        }
      }
      costs.of[task][i] = time;
    }
  }
  const auto robot_of = assign(costs);
  for (std::size_t task = 0; task < costs.tasks; ++task) {
    const int number = candidates[robot_of[task]]->number;
    roles.role[static_cast<std::size_t>(number)] = Role::Defender;
    roles.index[static_cast<std::size_t>(number)] = static_cast<int>(task);
  }
}

// Neighbours keep their order: by y, so that they do not cross.
void order_supports(const kit::View& view, const Roles& before, Roles& roles) {
  for (const kit::Robot& robot : view.own) {
    if (roles.of(robot.number) != Role::Support) continue;
    int index = 0;
    for (const kit::Robot& other : view.own) {
      if (other.number == robot.number || roles.of(other.number) != Role::Support) continue;
      // The number decides between equals.
      double bias = other.number < robot.number ? -1e-9 : 1e-9;
      if (before.of(other.number) == Role::Support && before.of(robot.number) == Role::Support) {
        bias = before.index[other.number] < before.index[robot.number] ? -keeps_neighbour : keeps_neighbour;
      }
      if (other.position.y() + bias < robot.position.y()) ++index;
    }
    roles.index[robot.number] = index;
  }
}

}  // namespace

const char* name(Role role) {
  switch (role) {
    case Role::None:
      return "none";
    case Role::Goalie:
      return "goalie";
    case Role::Winner:
      return "winner";
    case Role::Support:
      return "support";
    case Role::Defender:
      return "defender";
  }
  return "unknown";
}

Formation formation(int field_players, Possession possession, double ball_x, const Parameters& parameters) {
  Formation f;
  if (field_players <= 0) return f;
  f.winners = 1;
  const int rest = field_players - 1;
  int defenders = parameters.defenders;
  if (possession == Possession::Theirs) defenders += ball_x < 0 ? 2 : 1;
  if (possession == Possession::Ours && ball_x > -0.5) defenders -= 1;
  // Never all in defence, never none: at least one in front when three or more are left.
  defenders = std::clamp(defenders, std::min(rest, 1), rest >= 3 ? rest - 1 : rest);
  if (rest == 2) defenders = 1;
  // But in our half everybody defends against the ball (reference "football", 2.8: 1 + 4 + 1).
  if (possession == Possession::Theirs && ball_x < 0.5) defenders = rest;
  f.defenders = defenders;
  f.supports = rest - defenders;
  return f;
}

int goalie_of(const kit::View& view) {
  if (kit::find(view.own, view.game.own_keeper) != nullptr) return view.game.own_keeper;
  return view.own.empty() ? -1 : view.own.front().number;
}

Roles assign_roles(const kit::View& view, const Situation& situation, const Roles& before,
                   Formation formation, std::optional<int> receiver) {
  Roles roles;
  roles.formation = formation;
  roles.goalie = goalie_of(view);
  roles.winner = choose_winner(view, situation, roles, before, receiver);
  if (view.tick % plan_every != 0 && still_fits(view, roles, before)) {
    roles.role = before.role;
    roles.index = before.index;
    roles.defense = before.defense;
  } else {
    if (roles.winner >= 0) roles.role[static_cast<std::size_t>(roles.winner)] = Role::Winner;
    if (roles.goalie >= 0) roles.role[static_cast<std::size_t>(roles.goalie)] = Role::Goalie;
    assign_defense(view, situation, before, roles);
    for (const kit::Robot& robot : view.own) {
      if (roles.role[robot.number] == Role::None) roles.role[robot.number] = Role::Support;
    }
  }
  order_supports(view, before, roles);
  return roles;
}

}  // namespace reference
