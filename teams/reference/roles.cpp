#include "teams/reference/roles.h"

#include <algorithm>

namespace reference {

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
  if (possession == Possession::Theirs && ball_x < 0) defenders += 1;
  if (possession == Possession::Ours && ball_x > 1.0) defenders -= 1;
  // Never all in defence, never none: at least one in front when three or more are left.
  defenders = std::clamp(defenders, std::min(rest, 1), rest >= 3 ? rest - 1 : rest);
  if (rest == 2) defenders = possession == Possession::Theirs ? 2 : 1;
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
  roles.goalie = goalie_of(view);
  if (roles.goalie >= 0) roles.role[static_cast<std::size_t>(roles.goalie)] = Role::Goalie;

  const auto free_robot = [&](const kit::Robot& robot) { return roles.role[robot.number] == Role::None; };

  if (formation.winners > 0) {
    double best = 1e9;
    for (const kit::Robot& robot : view.own) {
      if (!free_robot(robot) || view.game.forbidden == robot.number) continue;
      double time = situation.meetings[robot.number].time;
      if (before.winner == robot.number) time -= 0.15;
      if (kit::holds_ball(robot, view.ball, view.field().ball_radius)) time -= 0.5;
      if (receiver == robot.number) time -= 5;
      if (time < best) {
        best = time;
        roles.winner = robot.number;
      }
    }
    if (roles.winner >= 0) roles.role[static_cast<std::size_t>(roles.winner)] = Role::Winner;
  }

  for (int i = 0; i < formation.defenders; ++i) {
    double best = 1e9;
    int chosen = -1;
    for (const kit::Robot& robot : view.own) {
      if (!free_robot(robot)) continue;
      double distance = (robot.position - view.own_goal()).norm();
      if (before.of(robot.number) == Role::Defender) distance -= 0.4;
      if (distance < best) {
        best = distance;
        chosen = robot.number;
      }
    }
    if (chosen < 0) break;
    roles.role[static_cast<std::size_t>(chosen)] = Role::Defender;
  }
  for (const kit::Robot& robot : view.own) {
    if (free_robot(robot)) roles.role[robot.number] = Role::Support;
  }

  // Neighbours keep their order: by y, so that they do not cross.
  for (const Role role : {Role::Defender, Role::Support}) {
    for (const kit::Robot& robot : view.own) {
      if (roles.of(robot.number) != role) continue;
      int index = 0;
      for (const kit::Robot& other : view.own) {
        if (other.number == robot.number || roles.of(other.number) != role) continue;
        // 0.3 m in favour of the order before; the number decides between equals.
        double bias = other.number < robot.number ? -1e-9 : 1e-9;
        if (before.of(other.number) == role && before.of(robot.number) == role) {
          bias = before.index[other.number] < before.index[robot.number] ? -0.3 : 0.3;
        }
        if (other.position.y() + bias < robot.position.y()) ++index;
      }
      roles.index[robot.number] = index;
    }
  }
  return roles;
}

}  // namespace reference
