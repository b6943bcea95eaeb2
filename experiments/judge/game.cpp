#include "experiments/judge/game.h"

#include <algorithm>
#include <charconv>
#include <deque>
#include <memory>
#include <stdexcept>
#include <utility>

#include "experiments/host/match.h"
#include "experiments/judge/laws/laws.h"
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
    before_ = referee.state();
  }

  void finish(GameResult& result) {
    const std::vector<TrueEvent>& truth = laws_.events();
    for (const TrueEvent& event : truth) {
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
  Timeline timeline_;
  std::deque<truth::Frame> truths_;  // not yet judged
  std::deque<Sighting> seen_;        // balls, lately
  std::vector<float> heights_;       // [m] the ball's centre, by tick
  world::GameState before_;          // of the acting referee when the tick began
  world::Time last_frame_;
  bool by_hand_ = false;
};

}  // namespace

GameResult play_judged(const std::string& game, const record::MatchConfig& config,
                       const std::vector<ShadowConfig>& shadows, const host::Options& options) {
  Watch watch(config, shadows);
  host::Options with_watch = options;
  with_watch.on_start = [&](engine::Engine& engine) { watch.start(engine); };
  with_watch.on_tick = [&](const engine::Engine& engine, const referee::Referee& referee) {
    watch.tick(engine, referee);
  };
  const record::MatchRecord record = host::play(config, with_watch);

  GameResult result;
  result.game = game;
  result.preset = config.realism.preset;
  result.seed = config.seed;
  result.ticks = record.ticks;
  result.hash = record.hash;
  if (record.at_fault != record::Party::Nobody) result.fault = record.reason;
  watch.finish(result);
  return result;
}

}  // namespace judge
