#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "sim/proto/referee.pb.h"
#include "sim/wire/epoch.h"
#include "sim/world/detection.h"
#include "sim/world/field.h"
#include "sim/world/referee_message.h"

namespace autoref {

/// What one must know of a league log before its first frame can be refereed.
struct Survey {
  std::optional<world::Geometry> geometry;                  ///< the first one
  std::optional<matchday::referee::Referee> first_referee;  ///< the first one
  bool has_vision_2014 = false;                             ///< then records of type 2 are to be left alone
  bool has_vision = false;
  wire::Epoch epoch;  ///< match time zero: that of our games, or the first image's second

  /// Written by our host, so that the referee can be run again from its first frame.
  bool ours() const { return first_referee && first_referee->source_identifier() == "matchday"; }
};

/// Reads as much of the log as it takes, at most all of it. Damage is left for `read_log` to find.
///
/// @throws std::runtime_error when the file cannot be opened or is no league log
Survey survey_log(const std::filesystem::path& path);

struct CameraCount {
  std::int64_t images = 0;
  world::Time first;
  world::Time last;
};

/// What a log held.
struct LogCount {
  std::map<std::int32_t, std::int64_t> records;  ///< by type, the first 32 types
  std::int64_t records_of_other_types = 0;
  std::map<int, CameraCount> cameras;
  std::int64_t referee_messages_unknown = 0;  ///< with a stage or command that nobody knows
  std::string defect;  ///< one sentence naming file and record; empty when all could be read
};

/// Who hears what a log tells, in its order.
struct Listener {
  /// A message, before the batch that was complete when it was recorded.
  std::function<void(const world::RefereeMessage&)> message;
  /// All images of one tick.
  std::function<void(std::span<const world::Detection>)> batch;
  /// A geometry message; of some set-ups each tells of one camera only.
  std::function<void(const world::Geometry&)> geometry;
};

/// Plays the whole log. Stops at a damaged record; the count then says where.
///
/// A batch ends when a camera reports again, in logs of ours also when the time of the record changes: there
/// all images of a tick are recorded at one instant.
LogCount read_log(const std::filesystem::path& path, const Survey& survey, const Listener& listener);

}  // namespace autoref
