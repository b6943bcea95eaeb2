#include "sim/wire/referee.h"

#include <gmock/gmock.h>

#include <array>
#include <chrono>

#include "tests/sim/wire/league_schema.h"

namespace {

using std::chrono::microseconds;
using std::chrono::seconds;
using testing::IsEmpty;
using wire::Epoch;
using wire::proto::Referee;
using world::CommandKind;
using world::Stage;
using world::Team;

world::RefereeMessage full_message() {
  world::RefereeMessage message;
  message.time = world::Time{microseconds{123'456'789}};
  message.stage = Stage::Second;
  message.stage_time_left = microseconds{-1'500'000};
  message.command = {CommandKind::Direct, Team::Blue};
  message.command_counter = 4'000'000'000U;
  message.command_time = world::Time{microseconds{120'000'001}};
  message.teams.yellow = {"Tigers", 2, 1, {seconds{30}, seconds{90}}, 3, seconds{250}, 4, 5, 7};
  message.teams.blue = {"Mice", 0, 0, {}, 4, seconds{300}, 0, 6};
  message.designated_position = world::Vector2d(1.25, -3.0);
  message.blue_on_positive_half = false;
  message.next_command = world::Command{CommandKind::Kickoff, Team::Yellow};
  message.action_time_left = microseconds{-7};
  message.status = "text";
  return message;
}

void expect_same(const world::TeamInfo& a, const world::TeamInfo& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.score, b.score);
  EXPECT_EQ(a.red_cards, b.red_cards);
  EXPECT_EQ(a.yellow_card_times, b.yellow_card_times);
  EXPECT_EQ(a.timeouts, b.timeouts);
  EXPECT_EQ(a.timeout_time, b.timeout_time);
  EXPECT_EQ(a.keeper, b.keeper);
  EXPECT_EQ(a.max_robots, b.max_robots);
  EXPECT_EQ(a.yellow_cards, b.yellow_cards);
}

void expect_same(const world::RefereeMessage& a, const world::RefereeMessage& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.stage, b.stage);
  EXPECT_EQ(a.stage_time_left, b.stage_time_left);
  EXPECT_EQ(a.command, b.command);
  EXPECT_EQ(a.command_counter, b.command_counter);
  EXPECT_EQ(a.command_time, b.command_time);
  expect_same(a.teams.yellow, b.teams.yellow);
  expect_same(a.teams.blue, b.teams.blue);
  EXPECT_EQ(a.designated_position, b.designated_position);
  EXPECT_EQ(a.blue_on_positive_half, b.blue_on_positive_half);
  EXPECT_EQ(a.next_command, b.next_command);
  EXPECT_EQ(a.action_time_left, b.action_time_left);
  EXPECT_EQ(a.status, b.status);
}

Referee encoded(const world::RefereeMessage& message) {
  Referee out;
  wire::encode(message, Epoch{}, out);
  return out;
}

Referee encoded(world::Command command) {
  world::RefereeMessage message;
  message.command = command;
  return encoded(message);
}

}  // namespace

TEST(RefereeMessage, ComesBackFromTheWire) {
  const std::optional<world::RefereeMessage> back = wire::decode(encoded(full_message()), Epoch{});
  ASSERT_TRUE(back.has_value());
  expect_same(*back, full_message());

  const std::optional<world::RefereeMessage> bare = wire::decode(encoded(world::RefereeMessage{}), Epoch{});
  ASSERT_TRUE(bare.has_value());
  expect_same(*bare, world::RefereeMessage{});
}

TEST(RefereeMessage, EveryStageAndCommandComesBack) {
  for (int stage = 0; stage <= static_cast<int>(Stage::Post); ++stage) {
    for (int kind = 0; kind <= static_cast<int>(CommandKind::Timeout); ++kind) {
      for (const Team team : world::both_teams) {
        world::RefereeMessage message;
        message.stage = static_cast<Stage>(stage);
        message.command = {static_cast<CommandKind>(kind), team};
        message.next_command = message.command;
        const std::optional<world::RefereeMessage> back = wire::decode(encoded(message), Epoch{});
        ASSERT_TRUE(back.has_value());
        expect_same(*back, message);
      }
    }
  }
}

