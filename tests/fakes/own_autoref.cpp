// Our own detectors as an outside autoref: they get nothing but the league's packets, and report to the game
// controller. Beside the acting referee it must see what that one sees; where it does not, the network's side
// of the judge is wrong, or what the league's messages do not say.

#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>
#include <variant>
#include <vector>

#include "autoref/tracker/frame_grouper.h"
#include "autoref/watcher.h"
#include "sim/network/udp.h"
#include "sim/proto/referee.pb.h"
#include "sim/proto/vision.pb.h"
#include "sim/wire/referee.h"
#include "sim/wire/vision.h"
#include "tests/fakes/controller.h"

namespace {

constexpr const char* own_name = "own-autoref";

void run(const std::string& rules) {
  network::UdpSocket vision = network::UdpSocket::multicast_receiver({"224.5.23.2", 10006}, "127.0.0.1");
  network::UdpSocket referee = network::UdpSocket::multicast_receiver({"224.5.23.1", 10003}, "127.0.0.1");
  network::UdpSocket* const both[] = {&vision, &referee};
  std::optional<fakes::Controller> controller;
  std::optional<autoref::Watcher> watcher;  // with the first geometry
  tracker::FrameGrouper grouper;
  wire::proto::Referee message;
  wire::proto::SSL_WrapperPacket packet;
  matchday::referee::AutoRefToController report;
  world::Detection image;
  while (true) {
    network::wait(both, network::Clock::now() + std::chrono::seconds{1});
    while (const auto datagram = referee.receive()) {
      if (!controller) controller.emplace(datagram->sender.host, own_name);
      if (!message.ParsePartialFromArray(datagram->bytes.data(), static_cast<int>(datagram->bytes.size())))
        continue;
      const auto its = wire::decode(message, wire::Epoch{});
      if (its && watcher) watcher->follow(*its);
    }
    while (const auto datagram = vision.receive()) {
      if (!packet.ParsePartialFromArray(datagram->bytes.data(), static_cast<int>(datagram->bytes.size())))
        continue;
      if (packet.has_geometry() && !watcher) {
        if (const auto geometry = wire::decode(packet.geometry())) {
          watcher.emplace(world::rule_set(rules), *geometry);
        }
      }
      if (!packet.has_detection() || !watcher || !controller) continue;
      wire::decode(packet.detection(), wire::Epoch{}, image);
      const auto sightings = watcher->update(grouper.add(image));
      // To the league a goal from a chip is none, and there is no event for it.
      const bool chip = std::ranges::any_of(sightings, [](const autoref::Sighting& sighting) {
        return std::holds_alternative<world::ChippedGoal>(sighting.event.what);
      });
      for (const autoref::Sighting& sighting : sightings) {
        if (chip && std::holds_alternative<world::PossibleGoal>(sighting.event.what)) continue;
        if (wire::encode(sighting.event, wire::Epoch{}, *report.mutable_game_event()))
          controller->send(report);
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc > 1 ? argv[1] : "ssl-2015");
  } catch (const std::exception& error) {
    std::cerr << own_name << ": " << error.what() << '\n';
    return 1;
  }
}
