#include "sim/wire/vision_packet.h"

namespace wire {

void encode_packet(const world::Detection& detection, Epoch epoch, std::string& out) {
  thread_local proto::SSL_WrapperPacket packet;  // keeps its memory
  packet.set_source(proto::SSL_SOURCE_OTHER);
  packet.clear_geometry();
  encode(detection, epoch, *packet.mutable_detection());
  while (packet.ByteSizeLong() > max_datagram_size && packet.detection().balls_size() > 0) {
    packet.mutable_detection()->mutable_balls()->RemoveLast();
  }
  out.clear();
  packet.AppendPartialToString(&out);
}

void encode_packet(const world::Geometry& geometry, std::string& out) {
  proto::SSL_WrapperPacket packet;
  packet.set_source(proto::SSL_SOURCE_OTHER);
  encode(geometry, *packet.mutable_geometry());
  out.clear();
  packet.AppendPartialToString(&out);
}

}  // namespace wire
