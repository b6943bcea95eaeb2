#include "experiments/host/recorded_teams.h"

#include <algorithm>
#include <stdexcept>

#include "experiments/host/play.h"

namespace host {

RecordedTeams::RecordedTeams(const std::filesystem::path& path, const record::MatchConfig& config)
    : name_(path.string()), reader_(path) {
  for (const world::Team team : world::both_teams) {
    robots_[team] = config.teams[team].robots;
    check(team, hello(team), 0);
  }
}

// What a live team is asked before it may play.
void RecordedTeams::check(world::Team team, const wire::proto::TeamHello& hello, std::int64_t tick) const {
  if (!hello.has_keeper()) return;
  const auto is_keeper = [&](int robot) {
    return robot >= 0 && hello.keeper() == static_cast<std::uint32_t>(robot);
  };
  if (std::ranges::any_of(robots_[team], is_keeper)) return;
  throw std::runtime_error(name_ + ": tick " + std::to_string(tick) + ": " + world::name(team) +
                           " wants robot " + std::to_string(hello.keeper()) +
                           " as its keeper, which is not on the field: the file is damaged");
}

const wire::proto::TeamHello& RecordedTeams::hello(world::Team team) const {
  return team == world::Team::Yellow ? reader_.start().yellow() : reader_.start().blue();
}

const wire::proto::Tick* RecordedTeams::replies(std::int64_t tick) {
  const wire::proto::Tick* replies = reader_.next();
  if (replies != nullptr && replies->tick() != tick) {
    throw std::runtime_error(name_ + ": tick " + std::to_string(replies->tick()) + " where tick " +
                             std::to_string(tick) + " should be: the file is damaged");
  }
  if (replies != nullptr && replies->has_new_yellow())
    check(world::Team::Yellow, replies->new_yellow(), tick);
  if (replies != nullptr && replies->has_new_blue()) check(world::Team::Blue, replies->new_blue(), tick);
  return replies;
}

record::MatchConfig recorded_config(const std::filesystem::path& path) {
  const wire::RecordingReader reader(path);
  try {
    record::MatchConfig config = record::match_config_from_json(reader.start().config());
    check(config);
    return config;
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

RecordedLength recorded_length(const std::filesystem::path& path) {
  wire::RecordingReader reader(path);
  RecordedLength length;
  while (const wire::proto::Tick* tick = reader.next()) length.ticks = tick->tick();
  length.cut = reader.cut();
  return length;
}

Recorder::Recorder(const std::filesystem::path& path, const record::MatchConfig& config,
                   const world::PerTeam<wire::proto::TeamHello>& hellos)
    : writer_(path) {
  wire::proto::Recorded first;
  wire::proto::Start& start = *first.mutable_start();
  start.set_version(wire::recording_version);
  start.set_config(record::to_json(config));
  *start.mutable_yellow() = hellos.yellow;
  *start.mutable_blue() = hellos.blue;
  writer_.write(first);
}

wire::proto::MatchReply& Recorder::reply(world::Team team) {
  wire::proto::Tick& tick = *record_.mutable_tick();
  return team == world::Team::Yellow ? *tick.mutable_yellow() : *tick.mutable_blue();
}

void Recorder::new_teams(const world::PerTeam<wire::proto::TeamHello>& hellos) {
  *record_.mutable_tick()->mutable_new_yellow() = hellos.yellow;
  *record_.mutable_tick()->mutable_new_blue() = hellos.blue;
}

void Recorder::end_tick(std::int64_t tick, const std::string& hash) {
  record_.mutable_tick()->set_tick(tick);
  if (!hash.empty()) record_.mutable_tick()->set_hash(hash);
  writer_.write(record_);
  record_.Clear();
}

}  // namespace host
