#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "autoref/detectors/catalogue.h"
#include "autoref/referee/referee.h"
#include "sim/vision/cameras.h"

namespace scenarios {

/// How the story is shown to the referee: turned over or with the colours exchanged, it must end the same.
struct View {
  bool mirror_x = false;
  bool mirror_y = false;
  bool swap_colours = false;
  std::uint64_t seed = 0;  ///< 0: tracked frames without error; else what cameras with preset harsh see
};

/// All eight, without error.
std::vector<View> all_views();
/// As written, and turned and exchanged, through harsh cameras with a seed each.
std::vector<View> harsh_views();
std::string name(const View& view);

/// A game told in tracked frames, 60 a second: the referee at work, a host that puts the ball where it is
/// wished half a second after the wish, and robots and ball that do as told. In a view with a seed the
/// referee gets detections instead: simulated cameras with preset "harsh" see where everything is, and
/// tracker and touch detection do their work (`touch` and heights of the ball are lost).
///
/// The story is written as if yellow defended the goal at -x and had the first kickoff; places and teams are
/// turned by the view on the way in and back on the way out. Both teams have six robots, none near the ball.
class Story {
 public:
  explicit Story(View view = {}, const std::string& rules = "ssl-2015", double half_length = 600,
                 bool winner = false);

  // --- What happens ---

  void tick();
  /// Time passes without any frame.
  void skip(double seconds);
  void wait(double seconds);
  /// Ticks until the referee is in the location, at most `limit` seconds.
  bool wait_for(world::Location location, double limit = 40);
  /// Puts a robot somewhere, at rest.
  void put(world::RobotId robot, world::Vector2d place);
  void put_ball(world::Vector2d place);
  /// The ball rolls straight to a place at constant speed [m/s]; it rests there.
  void roll(world::Vector2d to, double speed = 3.0);
  /// A robot steps behind the ball, facing the target, and the ball leaves it;
  /// the touch is reported two frames late.
  void kick(world::RobotId robot, world::Vector2d to, double speed = 3.0);
  /// A robot moves with the ball at its dribbler.
  void dribble(world::RobotId robot, world::Vector2d to, double speed = 1.0);
  /// The ball flies from a robot straight to a place, on a parabola `height` [m] high, and lands there.
  void chip(world::RobotId robot, world::Vector2d to, double height, double speed = 3.0);
  /// Robots drive straight and at the same time, each until it has arrived; they rest there.
  struct Drive {
    world::RobotId robot;
    world::Vector2d to;
    double speed = 1.0;  ///< [m/s]
  };
  void drive(std::vector<Drive> drives);
  /// Another robot comes onto the field.
  void add(world::RobotId robot, world::Vector2d place);
  /// The touch detector says that the robot touched the ball now.
  void touch(world::RobotId robot);
  /// Robots go to their places when the ball is placed; not any more.
  void keep_robots() { robots_go_home_ = false; }
  /// The host does not put the ball where it is wished.
  void refuse_placement() { host_places_ball_ = false; }
  void hide_ball(bool hidden = true) { ball_hidden_ = hidden; }
  /// From INIT through the first kickoff into GAME_ON: yellow 1 taps the ball and steps back,
  /// yellow 2 has touched it.
  void begin();

  // --- What came of it ---

  /// Whether the detectors saw an event of that kind (referee::kind_of) since it was asked last.
  bool saw(const std::string& kind);
  bool harsh() const { return cameras_.has_value(); }

  referee::Referee& referee() { return referee_; }
  const world::GameState& state() const { return referee_.state(); }
  /// The commands so far, such as "STOP KICKOFF(yellow) READY", in the story's colours. Reading forgets them.
  std::string commands();
  /// Rows taken so far, without T14 (touches). Reading forgets them.
  std::string rows();
  const std::vector<referee::Call>& calls() const { return calls_; }
  const referee::Call& last_call() const { return calls_.back(); }
  /// In the story's colours and coordinates.
  world::Team kick_team() const { return seen(state().kick_team); }
  world::Vector2d reset_position() const { return turned(*state().reset_position); }
  int score(world::Team team) const { return state().score[seen(team)]; }
  world::Vector2d ball() const { return ball_; }
  double now() const { return world::seconds(world::tick_time(tick_)); }
  world::Team seen(world::Team team) const { return view_.swap_colours ? world::opponent(team) : team; }
  /// A place as the referee sees it, and back.
  world::Vector2d turned(const world::Vector2d& place) const;
  world::RobotId seen(world::RobotId robot) const { return {seen(robot.team), robot.number}; }

 private:
  struct Robot {
    world::RobotId id;
    world::Vector2d place = world::Vector2d::Zero();
    world::Vector2d velocity = world::Vector2d::Zero();
    bool ball_in_reach = false;
    world::Vector2d heading{1, 0};   // a unit vector
    world::Vector2d before = place;  // a tick ago
  };

  Robot& robot(world::RobotId id);
  world::TrackedFrame frame();
  referee::Output show();
  void look(std::int64_t tick);
  void watch(const world::GameState& before);
  void host(const referee::Output& output);

  View view_;
  referee::Referee referee_;
  detectors::Detectors watchers_;  // the same once more, to know what they saw
  std::set<std::string> seen_kinds_;
  std::optional<vision::Cameras> cameras_;
  std::optional<world::Flight> flight_;
  double height_ = 0;  // [m] of the ball
  double height_before_ = 0;
  std::int64_t tick_ = 0;
  world::Vector2d ball_ = world::Vector2d::Zero();
  world::Vector2d ball_before_ = world::Vector2d::Zero();
  bool ball_hidden_ = false;
  std::int64_t ball_seen_tick_ = 0;
  bool robots_go_home_ = true;
  bool host_places_ball_ = true;
  std::vector<Robot> robots_;
  std::vector<std::pair<std::int64_t, world::Touch>> touches_;     // with the tick in which they are reported
  std::optional<std::pair<std::int64_t, world::Vector2d>> reset_;  // with the tick in which the host obeys
  std::vector<referee::Call> calls_;
  std::vector<std::string> commands_;
  std::vector<std::string> rows_;
};

constexpr world::RobotId yellow(int number) {
  return {world::Team::Yellow, static_cast<std::uint8_t>(number)};
}
constexpr world::RobotId blue(int number) { return {world::Team::Blue, static_cast<std::uint8_t>(number)}; }

}  // namespace scenarios
