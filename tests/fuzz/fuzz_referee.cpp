#include "autoref/watcher.h"
#include "sim/wire/referee.h"
#include "sim/world/rules/rule_set.h"
#include "tests/fuzz/target.h"

bool fuzz::referee(std::string_view bytes) {
  wire::proto::Referee packet;
  if (!packet.ParsePartialFromArray(bytes.data(), static_cast<int>(bytes.size()))) return false;
  const auto message = wire::decode(packet, {});
  if (!message) return false;
  wire::proto::Referee again;
  wire::encode(*message, {}, again);
  autoref::Watcher watcher(world::rule_set("ssl-2015"), {});
  watcher.follow(*message);
  watcher.follow(*message);
  return true;
}
