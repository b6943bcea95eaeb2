#include "sim/wire/referee.h"

#include <algorithm>
#include <limits>

#include "sim/wire/units.h"

namespace wire {

namespace {

using world::CommandKind;
using world::Stage;
using world::Team;
using WireStage = proto::Referee;
using WireCommand = proto::Referee;

proto::Referee::Stage to_wire(Stage stage) {
  switch (stage) {
    case Stage::PreFirst:
      return WireStage::NORMAL_FIRST_HALF_PRE;
    case Stage::First:
      return WireStage::NORMAL_FIRST_HALF;
    case Stage::HalfTime:
      return WireStage::NORMAL_HALF_TIME;
    case Stage::PreSecond:
      return WireStage::NORMAL_SECOND_HALF_PRE;
    case Stage::Second:
      return WireStage::NORMAL_SECOND_HALF;
    case Stage::ExtraBreak:
      return WireStage::EXTRA_TIME_BREAK;
    case Stage::PreExtraFirst:
      return WireStage::EXTRA_FIRST_HALF_PRE;
    case Stage::ExtraFirst:
      return WireStage::EXTRA_FIRST_HALF;
    case Stage::ExtraHalfTime:
      return WireStage::EXTRA_HALF_TIME;
    case Stage::PreExtraSecond:
      return WireStage::EXTRA_SECOND_HALF_PRE;
    case Stage::ExtraSecond:
      return WireStage::EXTRA_SECOND_HALF;
    case Stage::ShootoutBreak:
      return WireStage::PENALTY_SHOOTOUT_BREAK;
    case Stage::Shootout:
      return WireStage::PENALTY_SHOOTOUT;
    case Stage::Post:
      return WireStage::POST_GAME;
  }
  return WireStage::POST_GAME;
}

Stage from_wire(proto::Referee::Stage stage) {
  switch (stage) {
    case WireStage::NORMAL_FIRST_HALF_PRE:
      return Stage::PreFirst;
    case WireStage::NORMAL_FIRST_HALF:
      return Stage::First;
    case WireStage::NORMAL_HALF_TIME:
      return Stage::HalfTime;
    case WireStage::NORMAL_SECOND_HALF_PRE:
      return Stage::PreSecond;
    case WireStage::NORMAL_SECOND_HALF:
      return Stage::Second;
    case WireStage::EXTRA_TIME_BREAK:
      return Stage::ExtraBreak;
    case WireStage::EXTRA_FIRST_HALF_PRE:
      return Stage::PreExtraFirst;
    case WireStage::EXTRA_FIRST_HALF:
      return Stage::ExtraFirst;
    case WireStage::EXTRA_HALF_TIME:
      return Stage::ExtraHalfTime;
    case WireStage::EXTRA_SECOND_HALF_PRE:
      return Stage::PreExtraSecond;
    case WireStage::EXTRA_SECOND_HALF:
      return Stage::ExtraSecond;
    case WireStage::PENALTY_SHOOTOUT_BREAK:
      return Stage::ShootoutBreak;
    case WireStage::PENALTY_SHOOTOUT:
      return Stage::Shootout;
    case WireStage::POST_GAME:
      return Stage::Post;
  }
  return Stage::Post;
}

proto::Referee::Command to_wire(const world::Command& command) {
  const bool yellow = command.team == Team::Yellow;
  switch (command.kind) {
    case CommandKind::Halt:
      return WireCommand::HALT;
    case CommandKind::Stop:
      return WireCommand::STOP;
    case CommandKind::Indirect:
      return yellow ? WireCommand::INDIRECT_FREE_YELLOW : WireCommand::INDIRECT_FREE_BLUE;
    case CommandKind::Direct:
      return yellow ? WireCommand::DIRECT_FREE_YELLOW : WireCommand::DIRECT_FREE_BLUE;
    case CommandKind::Kickoff:
      return yellow ? WireCommand::PREPARE_KICKOFF_YELLOW : WireCommand::PREPARE_KICKOFF_BLUE;
    case CommandKind::Penalty:
      return yellow ? WireCommand::PREPARE_PENALTY_YELLOW : WireCommand::PREPARE_PENALTY_BLUE;
    case CommandKind::Goal:
      return yellow ? WireCommand::GOAL_YELLOW : WireCommand::GOAL_BLUE;
    case CommandKind::Ready:
      return WireCommand::NORMAL_START;
    case CommandKind::Start:
      return WireCommand::FORCE_START;
    case CommandKind::Timeout:
      return yellow ? WireCommand::TIMEOUT_YELLOW : WireCommand::TIMEOUT_BLUE;
  }
  return WireCommand::HALT;
}

world::Command from_wire(proto::Referee::Command command) {
  switch (command) {
    case WireCommand::HALT:
      return {CommandKind::Halt};
    case WireCommand::STOP:
      return {CommandKind::Stop};
    case WireCommand::NORMAL_START:
      return {CommandKind::Ready};
    case WireCommand::FORCE_START:
      return {CommandKind::Start};
    case WireCommand::PREPARE_KICKOFF_YELLOW:
      return {CommandKind::Kickoff, Team::Yellow};
    case WireCommand::PREPARE_KICKOFF_BLUE:
      return {CommandKind::Kickoff, Team::Blue};
    case WireCommand::PREPARE_PENALTY_YELLOW:
      return {CommandKind::Penalty, Team::Yellow};
    case WireCommand::PREPARE_PENALTY_BLUE:
      return {CommandKind::Penalty, Team::Blue};
    case WireCommand::DIRECT_FREE_YELLOW:
      return {CommandKind::Direct, Team::Yellow};
    case WireCommand::DIRECT_FREE_BLUE:
      return {CommandKind::Direct, Team::Blue};
    case WireCommand::INDIRECT_FREE_YELLOW:
      return {CommandKind::Indirect, Team::Yellow};
    case WireCommand::INDIRECT_FREE_BLUE:
      return {CommandKind::Indirect, Team::Blue};
    case WireCommand::TIMEOUT_YELLOW:
      return {CommandKind::Timeout, Team::Yellow};
    case WireCommand::TIMEOUT_BLUE:
      return {CommandKind::Timeout, Team::Blue};
    case WireCommand::GOAL_YELLOW:
      return {CommandKind::Goal, Team::Yellow};
    case WireCommand::GOAL_BLUE:
      return {CommandKind::Goal, Team::Blue};
    case WireCommand::BALL_PLACEMENT_YELLOW:
      return {CommandKind::Stop, Team::Yellow};
    case WireCommand::BALL_PLACEMENT_BLUE:
      return {CommandKind::Stop, Team::Blue};
  }
  return {CommandKind::Halt};
}

std::uint32_t to_unsigned(std::int64_t value) {
  return static_cast<std::uint32_t>(
      std::clamp<std::int64_t>(value, 0, std::numeric_limits<std::uint32_t>::max()));
}

// Beyond these a number is nonsense, and sums of it would not fit. All ours: no game comes near.
constexpr std::uint32_t most_counted = 1'000'000;  // goals, cards, time-outs, robots
constexpr std::uint32_t nobody = 255;              // a robot number that no pattern has
constexpr int most_cards = 64;                     // at the same time
constexpr std::size_t longest_name = 256;          // [bytes]
constexpr std::size_t longest_status = 4096;       // [bytes]

int to_int(std::uint32_t value) { return static_cast<int>(std::min(value, most_counted)); }

void encode_team(const world::TeamInfo& team, proto::Referee::TeamInfo& out) {
  out.set_name(team.name);
  out.set_score(to_unsigned(team.score));
  out.set_red_cards(to_unsigned(team.red_cards));
  for (const world::Duration time : team.yellow_card_times)
    out.add_yellow_card_times(to_unsigned(to_us(time)));
  out.set_yellow_cards(to_unsigned(team.yellow_cards));
  out.set_timeouts(to_unsigned(team.timeouts));
  out.set_timeout_time(to_unsigned(to_us(team.timeout_time)));
  out.set_goalkeeper(to_unsigned(team.keeper));
  out.set_can_place_ball(false);  // laws of 2015: the referee places the ball
  out.set_max_allowed_bots(to_unsigned(team.max_robots));
}

void decode_team(const proto::Referee::TeamInfo& team, world::TeamInfo& result) {
  result.name.assign(team.name(), 0, longest_name);
  result.score = to_int(team.score());
  result.red_cards = to_int(team.red_cards());
  result.yellow_card_times.clear();
  const int cards = std::min(team.yellow_card_times_size(), most_cards);
  for (int card = 0; card < cards; ++card) {
    result.yellow_card_times.push_back(from_us(team.yellow_card_times(card)));
  }
  result.yellow_cards = to_int(team.yellow_cards());
  result.timeouts = to_int(team.timeouts());
  result.timeout_time = from_us(team.timeout_time());
  result.keeper = static_cast<int>(std::min(team.goalkeeper(), nobody));
  result.max_robots =
      team.has_max_allowed_bots() ? to_int(team.max_allowed_bots()) : world::TeamInfo{}.max_robots;
}

std::optional<world::Time> decode_time(std::uint64_t microseconds, Epoch epoch) {
  constexpr std::uint64_t last = 4'000'000'000'000'000;  // the year 2096, as from_microseconds asks
  if (microseconds > last) return std::nullopt;
  return from_microseconds(static_cast<std::int64_t>(microseconds), epoch);
}

}  // namespace

void encode(const world::RefereeMessage& message, Epoch epoch, proto::Referee& out) {
  out.Clear();
  out.set_packet_timestamp(static_cast<std::uint64_t>(to_microseconds(message.time, epoch)));
  out.set_stage(to_wire(message.stage));
  if (message.stage_time_left) out.set_stage_time_left(to_us(*message.stage_time_left));
  out.set_command(to_wire(message.command));
  out.set_command_counter(message.command_counter);
  out.set_command_timestamp(static_cast<std::uint64_t>(to_microseconds(message.command_time, epoch)));
  encode_team(message.teams.yellow, *out.mutable_yellow());
  encode_team(message.teams.blue, *out.mutable_blue());
  if (message.designated_position) {
    out.mutable_designated_position()->set_x(to_mm(message.designated_position->x()));
    out.mutable_designated_position()->set_y(to_mm(message.designated_position->y()));
  }
  out.set_blue_team_on_positive_half(message.blue_on_positive_half);
  if (message.next_command) out.set_next_command(to_wire(*message.next_command));
  if (message.action_time_left) out.set_current_action_time_remaining(to_us(*message.action_time_left));
  if (!message.status.empty()) out.set_status_message(message.status);
}

std::optional<world::RefereeMessage> decode(const proto::Referee& message, Epoch epoch) {
  world::RefereeMessage result;
  if (!decode(message, epoch, result)) return std::nullopt;
  return result;
}

bool decode(const proto::Referee& message, Epoch epoch, world::RefereeMessage& out) {
  const std::optional<world::Time> time = decode_time(message.packet_timestamp(), epoch);
  const std::optional<world::Time> command_time = decode_time(message.command_timestamp(), epoch);
  if (!message.has_stage() || !message.has_command() || !time || !command_time) return false;

  out.time = *time;
  out.stage = from_wire(message.stage());
  out.stage_time_left.reset();
  if (message.has_stage_time_left()) out.stage_time_left = from_us(message.stage_time_left());
  out.command = from_wire(message.command());
  out.command_counter = message.command_counter();
  out.command_time = *command_time;
  decode_team(message.yellow(), out.teams.yellow);
  decode_team(message.blue(), out.teams.blue);
  const proto::Referee::Point& point = message.designated_position();
  out.designated_position.reset();
  if (message.has_designated_position() && is_coordinate(point.x()) && is_coordinate(point.y())) {
    out.designated_position = world::Vector2d(from_mm(point.x()), from_mm(point.y()));
  }
  out.blue_on_positive_half = message.has_blue_team_on_positive_half()
                                  ? message.blue_team_on_positive_half()
                                  : world::RefereeMessage{}.blue_on_positive_half;
  out.next_command.reset();
  if (message.has_next_command()) out.next_command = from_wire(message.next_command());
  out.action_time_left.reset();
  if (message.has_current_action_time_remaining()) {
    out.action_time_left = from_us(message.current_action_time_remaining());
  }
  out.status.assign(message.status_message(), 0, longest_status);
  return true;
}

}  // namespace wire
