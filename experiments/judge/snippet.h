#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "autoref/referee/referee.h"
#include "experiments/judge/event.h"
#include "experiments/judge/pairing.h"
#include "experiments/judge/timeline.h"
#include "experiments/judge/true_event.h"
#include "sim/engine/engine.h"
#include "sim/world/game_state.h"
#include "sim/world/time.h"

namespace judge {

/// A few seconds of a judged game that can be looked at again without it: a recorded scenario.
///
/// Two files: NAME.log.gz, a league log with every image as it was delivered, the geometry and the acting
/// referee's messages; and NAME.json, this: what is true, and in which states the acting referee was, so that
/// a shadow sees the passage in the very states in which it was judged.
struct Snippet {
  std::string game;                ///< DESIGN GAME:FIRST-LAST
  std::string rules;               ///< name of the rule set
  world::Time from, to;            ///< only what is true or called in between is compared
  std::vector<Event> events;       ///< and only these
  std::vector<TrueEvent> truth{};  ///< of the passage
  struct State {
    world::Time until;  ///< time of the last frame judged in it
    world::GameState state;
  };
  std::vector<State> states{};         ///< of the acting referee, in order of time
  std::vector<world::Time> by_hand{};  ///< frames before which the ball was put somewhere

  /// The states, for Shadow::see.
  Timeline timeline() const;
  /// Truth and calls compared, within the passage and the events asked for.
  std::vector<Case> judge(const std::vector<Call>& calls) const;
};

/// The files that belong together, from the name of either, or what they have in common.
std::filesystem::path log_of(const std::filesystem::path& snippet);
std::filesystem::path expectation_of(const std::filesystem::path& snippet);

std::string to_json(const Snippet& snippet);
/// @throws std::invalid_argument naming the file
Snippet read_snippet(const std::filesystem::path& file);

/// Writes a snippet while the game is played.
class SnippetWriter {
 public:
  /// How much of the passage's beginning the filters may use up, and how late a call may come at its end.
  static constexpr world::Duration warm_up = std::chrono::milliseconds{500};
  static constexpr world::Duration run_out = std::chrono::milliseconds{400};

  /// @param first, last  ticks
  SnippetWriter(std::filesystem::path file, std::string rules, std::int64_t first, std::int64_t last);
  ~SnippetWriter();

  /// A tick, after the acting referee has seen it.
  void tick(const engine::Engine& engine, const referee::Referee& referee);
  /// A frame of the acting referee, and the state in which it was judged.
  void frame(world::Time time, const world::GameState& state, bool by_hand);
  /// Writes both files, once the truth is known.
  ///
  /// @param calls  of the acting referee's detectors: what they said and what is true is compared later
  /// @return the cases of the passage
  /// @throws std::runtime_error naming the file; std::invalid_argument when the game ended before
  std::vector<Case> close(const std::string& game, const std::vector<TrueEvent>& truth,
                          const std::vector<Call>& calls);

 private:
  struct Log;
  std::filesystem::path file_;
  std::int64_t first_, last_;
  bool complete_ = false;
  Snippet snippet_;
  std::string state_;  // the last one, as text
  std::unique_ptr<Log> log_;
};

}  // namespace judge
