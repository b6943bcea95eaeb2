#pragma once

#include <filesystem>
#include <span>

#include "sim/wire/log_file.h"
#include "sim/wire/match.h"
#include "sim/world/field.h"
#include "sim/world/time.h"

namespace host {

/// A game as a league log, as a recorder on the network would have written it.
///
/// First the geometry and the first referee message, then each detection when it is delivered, and the
/// referee message whenever it changes and ten times a second, the rate of the league's game controller.
class LeagueLog {
 public:
  /// @throws wire::OutputError naming the file
  LeagueLog(const std::filesystem::path& path, const world::Geometry& geometry,
            const wire::proto::Referee& first);

  /// One tick.
  /// @param packets   delivered in it
  /// @param referee   null when it need not be written
  void add(world::Time now, const google::protobuf::RepeatedPtrField<wire::proto::SSL_WrapperPacket>& packets,
           const wire::proto::Referee* referee);

  /// @throws wire::OutputError naming the file
  void close() { writer_.close(); }

 private:
  wire::LogWriter writer_;
};

}  // namespace host
