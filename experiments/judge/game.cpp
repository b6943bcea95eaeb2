#include "experiments/judge/game.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <deque>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "experiments/host/match.h"
#include "experiments/judge/failures.h"
#include "experiments/judge/laws/laws.h"
#include "experiments/judge/net/net_shadow.h"
#include "experiments/judge/net/reported.h"
#include "experiments/judge/snippet.h"
#include "sim/engine/realism.h"
#include "sim/vision/cameras.h"

namespace judge {
namespace {

constexpr double near_ball = 0.3;  // [m] a detection that is the ball
constexpr double in_air = 0.02;    // [m] of the ball's lowest point: a chip
constexpr double touch_windows[] = {0.1, 0.3};

/// Shadows with cameras of their own.
struct Onlooker {
  std::unique_ptr<vision::Cameras> cameras;  // null: the game's
  std::unique_ptr<Shadow> shadow;
};

world::RuleSet rules_of(const ShadowConfig& config, const record::MatchConfig& game) {
  record::MatchConfig its = game;
  if (!config.rules.empty()) its.rules = config.rules;
  world::RuleSet rules = host::rules_of(its);
  if (config.touch) rules.touch = *config.touch;
  if (config.exit_frames) rules.exit_frames = *config.exit_frames;
  return rules;
}

/// One game while it is watched.
class Watch {
 public:
  Watch(const record::MatchConfig& config, const std::vector<ShadowConfig>& shadows)
      : model_(host::model_of(config)),
        rules_(host::rules_of(config)),
        laws_(rules_, bands_of(config.realism.preset)),
        witnesses_(all_witnesses(model_.geometry.field)),
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
        one.cameras =
            std::make_unique<vision::Cameras>(model_.geometry, eyes.vision, config.seed, eyes.robots);
      }
      one.shadow = std::make_unique<Shadow>(shadow.name, model_.geometry, rules_of(shadow, config));
      onlookers_.push_back(std::move(one));
    }
  }

  void start(engine::Engine& engine) {
    for (Onlooker& one : onlookers_) {
      if (one.cameras) engine.also_seen_by(*one.cameras);
    }
  }

  void tick(const engine::Engine& engine, const referee::Referee& referee) {
    truths_.push_back(engine.truth());
    heights_.push_back(static_cast<float>(engine.truth().ball.position.z()));
    const auto images = engine.detections();
    for (const world::Detection& image : images) {
      for (const world::DetectedBall& ball : image.balls) seen_.push_back({image.t_capture, ball.position});
    }
    const world::TrackedFrame& frame = referee.frame();
    const bool fresh = frame.time > last_frame_;
    if (fresh) {
      last_frame_ = frame.time;
      timeline_.add(frame.time, before_);
      judge_until(frame.time);
      if (snippet_) snippet_->frame(frame.time, timeline_.at(frame.time), by_hand_);
      const world::GameState& state = timeline_.at(frame.time);
      for (Witness& witness : witnesses_) witness.see(frame, images, state);
      ours_.see(frame, state, by_hand_);
      for (Call& call : ours_.fresh()) {
        if (call.event != Event::Exit) continue;
        for (const Witness& witness : witnesses_) call.witnesses.push_back(witness.last());
      }
    }
    if (!timeline_.empty()) {
      for (Onlooker& one : onlookers_) {
        one.shadow->see(one.cameras ? one.cameras->delivered() : images, timeline_, by_hand_);
      }
    }
    for (NetShadow& one : outside_) {
      if (!failure_.empty()) break;
      try {
        one.tick(engine, referee);
      } catch (const std::runtime_error& error) {
        failure_ = error.what();
      }
    }
    if (snippet_) snippet_->tick(engine, referee);
    before_ = referee.state();
  }

  /// Why an outside autoref could not go on; empty: it could.
  const std::string& failure() const { return failure_; }

  /// From now on a passage is kept.
  void keep(const Passage& passage) {
    snippet_.emplace(passage.save, rules_.name, passage.first, passage.last);
  }
  /// @return the cases in it
  std::vector<Case> save(const std::string& game) {
    return snippet_->close(game, laws_.events(), ours_.calls());
  }

  void end() {
    laws_.finish();
    for (NetShadow& one : outside_) one.end();
  }

  /// One line: the exact ball, who touches it, and what the referee sees of it.
  void tell(const engine::Engine& engine, const referee::Referee& referee, std::ostream& out) const {
    const truth::Frame& truth = engine.truth();
    out << fmt::format("{:6} {:8.3f} s  {:7} ball ({:7.3f}, {:7.3f}, {:6.3f}) m {:5.2f} m/s", truth.tick,
                       world::seconds(truth.time), world::name(referee.state().location),
                       truth.ball.position.x(), truth.ball.position.y(), truth.ball.position.z(),
                       truth.ball.velocity.norm());
    if (const auto& ball = referee.frame().ball) {
      out << fmt::format("  {} ({:7.3f}, {:7.3f}, {:6.3f}) {:5.2f} m/s at {:.3f} s",
                         ball->observed ? "seen" : "lost", ball->position.x(), ball->position.y(),
                         ball->position.z(), ball->velocity.norm(), world::seconds(referee.frame().time));
    }
    const auto who = [](world::RobotId id) { return fmt::format("{} {}", world::name(id.team), id.number); };
    for (const truth::Robot& robot : truth.robots) {
      const double distance =
          (robot.position - truth.ball.position.head<2>()).norm() - model_.geometry.field.robot_radius;
      if (distance < 0.6) out << fmt::format("  {} {:.3f} m", who(robot.id), distance);
    }
    for (const truth::Contact& contact : truth.contacts) {
      out << fmt::format("  {} touches {:.1f} mN s", who(contact.robot), 1000 * contact.impulse);
    }
    for (const truth::Kick& kick : truth.kicks) {
      out << fmt::format("  {} kicks {:.2f} m/s", who(kick.robot), kick.velocity.norm());
    }
    if (referee.frame().time == last_frame_) {
      for (const world::Touch& touch : referee.frame().touches) {
        out << fmt::format("  {} told to touch at {:.3f} s ({:.2f})", who(touch.robot),
                           world::seconds(touch.time), touch.probability);
      }
    }
    out << "\n";
  }

  /// What the laws and the referee's detectors say of the passage.
  void tell_events(const Passage& passage) const {
    const auto inside = [&](world::Time time) {
      const double tick = world::seconds(time) * world::ticks_per_second;
      return tick >= static_cast<double>(passage.first) && tick <= static_cast<double>(passage.last);
    };
    for (const TrueEvent& event : laws_.events()) {
      if (!inside(event.time)) continue;
      *passage.out << fmt::format("truth: {} at {:.3f} s, {:.3f}, margin {:.2f}{}\n",
                                  judge::name(event.event), world::seconds(event.time), event.value,
                                  event.margin, event.ambiguous ? ", ambiguous" : "");
    }
    for (const Call& call : ours_.calls()) {
      if (!inside(call.time)) continue;
      *passage.out << fmt::format("call: {} at {:.3f} s, reported at {:.3f} s\n", judge::name(call.event),
                                  world::seconds(call.time), world::seconds(call.reported));
    }
  }

  void finish(GameResult& result) {
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

 private:
  /// The laws look at what the acting referee has seen by now, in the state in which it saw it.
  void judge_until(world::Time time) {
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

  bool flew(const Call& call) const {
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

  struct Sighting {
    world::Time time;
    world::Vector2d place;
  };

  engine::Model model_;
  world::RuleSet rules_;
  Laws laws_;
  std::vector<Witness> witnesses_;
  Shadow ours_;
  std::vector<Onlooker> onlookers_;
  std::vector<NetShadow> outside_;
  Timeline timeline_;
  std::deque<truth::Frame> truths_;  // not yet judged
  std::deque<Sighting> seen_;        // balls, lately
  std::vector<float> heights_;       // [m] the ball's centre, by tick
  std::string failure_;
  std::optional<SnippetWriter> snippet_;
  world::GameState before_;  // of the acting referee when the tick began
  world::Time last_frame_;
  bool by_hand_ = false;
};

}  // namespace

GameResult play_judged(const std::string& game, const record::MatchConfig& config,
                       const std::vector<ShadowConfig>& shadows, const host::Options& options,
                       const Passage& passage) {
  Watch watch(config, shadows);
  if (!passage.save.empty()) watch.keep(passage);
  host::Options with_watch = options;
  with_watch.on_start = [&](engine::Engine& engine) { watch.start(engine); };
  with_watch.on_tick = [&](const engine::Engine& engine, const referee::Referee& referee) {
    watch.tick(engine, referee);
    if (engine.tick() >= passage.first && engine.tick() <= passage.last) {
      watch.tell(engine, referee, *passage.out);
    }
  };
  with_watch.interrupted = [&] {
    return !watch.failure().empty() || (options.interrupted && options.interrupted());
  };
  const record::MatchRecord record = host::play(config, with_watch);

  GameResult result;
  result.game = game;
  result.preset = config.realism.preset;
  result.seed = config.seed;
  result.ticks = record.ticks;
  result.hash = record.hash;
  if (record.at_fault != record::Party::Nobody) result.fault = record.reason;
  if (!watch.failure().empty()) result.fault = watch.failure();
  watch.end();
  watch.finish(result);
  if (passage.out != nullptr) watch.tell_events(passage);
  if (!passage.save.empty()) {
    for (const Case& one : watch.save(game)) {
      *passage.out << fmt::format("kept: {}, {}; {}\n", judge::name(one.event), judge::name(one.result),
                                  sentence(one));
    }
  }
  return result;
}

}  // namespace judge
