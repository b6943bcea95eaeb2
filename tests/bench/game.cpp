#include "tests/bench/game.h"

#include <sys/socket.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/bench/bench.h"
#include "experiments/host/match.h"
#include "sim/world/geometry.h"
#include "teams/reference/reference_team.h"

namespace hot {

const char* name(Part part) {
  constexpr std::array<const char*, part_count> names = {"engine",  "referee", "bookkeeping", "encode",
                                                         "channel", "session", "decode"};
  return names[static_cast<std::size_t>(part)];
}

kit::MakeTeam reference_team() {
  return [](const kit::Setup& setup, bool) {
    return std::make_unique<reference::ReferenceTeam>(setup, reference::Parameters{});
  };
}

namespace {

class Plain final : public kit::Team {
 public:
  void play(const kit::View& view, world::TeamCommands& out) override {
    using world::Vector2d;
    const Vector2d ball = view.ball.position;
    const auto far = [&](const kit::Robot& robot) { return (robot.position - ball).norm(); };
    const kit::Robot* nearest = nullptr;
    for (const kit::Robot& robot : view.own) {
      if (nearest == nullptr || far(robot) < far(*nearest)) nearest = &robot;
    }
    const kit::Phase phase = view.game.phase;
    const bool set_piece =
        view.game.ours && (phase == kit::Phase::Kickoff || phase == kit::Phase::Penalty ||
                           phase == kit::Phase::DirectFree || phase == kit::Phase::IndirectFree);
    const bool may_play = phase == kit::Phase::Running || set_piece;
    const Vector2d forward = (Vector2d(4.5, 0) - ball).normalized();
    for (const kit::Robot& robot : view.own) {
      const bool plays = may_play && &robot == nearest && view.game.forbidden != robot.number;
      Vector2d target(-0.7 - 0.8 * (robot.number % 3), robot.number < 3 ? 1.2 : -1.2);
      double heading = 0;
      if (plays) {
        heading = world::angle_of(forward);
        const bool behind = (ball - robot.position).dot(forward) > 0.9 * far(robot);
        target = ball - (behind ? 0.05 : 0.35) * forward;
      } else if (phase == kit::Phase::Running) {
        if (robot.number % 2 == 0) target.x() = -target.x();
      } else if (far(robot) < 0.8) {
        target = robot.position + (robot.position - ball);
        target.x() = std::min(target.x(), -0.3);
      }
      world::RobotCommand command;
      command.number = robot.number;
      Vector2d wish = 3 * (target - robot.position);
      if (wish.norm() > 1.4) wish *= 1.4 / wish.norm();
      command.velocity_local = world::rotated(wish, -robot.orientation);
      command.angular_velocity = std::clamp(6 * world::wrap_angle(heading - robot.orientation), -6.0, 6.0);
      command.kick_speed = plays ? 2 : 0;
      out.push_back(command);
    }
  }
};

}  // namespace

kit::MakeTeam plain_team() {
  return [](const kit::Setup&, bool) { return std::make_unique<Plain>(); };
}

std::span<const std::byte> payload_of(std::string_view frame) {
  const std::span bytes(reinterpret_cast<const std::byte*>(frame.data()), frame.size());
  std::size_t header = 1;
  while (std::to_integer<unsigned>(bytes[header - 1]) >= 0x80) ++header;
  return bytes.subspan(header);
}

// The two ends of one team's channel and the team behind it.
struct Game::Side {
  Side(std::array<int, 2> sockets, const kit::MakeTeam& players)
      : host(sockets[0]), team(sockets[1]), session({"team", "0", {}, false}, players) {}
  static std::array<int, 2> sockets() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) throw std::runtime_error("no socket pair");
    return ends;
  }

  host::Channel host;
  kit::Channel team;
  kit::Session session;
  host::MessageParser parser;
};

Game::Game(const kit::MakeTeam& players, std::uint64_t seed) : config_(bench::standard_game()) {
  config_.seed = seed;
  engine_ = std::make_unique<engine::Engine>(host::model_of(config_));
  setup_.rules = host::rules_of(config_);
  setup_.geometry = engine_->model().geometry;
  setup_.blue_on_positive_half = config_.blue_on_positive_half;
  setup_.first_kickoff = config_.first_kickoff;
  for (const world::Team team : world::both_teams) {
    setup_.names[team] = config_.teams[team].name;
    setup_.robots[team] = static_cast<int>(config_.teams[team].robots.size());
    sides_[team] = std::make_shared<Side>(Side::sockets(), players);
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
    if (sides_[team]->host.send(frames[team], host::Channel::Full::Return) != host::Channel::Status::Done) {
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

std::int64_t Game::host_calls() const { return sides_.yellow->host.calls() + sides_.blue->host.calls(); }
std::int64_t Game::team_calls() const { return sides_.yellow->team.calls() + sides_.blue->team.calls(); }

void Game::play_to(double seconds) {
  while (world::seconds(engine_->time()) < seconds && tick()) {
  }
}

}  // namespace hot
