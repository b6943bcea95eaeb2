#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace world {

enum class Team : std::uint8_t { Yellow, Blue };

inline constexpr std::array<Team, 2> both_teams = {Team::Yellow, Team::Blue};

constexpr Team opponent(Team team) { return team == Team::Yellow ? Team::Blue : Team::Yellow; }
constexpr const char* name(Team team) { return team == Team::Yellow ? "yellow" : "blue"; }

struct RobotId {
  Team team{};
  std::uint8_t number{};
  auto operator<=>(const RobotId&) const = default;
};

inline constexpr int max_robot_number = 15;  ///< SSL-Vision knows patterns 0 to 15

/// One value for each team, addressed by the team.
template <class T>
struct PerTeam {
  T yellow{};
  T blue{};
  constexpr T& operator[](Team team) { return team == Team::Yellow ? yellow : blue; }
  constexpr const T& operator[](Team team) const { return team == Team::Yellow ? yellow : blue; }
  bool operator==(const PerTeam&) const = default;
};

}  // namespace world
