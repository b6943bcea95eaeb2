#include "experiments/judge/net/net_shadow.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "experiments/judge/net/autoref_port.h"
#include "experiments/judge/net/namespace.h"
#include "experiments/judge/net/reported.h"
#include "experiments/process/child.h"
#include "sim/network/udp.h"
#include "sim/wire/referee.h"
#include "sim/wire/vision.h"

namespace judge {
namespace {

using Clock = std::chrono::steady_clock;

const network::Address vision_group{"224.5.23.2", 10006};
const network::Address referee_group{"224.5.23.1", 10003};
constexpr int message_interval = 6;                            // [ticks] ten times a second
constexpr std::chrono::seconds registration_wait{10};          // ours: a Java program needs about five
constexpr std::chrono::milliseconds greeting{50};              // between packets meanwhile
constexpr std::chrono::milliseconds last_words{300};           // after the last tick
constexpr std::chrono::milliseconds most_behind{100};          // of the wall clock; more is not caught up
constexpr world::Duration repeated = std::chrono::seconds{2};  // programs report again until they are heard

bool is_of_a_stop(Event event) {
  return event == Event::TooFastInStop || event == Event::InterferedPlacement;
}

/// Something may happen that the program must see before it hears of the whistle.
bool is_watched(world::Location location) {
  return location == world::Location::GameOn || location == world::Location::Setup;
}

/// One network namespace for each.
struct OwnNetwork {
  OwnNetwork() { enter_network_namespace(); }
};

}  // namespace

struct NetShadow::Inside {
  Inside(const std::string& command, const world::Geometry& geometry)
      : child({.arguments = {"/bin/sh", "-c", command}, .environment = {}, .directory = {}, .output = {}}) {
    wire::encode(geometry, *geometry_packet.mutable_geometry());
    geometry_packet.SerializeToString(&geometry_bytes);
  }

  void send(const world::RefereeMessage& its) {
    wire::encode(its, wire::Epoch{}, message);
    message.set_source_identifier("matchday");
    message.SerializeToString(&bytes);
    sender.send(bytes, referee_group);
  }

  OwnNetwork own;  // before any socket, and before the child
  network::UdpSocket sender = network::UdpSocket::multicast_sender("127.0.0.1");
  AutorefPort port;
  process::Child child;
  wire::proto::SSL_WrapperPacket geometry_packet, packet;
  wire::proto::Referee message;
  std::string geometry_bytes, bytes;
  world::RefereeMessage shown;        // the acting referee's, as the program knows it
  bool watched = false;               // in play or at a restart, as it knows
  std::uint32_t command_counter = 0;  // sent last
  std::vector<matchday::referee::GameEvent> reports;
  world::GameState state;  // of the acting referee, lately
  world::Time now;
  std::optional<Clock::time_point> begin;  // of match time zero, by the wall clock
};

NetShadow::NetShadow(std::string name, const std::string& command, double speed,
                     const world::Geometry& geometry, world::RuleSet rules)
    : name_(std::move(name)),
      speed_(speed),
      rules_(std::move(rules)),
      inside_(std::make_unique<Inside>(command, geometry)) {}
NetShadow::~NetShadow() = default;
NetShadow::NetShadow(NetShadow&&) noexcept = default;

void NetShadow::wait_for_registration() {
  Inside& in = *inside_;
  const auto deadline = Clock::now() + registration_wait;
  while (in.port.registered().empty()) {
    if (in.child.has_ended()) {
      throw std::runtime_error(name_ + ": the program " +
                               in.child.stop(std::chrono::milliseconds{0}).describe() +
                               " before it registered at port 10007");
    }
    if (Clock::now() > deadline) {
      throw std::runtime_error(name_ + ": the program did not register at port 10007 within 10 s");
    }
    // It finds the port by the sender of these.
    in.sender.send(in.geometry_bytes, vision_group);
    in.sender.send(in.bytes, referee_group);
    std::this_thread::sleep_for(greeting);
    in.child.drain();
    in.port.listen(in.reports);
  }
}

void NetShadow::tick(const engine::Engine& engine, const referee::Referee& referee) {
  Inside& in = *inside_;
  const auto since_zero = std::chrono::duration<double>(world::seconds(engine.time()) / speed_);
  const auto pace = std::chrono::duration_cast<Clock::duration>(since_zero);
  if (!in.begin) {
    in.send(referee.message());
    wait_for_registration();
    in.begin = Clock::now() - pace;
  }
  std::this_thread::sleep_until(*in.begin + pace);
  if (Clock::now() > *in.begin + pace + most_behind) in.begin = Clock::now() - pace;

  if (engine.tick() % world::ticks_per_second == 0) in.sender.send(in.geometry_bytes, vision_group);
  for (const world::Detection& image : engine.detections()) {
    wire::encode(image, wire::Epoch{}, *in.packet.mutable_detection());
    in.packet.SerializeToString(&in.bytes);
    in.sender.send(in.bytes, vision_group);
  }
  // It must not hear of the whistle before it can have seen why: it would stop looking.
  const world::GameState& state = referee.state();
  const bool held = in.watched && !is_watched(state.location) && engine.time() < state.location_time + linger;
  if (!held) {
    in.shown = referee.message();
    in.watched = is_watched(state.location);
  }
  const bool due = std::exchange(in.command_counter, in.shown.command_counter) != in.shown.command_counter ||
                   engine.tick() % message_interval == 0;
  if (due) in.send(in.shown);
  in.child.drain();
  in.port.listen(in.reports);
  in.state = referee.state();
  in.now = engine.time();
  take();
  if (engine.tick() % world::ticks_per_second == 0 && in.child.has_ended()) {
    throw std::runtime_error(name_ + ": the program " +
                             in.child.stop(std::chrono::milliseconds{0}).describe() + " during the game");
  }
}

void NetShadow::take() {
  const world::GameState& state = inside_->state;
  for (const matchday::referee::GameEvent& report : std::exchange(inside_->reports, {})) {
    std::optional<Call> call = call_of(report, inside_->now);
    if (!call) continue;
    const bool again = std::ranges::any_of(calls_, [&](const Call& old) {
      return old.event == call->event && old.by == call->by && call->time - old.time < repeated;
    });
    if (again) continue;
    const auto its = is_of_a_stop(call->event) ? world::Location::GameOff : world::Location::GameOn;
    call->late = state.location != its && call->time > state.location_time;
    calls_.push_back(*std::move(call));
  }
}

void NetShadow::end() {
  std::this_thread::sleep_for(last_words);
  inside_->port.listen(inside_->reports);
  take();
  inside_->child.stop(std::chrono::milliseconds{1000});
}

}  // namespace judge
