#include "sim/wire/log_messages.h"

namespace wire {

namespace {

bool read_as(LogType type, const LogRecord& record, google::protobuf::MessageLite& out) {
  return record.type == type && out.ParsePartialFromString(record.payload);
}

}  // namespace

bool read(const LogRecord& record, matchday::vision::SSL_WrapperPacket& out) {
  return read_as(Vision2014, record, out);
}
bool read(const LogRecord& record, matchday::referee::Referee& out) {
  return read_as(Refbox2013, record, out);
}
bool read(const LogRecord& record, matchday::tracker::TrackerWrapperPacket& out) {
  return read_as(Tracker2020, record, out);
}

}  // namespace wire
