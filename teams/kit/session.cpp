#include "teams/kit/session.h"

#include <algorithm>
#include <stdexcept>

#include "autoref/tracker/tracker.h"
#include "sim/wire/delimited.h"
#include "sim/wire/match.h"
#include "sim/wire/referee.h"
#include "sim/wire/robot_control.h"
#include "sim/wire/vision.h"
#include "teams/kit/looker.h"

namespace kit {
namespace {

// First byte of a message whose only field is number 2, length-delimited: the tick in a HostMessage,
// the reply in a TeamMessage. Handling that byte here keeps the tick's objects alive;
// a oneof frees its old content.
constexpr char field_2 = 0x12;

std::optional<std::span<const std::byte>> only_field_2(std::span<const std::byte> payload) {
  if (payload.empty() || static_cast<char>(payload[0]) != field_2) return {};
  std::size_t length = 0;
  std::size_t at = 1;
  for (int shift = 0; at < payload.size() && shift < 28; shift += 7) {
    const auto byte = static_cast<unsigned>(payload[at++]);
    length |= static_cast<std::size_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) {
      if (payload.size() - at == length) return payload.subspan(at);
      return {};
    }
  }
  return {};
}

world::Team team_of(matchday::simulation::Team color) {
  if (color == matchday::simulation::Team::BLUE) return world::Team::Blue;
  if (color == matchday::simulation::Team::YELLOW) return world::Team::Yellow;
  throw std::runtime_error("the host's hello names no colour");
}

}  // namespace

struct Session::Messages {
  matchday::match::HostMessage host;
  matchday::match::MatchTick tick;
  matchday::match::MatchReply reply;
  std::string body;
  std::string frame;

  std::optional<Setup> setup;
  std::optional<tracker::Tracker> tracker;
  std::optional<Looker> looker;
  std::vector<world::Detection> detections;
  world::RefereeMessage referee;
  bool refereed = false;  // a referee message has come
  std::vector<std::uint8_t> contacts;
  world::TeamCommands commands;
};

Session::Session(Options options, MakeTeam make_team)
    : options_(std::move(options)),
      make_team_(std::move(make_team)),
      messages_(std::make_unique<Messages>()) {}
Session::~Session() = default;

std::string_view Session::answer(std::span<const std::byte> payload) {
  Messages& m = *messages_;
  m.frame.clear();
  if (const auto match_tick = only_field_2(payload)) {
    tick(*match_tick);
    return m.frame;
  }
  if (!m.host.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) {
    throw std::runtime_error("the host sent " + std::to_string(payload.size()) +
                             " bytes that are no HostMessage");
  }
  switch (m.host.message_case()) {
    case matchday::match::HostMessage::kHello:
      hello();
      break;
    case matchday::match::HostMessage::kGoodbye:
      over_ = true;
      reason_ = m.host.goodbye().reason();
      break;
    default:
      throw std::runtime_error("the host sent a message that is neither hello, tick nor goodbye");
  }
  return m.frame;
}

void Session::hello() {
  Messages& m = *messages_;
  const matchday::match::MatchHello& hello = m.host.hello();
  if (hello.protocol_version() != wire::match_protocol_version) {
    throw std::runtime_error("the host speaks protocol version " + std::to_string(hello.protocol_version()) +
                             ", this team version " + std::to_string(wire::match_protocol_version));
  }
  const auto geometry = wire::decode(hello.geometry());
  if (!geometry) throw std::runtime_error("the host's hello has no usable geometry");
  Setup setup;
  setup.team = team_of(hello.color());
  setup.team_name = hello.team_name();
  setup.seed = hello.seed();
  setup.log_directory = hello.log_directory();
  setup.rules = hello.rules();
  setup.geometry = *geometry;
  for (const auto& specs : hello.robot_specs()) {
    if (auto decoded = wire::decode(specs)) setup.robots.push_back(*decoded);
  }
  std::sort(setup.robots.begin(), setup.robots.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });
  setup.vision_delay = static_cast<int>(std::min(hello.vision_latency(), 10U));
  setup.command_latency = static_cast<int>(std::min(hello.command_latency(), 10U));

  m.setup = setup;
  m.tracker.emplace(setup.geometry);
  m.looker.emplace(setup);
  m.refereed = false;
  team_ = make_team_(setup, options_.notes);

  matchday::match::TeamMessage reply;
  reply.mutable_hello()->set_protocol_version(wire::match_protocol_version);
  reply.mutable_hello()->set_name(options_.name);
  reply.mutable_hello()->set_version(options_.version);
  reply.mutable_hello()->set_keeper(
      static_cast<std::uint32_t>(options_.keeper.value_or(team_->keeper(setup))));
  wire::append_frame(m.frame, reply);
}

void Session::tick(std::span<const std::byte> match_tick) {
  Messages& m = *messages_;
  if (!m.looker) throw std::runtime_error("the host sent a tick before its hello");
  if (!m.tick.ParseFromArray(match_tick.data(), static_cast<int>(match_tick.size()))) {
    throw std::runtime_error("the host sent a tick that cannot be decoded");
  }

  std::size_t count = 0;
  for (const auto& packet : m.tick.packets()) {
    if (!packet.has_detection()) continue;
    if (m.detections.size() <= count) m.detections.emplace_back();
    wire::decode(packet.detection(), {}, m.detections[count++]);
  }
  m.tracker->update(std::span(m.detections.data(), count));
  if (m.tick.has_referee()) {
    m.refereed |= wire::decode(m.tick.referee(), {}, m.referee);
  }
  m.contacts.clear();
  for (const auto& feedback : m.tick.feedback().feedback()) {
    if (feedback.dribbler_ball_contact() && feedback.id() <= static_cast<unsigned>(world::max_robot_number)) {
      m.contacts.push_back(static_cast<std::uint8_t>(feedback.id()));
    }
  }

  m.commands.clear();
  if (m.refereed) {
    const View& view = m.looker->look(m.tick.tick(), m.tracker->frame(), m.referee, m.contacts);
    if (view.game.phase != Phase::Halt) team_->play(view, m.commands);
  }
  m.looker->sent(m.commands);

  m.reply.set_tick(m.tick.tick());
  wire::encode(m.commands, *m.reply.mutable_control());
  if (options_.notes) {
    const std::string_view note = team_->note();
    m.reply.set_note(note.data(), note.size());
  }
  // TeamMessage { reply } by hand, see field_2.
  m.body.clear();
  m.body.push_back(field_2);
  wire::append_frame(m.body, m.reply);
  wire::append_frame_header(m.frame, m.body.size());
  m.frame += m.body;
}

}  // namespace kit