TEST(RefereeMessage, CommandsHaveTheLeaguesNames) {
  EXPECT_EQ(encoded({CommandKind::Halt}).command(), Referee::HALT);
  EXPECT_EQ(encoded({CommandKind::Stop}).command(), Referee::STOP);
  EXPECT_EQ(encoded({CommandKind::Ready}).command(), Referee::NORMAL_START);
  EXPECT_EQ(encoded({CommandKind::Start}).command(), Referee::FORCE_START);
  EXPECT_EQ(encoded({CommandKind::Kickoff, Team::Yellow}).command(), Referee::PREPARE_KICKOFF_YELLOW);
  EXPECT_EQ(encoded({CommandKind::Penalty, Team::Blue}).command(), Referee::PREPARE_PENALTY_BLUE);
  EXPECT_EQ(encoded({CommandKind::Direct, Team::Blue}).command(), Referee::DIRECT_FREE_BLUE);
  EXPECT_EQ(encoded({CommandKind::Indirect, Team::Yellow}).command(), Referee::INDIRECT_FREE_YELLOW);
  EXPECT_EQ(encoded({CommandKind::Goal, Team::Blue}).command(), Referee::GOAL_BLUE);
  EXPECT_EQ(encoded({CommandKind::Timeout, Team::Yellow}).command(), Referee::TIMEOUT_YELLOW);
}

