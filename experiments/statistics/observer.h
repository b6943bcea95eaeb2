#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "experiments/record/match_statistics.h"
#include "sim/truth/truth.h"
#include "sim/world/field.h"
#include "sim/world/game_state.h"

namespace statistics {

/// Where a ball kicked into an empty field gets.
struct FreePath {
  world::Vector2d start = world::Vector2d::Zero();      ///< [m]
  world::Vector2d direction = world::Vector2d::Zero();  ///< of length 1; zero for a ball kicked straight up
  double reach = 0;                                     ///< [m] along the carpet until it rests
  double flight = 0;                                    ///< [m] of it in the first flight of a chip kick
  double rise = 0;                                      ///< slope of the flight at its start
  double height0 = 0;                                   ///< [m] of the centre at its start

  /// Height of the ball's centre [m] after `distance` [m]; after the first landing it is on the carpet.
  double height(double distance, double ball_radius) const;
};

/// The path from the ball's state after the kick, in closed form.
///
/// Along the carpet: slides with `ball_slide_deceleration` to `ball_switch_ratio` of its speed, then rolls.
/// Chip: flies without drag, keeps 5/7 of its speed along the carpet where it lands, then rolls.
/// Later bounces are left out: they end where the rolling ball does, within some centimetres.
FreePath free_path(const truth::Kick& kick, const world::Geometry& geometry);

/// How a kick looks at the moment it is made, on an empty field.
struct Aim {
  bool shot = false;       ///< reaches the goal line attacked, at most 0.3 m outside the posts
  bool on_target = false;  ///< whole ball between the posts and below the bar there
};
Aim aim_of(const FreePath& path, world::Side goal, const world::Geometry& geometry);

/// Watches a game's truth and counts. The definitions are the same for every team, whatever it intends.
///
/// In play     The referee's location is GAME_ON.
/// Touch       A contact of ball and robot with an impulse over 1 mN s. It is not counted again while the
///             same robot's last contact is at most 50 ms ago.
/// Kick        The kicker fired, in play or at a restart (SETUP).
/// Shot        A kick that, on an empty field, would reach the goal line attacked between the posts or at
///             most 0.3 m outside them, and is not next touched by a team-mate.
/// On target   A shot that would be in the goal: whole ball between the posts and below the bar.
/// Save        A shot on target that is next touched by the other team's keeper.
/// Pass        A kick that is next touched by a team-mate: a completed pass. Or a kick that is no shot, goes
///             within 0.5 m of a team-mate at least 0.2 m away from the ball, and is next touched by an
///             opponent or by nobody. A kick that is next touched by the kicker itself is no pass.
/// Possession  Time in play during which the team was the last to have touched the ball
///             since the last stoppage.
/// Turnover    The other team touches the ball in play and then remains the last to have done so for 0.5 s.
/// Territory   Time in play with the ball in the other team's half.
/// Ball out    The whole ball is over a line in play and not in a goal. Counts for the team that touched it
///             last.
/// Passage     From one beginning of play to its next interruption.
/// Distance    Of each robot from tick to tick, in play or not. Steps over 0.2 m (a robot that was put
///             elsewhere) are left out.
///
/// Keeper, ends and whether the ball is in play are taken from the referee, everything else from the truth.
/// No memory is allocated after the first tick.
class Observer {
 public:
  explicit Observer(const world::Geometry& geometry);

  /// One tick: what happened in it, and the referee's state after it.
  void update(const truth::Frame& frame, const world::GameState& state);

  /// So far; a kick that is still under way is not in it.
  record::MatchStatistics result() const;

  /// The end: what is under way is counted as it stands.
  void finish();

 private:
  struct Touch {
    world::RobotId robot;
    world::Time time;
  };
  struct OpenKick {
    world::RobotId kicker;
    world::Time time;
    Aim aim;
    bool towards_mate = false;
  };

  void touch(const truth::Contact& contact, const world::GameState& state);
  void kick(const truth::Kick& kick, const truth::Frame& frame, const world::GameState& state);
  void settle(std::optional<world::RobotId> next, const world::GameState& state);
  void count(const OpenKick& kick, std::optional<world::RobotId> next, int keeper);
  void count_time(const truth::Frame& frame, const world::GameState& state);
  void follow_possession(world::Time now);
  void watch_lines(const truth::Ball& ball);
  void end_passage();
  void run(const truth::Frame& frame);

  world::Geometry geometry_;
  record::MatchStatistics counted_;
  std::int64_t ticks_ = 0;
  std::int64_t ticks_in_play_ = 0;
  std::int64_t passage_ticks_ = 0;
  std::int64_t longest_passage_ticks_ = 0;
  world::PerTeam<std::int64_t> possession_ticks_{};
  world::PerTeam<std::int64_t> territory_ticks_{};

  std::optional<Touch> last_touch_;  ///< since the last restart
  std::optional<OpenKick> open_kick_;
  std::optional<world::Team> owner_;  ///< for turnovers
  world::Time challenged_since_;      ///< the other team has been last to touch since
  bool challenged_ = false;
  bool out_ = false;  ///< counted in this passage

  struct Place {
    world::RobotId robot;
    world::Vector2d position;
  };
  std::vector<Place> places_;  ///< at the last tick
};

}  // namespace statistics
