#include "tests/bench/game.h"

#include <sys/socket.h>

#include <stdexcept>

#include "experiments/bench/bench.h"
#include "experiments/host/match.h"
#include "teams/reference/reference_team.h"

namespace hot {

const char* name(Part part) {
  constexpr std::array<const char*, part_count> names = {"engine",  "referee", "bookkeeping", "encode",
                                                         "channel", "session", "decode"};
  return names[static_cast<std::size_t>(part)];
}

kit::Session reference_session() {
  return kit::Session({"team-reference", "0", {}, false}, [](const kit::Setup& setup, bool) {
    return std::make_unique<reference::ReferenceTeam>(setup, reference::Parameters{});
  });
}

std::span<const std::byte> payload_of(std::string_view frame) {
  const std::span bytes(reinterpret_cast<const std::byte*>(frame.data()), frame.size());
  std::size_t header = 1;
  while (std::to_integer<unsigned>(bytes[header - 1]) >= 0x80) ++header;
  return bytes.subspan(header);
}

// The two ends of one team's channel and the team behind it.
struct Game::Side {
  explicit Side(std::array<int, 2> sockets) : host(sockets[0]), team(sockets[1]) {}
  static std::array<int, 2> sockets() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) throw std::runtime_error("no socket pair");
    return ends;
  }

  host::Channel host;
  kit::Channel team;
  kit::Session session = reference_session();
  host::MessageParser parser;
};

Game::Game(std::uint64_t seed) : config_(bench::standard_game()) {
  config_.seed = seed;
  engine_ = std::make_unique<engine::Engine>(host::model_of(config_));
  setup_.rules = host::rules_of(config_);
  setup_.geometry = engine_->model().geometry;
  setup_.blue_on_positive_half = config_.blue_on_positive_half;
  setup_.first_kickoff = config_.first_kickoff;
  for (const world::Team team : world::both_teams) {
    setup_.names[team] = config_.teams[team].name;
    setup_.robots[team] = static_cast<int>(config_.teams[team].robots.size());
    sides_[team] = std::make_shared<Side>(Side::sockets());
    hellos_[team] = host::hello_frame(team, config_, engine_->model());
    sides_[team]->session.answer(payload_of(hellos_[team]));
  }
  referee_ = std::make_unique<referee::Referee>(setup_);
}

bool Game::tick() {
  engine_->step(commands_);
  on_part(Part::Engine);

  output_ = referee_->update(engine_->detections(), engine_->time());
  on_part(Part::Referee);

  hash_.add(engine_->truth(), commands_, referee_->message(), output_.ball_reset);
  tally_.add(output_, *referee_);
  ball_reset_.update(output_.ball_reset, referee_->state(), *engine_);
  robot_count_.update(referee_->message(), referee_->state(), *engine_);
  on_part(Part::Bookkeeping);

  messages_.encode(*engine_, referee_->message(), output_.message_changed);
  if (output_.finished) return false;
  world::PerTeam<std::string_view> frames;
  for (const world::Team team : world::both_teams) frames[team] = messages_.frame(team, *engine_);
  on_part(Part::Encode);

  for (const world::Team team : world::both_teams) {
    if (sides_[team]->host.send(frames[team]) != host::Channel::Status::Done) {
      throw std::runtime_error("a tick's message does not fit into the socket");
    }
  }
  for (const world::Team team : world::both_teams) exchange(team);
  return true;
}

void Game::exchange(world::Team team) {
  Side& side = *sides_[team];
  const auto payload = side.team.read();
  on_part(Part::Channel);
  const std::string_view answer = side.session.answer(*payload);
  on_part(Part::Session);
  side.team.write(answer);
  std::span<const std::byte> reply;
  if (side.host.receive(reply) != host::Channel::Status::Done) throw std::runtime_error("no reply");
  on_part(Part::Channel);
  const wire::proto::TeamMessage* message = side.parser.parse(reply);
  wire::decode(message->reply().control(), commands_[team], bad_commands_[team]);
  on_part(Part::Decode);
  if (keep) {
    payloads_[team].assign(reinterpret_cast<const char*>(payload->data()), payload->size());
    replies_[team] = answer;
  }
}

void Game::play_to(double seconds) {
  while (world::seconds(engine_->time()) < seconds && tick()) {
  }
}

}  // namespace hot
