#include "experiments/host/messages.h"

#include <filesystem>

#include "sim/wire/delimited.h"
#include "sim/world/random.h"

namespace host {
namespace {

constexpr std::int64_t referee_interval = world::ticks_per_second / 10;  // [ticks]

}  // namespace

std::filesystem::path log_folder(world::Team team, const record::MatchConfig& config) {
  if (config.directory.empty()) return {};
  return std::filesystem::absolute(config.directory) / world::name(team);
}

std::string hello_frame(world::Team team, const record::MatchConfig& config, const engine::Model& model) {
  wire::proto::HostMessage message;
  wire::proto::MatchHello& hello = *message.mutable_hello();
  hello.set_protocol_version(wire::match_protocol_version);
  hello.set_team_name(config.teams[team].name);
  hello.set_color(team == world::Team::Yellow ? matchday::simulation::YELLOW : matchday::simulation::BLUE);
  hello.set_seed(world::derived_seed(config.seed, team == world::Team::Yellow ? "team yellow" : "team blue"));
  if (!config.directory.empty()) hello.set_log_directory(log_folder(team, config).string());
  hello.set_rules(config.rules);
  wire::encode(model.geometry, *hello.mutable_geometry());
  for (const world::RobotSpecs& specs : model.robots[team]) {
    wire::encode(specs, *hello.add_robot_specs());
    hello.add_robots(specs.id.number);
  }
  hello.set_tick_length(world::tick_length);
  hello.set_command_latency(static_cast<std::uint32_t>(model.realism.radio.latency));
  hello.set_vision_latency(static_cast<std::uint32_t>(model.realism.vision.delay));

  std::string frame;
  wire::append_frame(frame, message);
  return frame;
}

// Twice an ordinary tick: most games never need more.
TickMessages::TickMessages() {
  for (std::string* buffer : {&shared_, &frames_.yellow, &frames_.blue}) buffer->reserve(4096);
}

void TickMessages::encode(const engine::Engine& engine, const world::RefereeMessage& referee,
                          bool referee_changed) {
  tick_.set_tick(engine.tick());
  tick_.set_time_us(static_cast<std::uint64_t>(wire::to_microseconds(engine.time(), wire::Epoch{})));

  tick_.clear_packets();  // keeps the objects
  for (const world::Detection& detection : engine.detections()) {
    wire::encode(detection, wire::Epoch{}, *tick_.add_packets()->mutable_detection());
  }

  referee_is_fresh_ =
      referee_changed || referee_tick_ < 0 || engine.tick() - referee_tick_ >= referee_interval;
  if (referee_is_fresh_) {
    wire::encode(referee, wire::Epoch{}, *tick_.mutable_referee());
    tick_.mutable_referee()->set_source_identifier("matchday");
    referee_tick_ = engine.tick();
  }

  shared_.resize(tick_.ByteSizeLong());
  tick_.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(shared_.data()));
}

const std::string& TickMessages::frame(world::Team team, const engine::Engine& engine) {
  feedback_.clear();
  for (const truth::Robot& robot : engine.truth().robots) {
    if (robot.id.team == team) feedback_.push_back({robot.id.number, robot.ball_contact});
  }
  wire::encode(feedback_, responses_[team]);
  std::string& frame = frames_[team];
  frame.clear();
  wire::append_tick_frame(frame, shared_, responses_[team]);
  responses_[team].clear_errors();
  return frame;
}

void TickMessages::refuse(world::Team team, std::string_view code, std::string_view why) {
  wire::add_error(code, why, responses_[team]);
}

const wire::proto::TeamMessage* MessageParser::parse(std::span<const std::byte> payload) {
  arena_.Reset();
  auto* message = google::protobuf::Arena::CreateMessage<wire::proto::TeamMessage>(&arena_);
  const bool good = message->ParseFromArray(payload.data(), static_cast<int>(payload.size()));
  return good ? message : nullptr;
}

}  // namespace host
