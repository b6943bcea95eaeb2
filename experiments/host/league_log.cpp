#include "experiments/host/league_log.h"

namespace host {
namespace {

std::int64_t receive_time(world::Time time) {
  return wire::Epoch{}.nanoseconds + time.time_since_epoch().count();
}

}  // namespace

LeagueLog::LeagueLog(const std::filesystem::path& path, const world::Geometry& geometry,
                     const wire::proto::Referee& first)
    : writer_(path) {
  wire::proto::SSL_WrapperPacket packet;
  wire::encode(geometry, *packet.mutable_geometry());
  writer_.write(receive_time(world::Time{}), wire::Vision2014, packet);
  writer_.write(receive_time(world::Time{}), wire::Refbox2013, first);
}

void LeagueLog::add(world::Time now,
                    const google::protobuf::RepeatedPtrField<wire::proto::SSL_WrapperPacket>& packets,
                    const wire::proto::Referee* referee) {
  for (const wire::proto::SSL_WrapperPacket& packet : packets)
    writer_.write(receive_time(now), wire::Vision2014, packet);
  if (referee != nullptr) writer_.write(receive_time(now), wire::Refbox2013, *referee);
}

}  // namespace host
