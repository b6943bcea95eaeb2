#pragma once

#include "sim/proto/referee.pb.h"
#include "sim/proto/tracker.pb.h"
#include "sim/proto/vision.pb.h"
#include "sim/wire/log_file.h"

namespace wire {

/// Parses the payload of a Vision2014 record; false when it is of another type or not such a message.
bool read(const LogRecord& record, matchday::vision::SSL_WrapperPacket& out);
/// Parses the payload of a Refbox2013 record; false when it is of another type or not such a message.
bool read(const LogRecord& record, matchday::referee::Referee& out);
/// Parses the payload of a Tracker2020 record; false when it is of another type or not such a message.
bool read(const LogRecord& record, matchday::tracker::TrackerWrapperPacket& out);

}  // namespace wire
