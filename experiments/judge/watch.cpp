#include "experiments/judge/watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "experiments/host/match.h"
#include "experiments/judge/failures.h"
#include "experiments/judge/net/reported.h"
#include "sim/engine/realism.h"

namespace judge {
namespace {

constexpr double near_ball = 0.3;  // [m] a detection that is the ball
constexpr double in_air = 0.02;    // [m] of the ball's lowest point: a chip
constexpr double touch_windows[] = {0.1, 0.3};

world::RuleSet rules_of(const ShadowConfig& config, const record::MatchConfig& game) {
  record::MatchConfig its = game;
  if (!config.rules.empty()) its.rules = config.rules;
  world::RuleSet rules = host::rules_of(its);
  if (config.touch) rules.touch = *config.touch;
  if (config.exit_frames) rules.exit_frames = *config.exit_frames;
  return rules;
}

}  // namespace

Watch::Watch(const record::MatchConfig& config, const std::vector<ShadowConfig>& shadows)
    : model_(host::model_of(config)),
      rules_(host::rules_of(config)),
      laws_(rules_, bands_of(config.realism.preset)),
      witnesses_(all_witnesses(model_.geometry)),
      ours_(acting_name, model_.geometry, rules_) {
  for (const ShadowConfig& shadow : shadows) {
    if (!shadow.command.empty()) {
      outside_.emplace_back(shadow.name, shadow.command, shadow.net_speed, model_.geometry, rules_);
      continue;
    }
    Onlooker one;
    if (!shadow.realism.empty()) {
      record::RealismConfig realism = config.realism;
      for (const auto& [key, value] : shadow.realism) realism.changes[key] = value;
      const engine::Realism eyes = host::realism_of(realism);
      one.cameras = std::make_unique<vision::Cameras>(model_.geometry, eyes.vision, config.seed, eyes.robots);
    }
    one.shadow = std::make_unique<Shadow>(shadow.name, model_.geometry, rules_of(shadow, config));
    onlookers_.push_back(std::move(one));
  }
}

void Watch::start(engine::Engine& engine) {
  for (Onlooker& one : onlookers_) {
    if (one.cameras) engine.also_seen_by(*one.cameras);
  }
}

void Watch::tick(const Seen& seen) {
  truths_.push_back(seen.truth);
  heights_.push_back(static_cast<float>(seen.truth.ball.position.z()));
  for (const world::Detection& image : seen.images) {
    for (const world::DetectedBall& ball : image.balls) seen_.push_back({image.t_capture, ball.position});
  }
  const world::TrackedFrame& frame = seen.frame;
  const bool fresh = frame.time > last_frame_;
  if (fresh) {
    last_frame_ = frame.time;
    timeline_.add(frame.time, before_);
    judge_until(frame.time);
    const world::GameState& state = timeline_.at(frame.time);
    if (snippet_) snippet_->frame(frame.time, state, by_hand_);
    for (Witness& witness : witnesses_) witness.see(frame, seen.images, state);
    ours_.see(frame, state, by_hand_);
    for (Call& call : ours_.fresh()) {
      if (call.event != Event::Exit) continue;
      for (const Witness& witness : witnesses_) call.witnesses.push_back(witness.last());
    }
  }
  if (!timeline_.empty()) {
    for (Onlooker& one : onlookers_) {
      one.shadow->see(one.cameras ? one.cameras->delivered() : seen.images, timeline_, by_hand_);
    }
  }
  before_ = seen.state;
}

void Watch::tick(const engine::Engine& engine, const referee::Referee& referee) {
  tick({engine.truth(), engine.detections(), referee.frame(), referee.state()});
  for (NetShadow& one : outside_) {
    if (!failure_.empty()) break;
    try {
      one.tick(engine, referee);
    } catch (const std::runtime_error& error) {
      failure_ = error.what();
    }
  }
  if (snippet_) snippet_->tick(engine, referee);
}

void Watch::keep(const Passage& passage) {
  snippet_.emplace(passage.save, rules_.name, passage.first, passage.last);
}
std::vector<Case> Watch::save(const std::string& game) {
  return snippet_->close(game, laws_.events(), ours_.calls());
}

void Watch::tell(const Seen& seen, std::ostream& out) const {
  const truth::Frame& truth = seen.truth;
  out << fmt::format("{:6} {:8.3f} s  {:7} ball ({:7.3f}, {:7.3f}, {:6.3f}) m {:5.2f} m/s", truth.tick,
                     world::seconds(truth.time), world::name(seen.state.location), truth.ball.position.x(),
                     truth.ball.position.y(), truth.ball.position.z(), truth.ball.velocity.norm());
  if (const auto& ball = seen.frame.ball) {
    out << fmt::format("  {} ({:7.3f}, {:7.3f}, {:6.3f}) {:5.2f} m/s at {:.3f} s",
                       ball->observed ? "seen" : "lost", ball->position.x(), ball->position.y(),
                       ball->position.z(), ball->velocity.norm(), world::seconds(seen.frame.time));
  }
  const auto who = [](world::RobotId id) { return fmt::format("{} {}", world::name(id.team), id.number); };
  for (const truth::Robot& robot : truth.robots) {
    const double distance =
        (robot.position - truth.ball.position.head<2>()).norm() - model_.geometry.field.robot_radius;
    if (distance < 0.6) out << fmt::format("  {} {:.3f} m", who(robot.id), distance);
  }
  for (const truth::Robot& robot : truth.robots) {
    double impulse = 0;
    for (const truth::Contact& contact : truth.contacts) {
      if (contact.robot == robot.id) impulse += contact.impulse;
    }
    if (impulse > 0) out << fmt::format("  {} touches {:.1f} mN s", who(robot.id), 1000 * impulse);
  }
  for (const truth::Kick& kick : truth.kicks) {
    out << fmt::format("  {} kicks {:.2f} m/s", who(kick.robot), kick.velocity.norm());
  }
  if (seen.frame.time == last_frame_) {
    for (const world::Touch& touch : seen.frame.touches) {
      out << fmt::format("  {} told to touch at {:.3f} s ({:.2f})", who(touch.robot),
                         world::seconds(touch.time), touch.probability);
    }
  }
  out << "\n";
}

void Watch::tell_events(const Passage& passage) const {
  const auto inside = [&](world::Time time) {
    const double tick = world::seconds(time) * world::ticks_per_second;
    return tick >= static_cast<double>(passage.first) && tick <= static_cast<double>(passage.last);
  };
  for (const Case& one : pair(ours_.name(), laws_.events(), ours_.calls(), ours_.rules())) {
    if (!(one.truth && inside(one.truth->time)) && !(one.call && inside(one.call->time))) continue;
    const char* const doubt = one.ambiguous() ? " (ambiguous)" : one.close() ? " (close)" : "";
    const bool wrong_team = one.event == Event::Exit && one.result == Result::Found && !one.team_is_right();
    *passage.out << fmt::format("{}: {}{}; {}\n", judge::name(one.event),
                                wrong_team ? "last touch wrong" : judge::name(one.result), doubt,
                                sentence(one));
  }
}

void Watch::finish(GameResult& result) {
  laws_.finish();
  for (NetShadow& one : outside_) one.end();
  const std::vector<TrueEvent>& truth = laws_.events();
  for (const TrueEvent& event : truth) {
    if (event.late) continue;
    const auto n = static_cast<std::size_t>(event.event);
    if (event.margin >= 1) ++result.happened[n];
    if (event.close()) ++result.close[n];
    if (!event.happened()) ++result.near_misses[n];
  }
  result.shadows.push_back(ours_.name());
  result.cases = pair(ours_.name(), truth, ours_.calls(), ours_.rules());
  for (const Onlooker& one : onlookers_) {
    const Shadow& shadow = *one.shadow;
    result.shadows.push_back(shadow.name());
    const std::vector<Case> cases = pair(shadow.name(), truth, shadow.calls(), shadow.rules());
    result.cases.insert(result.cases.end(), cases.begin(), cases.end());
  }
  for (const NetShadow& shadow : outside_) {
    result.shadows.push_back(shadow.name());
    std::vector<Case> cases = pair(shadow.name(), truth, shadow.calls(), shadow.rules());
    std::erase_if(cases, [](const Case& one) { return !can_be_reported(one.event); });
    result.cases.insert(result.cases.end(), cases.begin(), cases.end());
  }
  for (Case& one : result.cases) one.chip = one.result == Result::Extra && flew(*one.call);
  for (const Witness& witness : witnesses_) {
    result.witnesses.push_back(witness.name());
    for (const double window : touch_windows) {
      result.touches.push_back(count_touches(laws_.touches().all(), witness, window));
    }
  }
}

// The laws look at what the acting referee has seen by now, in the state in which it saw it.
void Watch::judge_until(world::Time time) {
  by_hand_ = false;
  while (!truths_.empty() && truths_.front().time <= time) {
    const truth::Frame& frame = truths_.front();
    while (!seen_.empty() && seen_.front().time + 2 * one_tick < frame.time) seen_.pop_front();
    const bool seen = std::ranges::any_of(seen_, [&](const Sighting& ball) {
      return ball.time <= frame.time && (ball.place - frame.ball.position.head<2>()).norm() < near_ball;
    });
    laws_.watch(frame, timeline_.at(frame.time), seen);
    by_hand_ = by_hand_ || laws_.moved_by_hand();
    truths_.pop_front();
  }
}

bool Watch::flew(const Call& call) const {
  const auto tick = [&](world::Time time) {
    const double ticks = world::seconds(time) * world::ticks_per_second;
    return std::min(static_cast<std::size_t>(std::max(ticks, 0.0)), heights_.size());
  };
  const double radius = model_.geometry.field.ball_radius;
  const std::size_t end = tick(call.reported);
  for (std::size_t n = tick(call.time - std::chrono::milliseconds{100}); n < end; ++n) {
    if (heights_[n] - radius > in_air) return true;
  }
  return false;
}

}  // namespace judge