TEST(RefereeMessage, UnitsAreMicrosecondsAndMillimetres) {
  const Referee message = encoded(full_message());
  EXPECT_EQ(message.packet_timestamp(), 1'700'000'123'456'789U);
  EXPECT_EQ(message.command_timestamp(), 1'700'000'120'000'001U);
  EXPECT_EQ(message.stage_time_left(), -1'500'000);
  EXPECT_EQ(message.current_action_time_remaining(), -7);
  EXPECT_EQ(message.designated_position().x(), 1250.0F);
  EXPECT_EQ(message.designated_position().y(), -3000.0F);
  EXPECT_EQ(message.yellow().timeout_time(), 250'000'000U);
  EXPECT_EQ(message.yellow().yellow_card_times(1), 90'000'000U);
  EXPECT_EQ(message.yellow().max_allowed_bots(), 5U);
}

TEST(RefereeMessage, OnlyOneOfTheTwoCountdownsIsZigZag) {
  Referee message;
  message.set_stage_time_left(-1);
  EXPECT_EQ(message.SerializeAsString(), "\x18\x01");
  message.clear_stage_time_left();
  message.set_current_action_time_remaining(-1);
  EXPECT_EQ(message.SerializeAsString(), "\x78\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01");
}

TEST(RefereeMessage, SetsEveryFieldTheLeagueRequires) {
  EXPECT_THAT(league::missing_required(encoded(full_message()), "ssl-game-controller HEAD"), IsEmpty());
  EXPECT_THAT(league::missing_required(encoded(world::RefereeMessage{}), "ssl-game-controller HEAD"),
              IsEmpty());
}

TEST(RefereeMessage, BallPlacementReadsAsStop) {
  Referee message = encoded(full_message());
  message.set_command(Referee::BALL_PLACEMENT_BLUE);
  const std::optional<world::RefereeMessage> back = wire::decode(message, Epoch{});
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->command.kind, CommandKind::Stop);
  EXPECT_EQ(back->designated_position, full_message().designated_position);
}

TEST(RefereeMessage, ExtraTimeAndShootoutHaveStagesOfTheirOwn) {
  const std::array<std::pair<Referee::Stage, Stage>, 8> expected = {{
      {Referee::EXTRA_TIME_BREAK, Stage::ExtraBreak},
      {Referee::EXTRA_FIRST_HALF_PRE, Stage::PreExtraFirst},
      {Referee::EXTRA_FIRST_HALF, Stage::ExtraFirst},
      {Referee::EXTRA_HALF_TIME, Stage::ExtraHalfTime},
      {Referee::EXTRA_SECOND_HALF_PRE, Stage::PreExtraSecond},
      {Referee::EXTRA_SECOND_HALF, Stage::ExtraSecond},
      {Referee::PENALTY_SHOOTOUT_BREAK, Stage::ShootoutBreak},
      {Referee::PENALTY_SHOOTOUT, Stage::Shootout},
  }};
  for (const auto& [wire_stage, stage] : expected) {
    Referee message = encoded(full_message());
    message.set_stage(wire_stage);
    EXPECT_EQ(wire::decode(message, Epoch{})->stage, stage) << Referee::Stage_Name(wire_stage);
  }
}

TEST(RefereeMessage, AnUnknownCommandSpoilsOnlyItsOwnMessage) {
  // Closed enums: to a reader that requires the field, 99 would make the message unreadable.
  std::string bytes = encoded(full_message()).SerializeAsString();
  bytes += "\x20\x63";  // field 4, command = 99: the last value wins, and this one goes to the unknown fields
  Referee message;
  ASSERT_TRUE(message.ParseFromString(bytes));
  EXPECT_EQ(message.command(), Referee::DIRECT_FREE_BLUE);

  Referee only_unknown;
  ASSERT_TRUE(only_unknown.ParseFromString("\x20\x63"));
  EXPECT_FALSE(only_unknown.has_command());
  EXPECT_FALSE(wire::decode(only_unknown, Epoch{}).has_value());
}

TEST(RefereeMessage, RefusesWhatIsNoTime) {
  Referee message = encoded(full_message());
  message.set_packet_timestamp(18'000'000'000'000'000'000U);
  EXPECT_FALSE(wire::decode(message, Epoch{}).has_value());
}

TEST(RefereeMessage, SurvivesAbsurdNumbers) {
  Referee message = encoded(full_message());
  message.set_stage_time_left(std::numeric_limits<std::int64_t>::min());
  message.set_current_action_time_remaining(std::numeric_limits<std::int64_t>::max());
  message.mutable_yellow()->set_score(4'000'000'000U);
  message.mutable_designated_position()->set_x(std::nanf(""));
  const std::optional<world::RefereeMessage> back = wire::decode(message, Epoch{});
  ASSERT_TRUE(back.has_value());
  EXPECT_LT(*back->stage_time_left, world::Duration{});
  EXPECT_GT(*back->action_time_left, world::Duration{});
  EXPECT_GT(back->teams.yellow.score, 0);
  EXPECT_FALSE(back->designated_position.has_value());
}

TEST(RefereeMessage, CutsNumbersAndTextsToWhatHasAMeaning) {
  Referee message = encoded(full_message());
  Referee::TeamInfo& team = *message.mutable_yellow();
  team.set_name(std::string(60'000, 'n'));
  team.set_score(4'000'000'000U);
  team.set_goalkeeper(256 + 3);  // as a byte it would be robot 3
  for (int i = 0; i < 60'000; ++i) team.add_yellow_card_times(1);
  message.set_status_message(std::string(60'000, 's'));
  message.set_stage_time_left(std::numeric_limits<std::int64_t>::max());
  message.set_packet_timestamp(4'000'000'000'000'000);
  const std::optional<world::RefereeMessage> back = wire::decode(message, Epoch{});
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->teams.yellow.name.size(), 256U);
  EXPECT_EQ(back->teams.yellow.score, 1'000'000);
  EXPECT_EQ(back->teams.yellow.keeper, 255);
  EXPECT_EQ(back->teams.yellow.yellow_card_times.size(), 64U);
  EXPECT_EQ(back->status.size(), 4096U);
  // Instants and spans of the wire may be added without overflow.
  EXPECT_LT(world::seconds(back->time) + world::seconds(*back->stage_time_left), 9.2e9);
}
