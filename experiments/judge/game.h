#pragma once

#include <array>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "experiments/host/play.h"
#include "experiments/judge/pairing.h"
#include "experiments/judge/witness.h"
#include "experiments/record/match_config.h"

namespace judge {

/// A referee that is compared: which rules, and which eyes.
struct ShadowConfig {
  std::string name;
  std::string rules;                        ///< name of a rule set; empty: the game's
  std::map<std::string, double> realism{};  ///< numbers of its cameras that differ, as "vision.ball_sigma"
  std::optional<world::TouchAlgorithms> touch{};  ///< instead of the rule set's
  std::optional<int> exit_frames{};               ///< instead of the rule set's
  std::string command{};                          ///< an outside autoref, for the shell; empty: ours
  double net_speed = 1;                           ///< its pace, in real times
};

/// The first is always the acting referee's own detectors, on its own frames.
inline constexpr const char* acting_name = "ours";

/// Reads one of these; the text becomes the shadow's name:
///
///   rules=paper                    parts of a shadow
///   touch=accel+line,exit_frames=5
///   vision.ball_sigma=0.002
///   net:COMMAND                    an outside autoref
///   net@4:COMMAND                  the same, at four times the real pace
///
/// @throws std::invalid_argument naming the part and what would be right
ShadowConfig parse_shadow(const std::string& text);

/// The sweeps of the study: noise 0 to 5 mm, missed detections 0 to 10 %, latency, camera offset.
std::vector<ShadowConfig> sweeps();

/// What one game gave.
struct GameResult {
  std::string game;    ///< its name in the schedule
  std::string preset;  ///< realism
  std::uint64_t seed = 0;
  std::int64_t ticks = 0;
  std::string hash;                    ///< of the game
  std::string fault;                   ///< why it did not end; empty: it did
  std::vector<std::string> shadows;    ///< names
  std::vector<std::string> witnesses;  ///< names, as in Call::witnesses of the first shadow
  std::vector<Case> cases;
  std::array<int, event_count> happened{};     ///< true events beyond their band
  std::array<int, event_count> close{};        ///< within it, on both sides of the limit
  std::array<int, event_count> near_misses{};  ///< lawful, within two bands
  std::vector<TouchCount> touches;
};

/// A passage to be told tick by tick.
struct Passage {
  std::int64_t first = 0, last = -1;  ///< ticks
  std::ostream* out = nullptr;
  std::filesystem::path save{};  ///< and to be written as a Snippet; empty: it is not
  bool holds(std::int64_t tick) const { return tick >= first && tick <= last; }
};

/// A game to be judged.
struct Job {
  std::string game;  ///< its name in the schedule
  record::MatchConfig config;
  std::vector<ShadowConfig> shadows;
  std::filesystem::path keep{};   ///< where it is recorded, see RecordingWriter; empty: nowhere
  std::filesystem::path again{};  ///< the recording from which it is judged again; empty: it is played
};

/// Plays the game, judged by its rule set, with all shadows looking on.
///
/// A configuration with a recording to continue replays that, without teams.
/// @throws std::invalid_argument for an unknown rule set or key
GameResult play_judged(const Job& job, const host::Options& options = {}, const Passage& passage = {});

/// Judges a recorded game with the detectors of today, in the states in which the acting referee was when it
/// was played: in a tenth of the time.
///
/// @throws std::invalid_argument for a file that is none, or a shadow whose eyes were not recorded
GameResult judge_again(const std::filesystem::path& recording, const std::vector<ShadowConfig>& shadows,
                       const Passage& passage = {});

}  // namespace judge
