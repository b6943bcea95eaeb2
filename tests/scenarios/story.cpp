#include "tests/scenarios/story.h"

#include <algorithm>
#include <cmath>

#include "autoref/referee/explain.h"
#include "sim/engine/realism.h"

namespace scenarios {
namespace {

using world::Location;
using world::Team;
using world::Vector2d;

referee::Setup setup_for(const View& view, const std::string& rules, double half_length, bool winner) {
  referee::Setup setup;
  setup.rules = world::rule_set(rules);
  setup.rules.half_length = world::from_seconds(half_length);
  setup.rules.extra_half_length = setup.rules.half_length;
  setup.rules.winner = winner;
  setup.first_kickoff = view.swap_colours ? Team::Blue : Team::Yellow;
  setup.blue_on_positive_half = view.mirror_x == view.swap_colours;
  setup.names = {"Y", "B"};
  setup.geometry.field = setup.rules.field;
  const vision::Params& vision = engine::realism("harsh").vision;
  setup.geometry.cameras = world::camera_grid(setup.rules.field, vision.cameras, vision.camera_height);
  return setup;
}

std::string joined(std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  words.clear();
  return text;
}

// Where robots wait: far from the ball's usual ways, from the areas and from the other half.
Vector2d home(world::RobotId id) {
  const double x = 1.5 + 0.5 * (id.number % 2);
  const double y = -2.6 + 1.04 * id.number;
  return {id.team == Team::Yellow ? -x : x, y};
}

constexpr double at_dribbler = 0.073 + 0.0215;  // [m] robot's centre to the ball's

}  // namespace

std::vector<View> all_views() {
  std::vector<View> views;
  for (const bool x : {false, true}) {
    for (const bool y : {false, true}) {
      for (const bool colours : {false, true}) views.push_back({x, y, colours});
    }
  }
  return views;
}

std::vector<View> harsh_views() {
  return {{false, false, false, 1}, {true, false, true, 2}, {false, true, true, 3}, {true, true, false, 4}};
}

std::string name(const View& view) {
  std::string text = view.seed != 0 ? "Harsh" : "";
  if (view.mirror_x) text += "MirroredX";
  if (view.mirror_y) text += "MirroredY";
  if (view.swap_colours) text += "ColoursSwapped";
  return text.empty() ? "AsWritten" : text;
}

Story::Story(View view, const std::string& rules, double half_length, bool winner)
    : view_(view), referee_(setup_for(view, rules, half_length, winner)), watchers_(world::rule_set(rules)) {
  if (view.seed != 0) {
    const referee::Setup setup = setup_for(view, rules, half_length, winner);
    cameras_.emplace(setup.geometry, engine::realism("harsh").vision, view.seed);
  }
  for (const Team team : world::both_teams) {
    for (std::uint8_t number = 0; number < 6; ++number) add({team, number}, home({team, number}));
  }
}

void Story::add(world::RobotId id, Vector2d place) {
  Robot robot;
  robot.id = id;
  robot.place = robot.before = place;
  robots_.push_back(robot);
}

Story::Robot& Story::robot(world::RobotId id) {
  return *std::find_if(robots_.begin(), robots_.end(), [&](const Robot& r) { return r.id == id; });
}

Vector2d Story::turned(const Vector2d& place) const {
  return {view_.mirror_x ? -place.x() : place.x(), view_.mirror_y ? -place.y() : place.y()};
}

world::TrackedFrame Story::frame() {
  world::TrackedFrame frame;
  frame.time = world::tick_time(tick_);
  world::TrackedBall ball;
  ball.position.head<2>() = turned(ball_);
  ball.velocity.head<2>() = turned((ball_ - ball_before_) * world::ticks_per_second);
  ball.observed = !ball_hidden_;
  if (!ball_hidden_) ball_seen_tick_ = tick_;
  ball.unseen = world::tick_time(tick_) - world::tick_time(ball_seen_tick_);
  ball.position.z() = height_;
  ball.velocity.z() = (height_ - height_before_) * world::ticks_per_second;
  ball.flight = flight_;
  ball.airborne = flight_ ? 1 : 0;
  if (flight_) ball.flight->from = turned(flight_->from);
  frame.ball = ball;
  for (const Robot& robot : robots_) {
    world::TrackedRobot tracked;
    tracked.id = seen(robot.id);
    tracked.position = turned(robot.place);
    tracked.orientation = world::angle_of(turned(robot.heading));
    tracked.velocity = turned(robot.velocity);
    tracked.observed = true;
    tracked.ball_in_reach = robot.ball_in_reach;
    frame.robots.push_back(tracked);
  }
  std::ranges::sort(frame.robots, {}, &world::TrackedRobot::id);
  for (const auto& [tick, touch] : touches_) {
    if (tick == tick_) frame.touches.push_back(touch);
  }
  return frame;
}

// The cameras take their images during the tick that ends now; what moved did so evenly.
void Story::look(std::int64_t tick) {
  cameras_->begin_tick();
  std::vector<truth::Robot> robots;
  for (int substep = 1; substep <= world::substeps_per_tick; ++substep) {
    if (!cameras_->captures_after(substep)) continue;
    const double share = static_cast<double>(substep) / world::substeps_per_tick;
    robots.clear();
    for (const Robot& robot : robots_) {
      truth::Robot its;
      its.id = seen(robot.id);
      its.position = turned(robot.before + (robot.place - robot.before) * share);
      its.orientation = world::angle_of(turned(robot.heading));
      robots.push_back(its);
    }
    std::ranges::sort(robots, {}, &truth::Robot::id);
    truth::Ball ball;
    ball.position.head<2>() = turned(ball_before_ + (ball_ - ball_before_) * share);
    ball.position.z() = height_before_ + (height_ - height_before_) * share + 0.0215;
    cameras_->capture(substep, world::tick_time(tick - 1, substep), ball, robots);
  }
}

referee::Output Story::show() {
  if (!cameras_) return referee_.update(frame());
  look(tick_);
  return referee_.update(cameras_->delivered());
}

// Another set of detectors looks at what the referee looked at.
void Story::watch(const world::GameState& before) {
  if (referee_.frame().time != referee_.state().time) return;
  world::GameState as_the_tick_began = before;
  as_the_tick_began.time = referee_.state().time;
  for (const world::GameEvent& event : watchers_.update(referee_.frame(), as_the_tick_began)) {
    seen_kinds_.insert(referee::kind_of(event));
  }
  if (referee_.state().location != before.location) watchers_.enter(referee_.state().location);
}

bool Story::saw(const std::string& kind) { return seen_kinds_.erase(kind) > 0; }

void Story::host(const referee::Output& output) {
  if (output.ball_reset && !reset_ && host_places_ball_)
    reset_ = {tick_ + world::ticks_per_second / 2, turned(*output.ball_reset)};
  if (reset_ && reset_->first <= tick_) {
    put_ball(reset_->second);
    reset_.reset();
    if (robots_go_home_) {
      for (Robot& robot : robots_) robot.place = home(robot.id);
    }
  }
}

void Story::tick() {
  ++tick_;
  const world::GameState before = state();
  const referee::Output output = show();
  watch(before);
  ball_before_ = ball_;
  height_before_ = height_;
  for (Robot& robot : robots_) robot.before = robot.place;
  for (const referee::Call& call : output.calls) {
    calls_.push_back(call);
    if (!call.command) continue;
    std::string text = world::name(call.command->kind);
    if (world::has_team(call.command->kind)) {
      text += std::string("(") + world::name(seen(call.command->team)) + ")";
    }
    commands_.push_back(text);
  }
  for (const referee::TransitionRecord& record : referee_.transitions()) {
    if (record.row != "T14") rows_.emplace_back(record.row);
  }
  host(output);
}

void Story::skip(double seconds) { tick_ += std::lround(seconds * world::ticks_per_second); }

void Story::wait(double seconds) {
  const long ticks = std::lround(seconds * world::ticks_per_second);
  for (long i = 0; i < ticks; ++i) tick();
}

bool Story::wait_for(Location location, double limit) {
  for (double end = now() + limit; now() < end;) {
    if (state().location == location) return true;
    tick();
  }
  return state().location == location;
}

void Story::put(world::RobotId id, Vector2d place) { robot(id).place = place; }

void Story::put_ball(Vector2d place) { ball_ = ball_before_ = place; }

void Story::roll(Vector2d to, double speed) {
  const double step = speed / world::ticks_per_second;
  while ((to - ball_).norm() > step) {
    ball_ += (to - ball_).normalized() * step;
    tick();
  }
  ball_ = to;
  tick();
}

void Story::kick(world::RobotId id, Vector2d to, double speed) {
  const Vector2d way = (to - ball_).normalized();
  robot(id).heading = way;
  if (harsh()) {  // it does not drive behind the ball: the filter needs a while to believe that it is there
    put(id, ball_ - way * (at_dribbler + 0.2));
    wait(0.6);
    drive({{id, ball_ - way * at_dribbler, 1.0}});
  }
  put(id, ball_ - way * at_dribbler);
  robot(id).ball_in_reach = true;
  tick();
  touch(id);
  robot(id).ball_in_reach = false;
  roll(to, speed);
}

void Story::dribble(world::RobotId id, Vector2d to, double speed) {
  Robot& dribbler = robot(id);
  const Vector2d way = (to - ball_).normalized();
  const double step = speed / world::ticks_per_second;
  dribbler.heading = way;
  dribbler.ball_in_reach = true;
  while ((to - ball_).norm() > step) {
    ball_ += way * step;
    dribbler.place = ball_ - way * at_dribbler;
    touch(id);
    tick();
  }
  dribbler.ball_in_reach = false;
}

void Story::chip(world::RobotId id, Vector2d to, double height, double speed) {
  const Vector2d from = ball_;
  put(id, ball_ - (to - ball_).normalized() * at_dribbler);
  tick();
  touch(id);
  flight_.emplace();
  flight_->kicked = world::tick_time(tick_);
  flight_->from = from;
  const long ticks = std::lround((to - from).norm() / speed * world::ticks_per_second);
  for (long i = 1; i <= ticks; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(ticks);
    ball_ = from + (to - from) * share;
    height_ = 4 * height * share * (1 - share);
    flight_->highest = std::max(flight_->highest, height_);
    if (i == ticks) flight_.reset();
    tick();
  }
}

void Story::drive(std::vector<Drive> drives) {
  bool driving = true;
  while (driving) {
    driving = false;
    for (const Drive& drive : drives) {
      Robot& its = robot(drive.robot);
      const Vector2d left = drive.to - its.place;
      const double step = drive.speed / world::ticks_per_second;
      if (left.norm() <= step) {
        its.place = drive.to;
        its.velocity.setZero();
        continue;
      }
      driving = true;
      its.place += left.normalized() * step;
      its.velocity = left.normalized() * drive.speed;
    }
    tick();
  }
}

void Story::touch(world::RobotId id) {
  touches_.emplace_back(tick_ + 3, world::Touch{seen(id), world::tick_time(tick_ + 1), turned(ball_), 1.0});
}

void Story::begin() {
  wait_for(Location::Setup);
  kick(yellow(1), {0.5, 0}, 2.0);
  put(yellow(1), home(yellow(1)));
  touch(yellow(2));
  wait(0.1);
}

std::string Story::commands() { return joined(commands_); }
std::string Story::rows() { return joined(rows_); }

}  // namespace scenarios
