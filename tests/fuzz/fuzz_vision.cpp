#include "sim/proto/legacy2014.pb.h"
#include "sim/wire/vision.h"
#include "sim/wire/vision_packet.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

namespace {

constexpr std::size_t most_objects = 1024;  // far beyond the limits of the decoder

void check(const world::Detection& image) {
  if (image.balls.size() > most_objects || image.robots.size() > most_objects) {
    fuzz::finding("an image of " + std::to_string(image.balls.size() + image.robots.size()) + " objects");
  }
  for (const world::DetectedBall& ball : image.balls) {
    if (!ball.position.allFinite() || !ball.pixel.allFinite()) fuzz::finding("a ball that is nowhere");
  }
  for (const world::DetectedRobot& robot : image.robots) {
    if (!robot.position.allFinite() || !robot.pixel.allFinite()) fuzz::finding("a robot that is nowhere");
    if (robot.number && *robot.number > world::max_robot_number) fuzz::finding("a robot without a pattern");
  }
  std::string bytes;
  wire::encode_packet(image, {}, bytes);
}

void check(const world::Geometry& geometry) {
  if (geometry.cameras.size() > most_objects) {
    fuzz::finding("a geometry of " + std::to_string(geometry.cameras.size()) + " cameras");
  }
  std::string bytes;
  wire::encode_packet(geometry, bytes);
}

}  // namespace

bool fuzz::vision(std::string_view bytes) {
  const int size = static_cast<int>(bytes.size());
  bool understood = false;
  wire::proto::SSL_WrapperPacket packet;
  if (packet.ParsePartialFromArray(bytes.data(), size)) {
    understood = wire::usable(packet.detection());
    check(wire::decode(packet.detection(), {}));
    if (const auto geometry = wire::decode(packet.geometry())) {
      understood = true;
      check(*geometry);
    }
  }
  matchday::legacy2014::SSL_WrapperPacket old;
  if (old.ParsePartialFromArray(bytes.data(), size)) {
    if (const auto geometry = wire::decode(old.geometry())) check(*geometry);
  }
  return understood;
}
