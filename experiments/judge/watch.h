#pragma once

#include <deque>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/judge/game.h"
#include "experiments/judge/laws/laws.h"
#include "experiments/judge/net/net_shadow.h"
#include "experiments/judge/shadow.h"
#include "experiments/judge/snippet.h"
#include "experiments/judge/timeline.h"
#include "experiments/judge/witness.h"
#include "sim/vision/cameras.h"

namespace judge {

/// One game while it is judged: laws, acting referee, shadows and witnesses on the same ticks.
class Watch {
 public:
  Watch(const record::MatchConfig& config, const std::vector<ShadowConfig>& shadows);

  /// Shadows with cameras of their own look at this world.
  void start(engine::Engine& engine);

  /// What a tick shows.
  struct Seen {
    const truth::Frame& truth;
    std::span<const world::Detection> images;  ///< delivered in this tick
    const world::TrackedFrame& frame;          ///< of the acting referee, with its touches
    const world::GameState& state;             ///< of the acting referee after it
  };
  void tick(const Seen& seen);
  /// The same of a game that is being played; also shown to outside autorefs, and kept.
  void tick(const engine::Engine& engine, const referee::Referee& referee);

  /// Why an outside autoref could not go on; empty: it could.
  const std::string& failure() const { return failure_; }

  /// From now on a passage is kept.
  void keep(const Passage& passage);
  /// @return the cases in it
  std::vector<Case> save(const std::string& game);

  /// One line: the exact ball, who touches it, and what the referee sees of it.
  void tell(const Seen& seen, std::ostream& out) const;
  /// What the laws and the referee's detectors say of the passage.
  void tell_events(const Passage& passage) const;

  /// The game is over.
  void finish(GameResult& result);

 private:
  /// Shadows with cameras of their own.
  struct Onlooker {
    std::unique_ptr<vision::Cameras> cameras;  // null: the game's
    std::unique_ptr<Shadow> shadow;
  };
  struct Sighting {
    world::Time time;
    world::Vector2d place;
  };

  void judge_until(world::Time time);
  bool flew(const Call& call) const;

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

}  // namespace judge
