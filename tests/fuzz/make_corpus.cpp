// Writes the seeds of tests/fuzz/corpus, each by our own writers: make_corpus FOLDER.
// Leaves other files alone.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "experiments/host/league_log.h"
#include "experiments/host/recorded_teams.h"
#include "experiments/judge/game_file.h"
#include "experiments/judge/recording.h"
#include "experiments/judge/snippet.h"
#include "experiments/judge/state_text.h"
#include "sim/proto/autoref.pb.h"
#include "sim/proto/legacy2014.pb.h"
#include "sim/proto/simulation_custom.pb.h"
#include "sim/wire/delimited.h"
#include "sim/wire/match.h"
#include "sim/wire/vision_packet.h"
#include "tests/experiments/record/examples.h"
#include "tests/fuzz/passage.h"

namespace {

namespace fs = std::filesystem;
namespace simulation = matchday::simulation;
using world::Team;

fs::path corpus;

fs::path place(const std::string& target, const std::string& name) {
  fs::create_directories(corpus / target);
  return corpus / target / ("good_" + name);
}

void seed(const std::string& target, const std::string& name, const std::string& bytes) {
  std::ofstream(place(target, name), std::ios::binary) << bytes;
}
void seed(const std::string& target, const std::string& name, const google::protobuf::MessageLite& message) {
  seed(target, name, message.SerializePartialAsString());
}

world::RefereeMessage running(int score) {
  world::RefereeMessage message;
  message.stage = world::Stage::First;
  message.stage_time_left = std::chrono::seconds{500};
  message.command = {world::CommandKind::Start};
  message.command_counter = 3;
  message.teams.yellow = {"Yellow", score, 0, {std::chrono::seconds{30}}, 4, std::chrono::seconds{300},
                          0,        6,     1};
  message.teams.blue = {"Blue", 0, 1, {}, 4, std::chrono::seconds{300}, 1, 6, 0};
  return message;
}

void write_vision(const fuzz::Passage& passage) {
  std::string bytes;
  wire::encode_packet(passage.ticks.back().images.back(), {}, bytes);
  seed("vision", "image", bytes);
  world::Detection nothing;
  nothing.camera = 3;
  wire::encode_packet(nothing, {}, bytes);
  seed("vision", "image_without_objects", bytes);
  wire::encode_packet(passage.model.geometry, bytes);
  seed("vision", "geometry", bytes);
  world::Geometry rectangle = passage.model.geometry;
  rectangle.field.defense_area.shape = world::DefenseArea::Shape::Rectangle;
  wire::encode_packet(rectangle, bytes);
  seed("vision", "geometry_rectangle", bytes);
}

void write_referee() {
  world::RefereeMessage message = running(2);
  wire::proto::Referee packet;
  wire::encode(message, {}, packet);
  seed("referee", "in_play", packet);
  message.command = {world::CommandKind::Kickoff, Team::Blue};
  message.next_command = world::Command{world::CommandKind::Ready};
  message.designated_position = world::Vector2d(1, -2);
  message.action_time_left = std::chrono::seconds{10};
  message.status = "kickoff";
  wire::encode(message, {}, packet);
  const world::Touch touch{{Team::Blue, 3}, world::tick_time(50), {1, 2}};
  for (const world::GameEvent& event :
       {world::GameEvent{world::tick_time(60), world::BallLeftFieldTouchLine{touch, {1, 3}}},
        world::GameEvent{world::tick_time(60), world::PossibleGoal{Team::Yellow, touch, {-4.5, 0}}}}) {
    wire::encode(event, {}, *packet.add_game_events());
  }
  seed("referee", "kickoff_with_events", packet);
}

void write_robots() {
  simulation::RobotControl local;
  wire::encode({{.number = 0,
                 .velocity_local = {1, 0.5},
                 .angular_velocity = 2,
                 .kick_speed = 3,
                 .dribbler_speed = 50},
                {.number = 1}},
               local);
  seed("robot_control", "local", local);
  simulation::RobotControl others;
  simulation::RobotCommand& global = *others.add_robot_commands();
  global.set_id(0);
  global.mutable_move_command()->mutable_global_velocity()->set_x(1);
  simulation::RobotCommand& wheels = *others.add_robot_commands();
  wheels.set_id(1);
  wheels.mutable_move_command()->mutable_wheel_velocity()->set_front_left(2);
  seed("robot_control", "global_and_wheels", others);
}

void write_simulator(const fuzz::Passage& passage) {
  simulation::SimulatorCommand control;
  simulation::TeleportBall& ball = *control.mutable_control()->mutable_teleport_ball();
  ball.set_x(1);
  ball.set_y(-1);
  ball.set_vx(2);
  ball.set_roll(true);
  simulation::TeleportRobot& robot = *control.mutable_control()->add_teleport_robot();
  robot.mutable_id()->set_id(1);
  robot.mutable_id()->set_team(simulation::YELLOW);
  robot.set_x(2);
  robot.set_y(1);
  robot.set_orientation(1);
  robot.set_present(true);
  control.mutable_control()->set_simulation_speed(2);
  seed("simulator", "teleport", control);
  ball.set_by_force(true);
  robot.set_by_force(true);
  seed("simulator", "by_force", control);

  simulation::SimulatorCommand config;
  wire::encode(passage.model.geometry, *config.mutable_config()->mutable_geometry());
  config.mutable_config()->set_vision_port(10021);
  seed("simulator", "geometry", config);
  config.mutable_config()->clear_geometry();
  wire::encode(passage.model.robots.blue.front(), *config.mutable_config()->add_robot_specs());
  seed("simulator", "specs", config);
  config.mutable_config()->clear_robot_specs();
  simulation::RealismMatchday ours;
  ours.set_preset("harsh");
  ours.add_values()->set_key("radio.latency");
  ours.mutable_values(0)->set_value(3);
  config.mutable_config()->mutable_realism_config()->add_custom()->PackFrom(ours);
  seed("simulator", "realism", config);
}

void write_channel() {
  matchday::match::TeamMessage hello;
  hello.mutable_hello()->set_protocol_version(1);
  hello.mutable_hello()->set_name("team");
  hello.mutable_hello()->set_keeper(0);
  std::string stream;
  wire::append_frame(stream, hello);
  for (int tick = 1; tick <= 4; ++tick) {
    matchday::match::TeamMessage message;
    matchday::match::MatchReply& reply = *message.mutable_reply();
    reply.set_tick(tick);
    wire::encode({{.number = 2, .velocity_local = {0.5, 0}}}, *reply.mutable_control());
    if (tick == 3) reply.mutable_request()->set_keeper(2);
    if (tick == 4) reply.set_note("a note");
    wire::append_frame(stream, message);
  }
  seed("channel", "hello_and_replies", stream);
}

void write_reported() {
  const world::Touch touch{{Team::Blue, 3}, world::tick_time(590), {1, 2}};
  const auto frame = [](const world::GameEvent& event) {
    matchday::referee::AutoRefToController message;
    wire::encode(event, {}, *message.mutable_game_event());
    std::string bytes;
    wire::append_frame(bytes, message);
    return bytes;
  };
  const world::Time now = world::tick_time(599);
  seed("reported", "exit_and_fast_kick",
       frame({now, world::BallLeftFieldGoalLine{touch, {4.5, 1}}}) +
           frame({now, world::BotKickedBallTooFast{{Team::Yellow, 2}, {0, 0}, 9}}));
  seed("reported", "crash",
       frame({now, world::BotCrashUnique{{Team::Yellow, 2}, {Team::Blue, 4}, {1, 1}, 2, 1, 0}}));
}

/// @param ours  as the host writes it, to be refereed again; or of another recorder, to be watched
void league_log(const fuzz::Passage& passage, const fs::path& file, bool ours) {
  wire::proto::Referee first;
  wire::encode(running(0), {}, first);
  if (ours) {
    first.set_source_identifier("matchday");
    first.set_status_message("rules=ssl-2015 half_length=600 first_kickoff=yellow robots=2,2");
  }
  host::LeagueLog log(file, passage.model.geometry, first);
  for (const auto& tick : passage.ticks) {
    google::protobuf::RepeatedPtrField<wire::proto::SSL_WrapperPacket> packets;
    for (const world::Detection& image : tick.images)
      wire::encode(image, {}, *packets.Add()->mutable_detection());
    log.add(tick.truth.time, packets, tick.truth.tick % 6 == 0 ? &first : nullptr);
  }
  log.close();
}

void write_logs(const fuzz::Passage& passage) {
  league_log(passage, place("league_log", "of_ours"), true);
  league_log(passage, place("league_log", "of_others"), false);
  const fs::path packed = corpus / "packed.log.gz";  // the name decides
  league_log(passage, packed, false);
  fs::rename(packed, place("league_log_gz", "log"));

  wire::LogWriter old(place("league_log", "of_2010"));
  for (const auto& tick : passage.ticks) {
    matchday::legacy2014::SSL_WrapperPacket packet;
    wire::encode(tick.images.empty() ? world::Detection{} : tick.images.front(), {},
                 *packet.mutable_detection());
    matchday::legacy2014::SSL_GeometryFieldSize& field = *packet.mutable_geometry()->mutable_field();
    field.set_field_length(6050);
    field.set_field_width(4050);
    old.write(tick.truth.time.time_since_epoch().count(), wire::Vision2010, packet);
  }
  old.close();
}

record::MatchConfig config() {
  record::MatchConfig config;
  config.teams.yellow = {"Yellow", {"team-a"}, {0, 1}};
  config.teams.blue = {"Blue", {"team-b"}, {0, 1}};
  config.half_length = 5;
  return config;
}

void write_recordings() {
  world::PerTeam<wire::proto::TeamHello> hellos;
  for (const Team team : world::both_teams) {
    hellos[team].set_protocol_version(1);
    hellos[team].set_name("team");
    hellos[team].set_keeper(0);
  }
  const fs::path file = place("recording", "short");
  {
    host::Recorder recorder(file, config(), hellos);
    for (int tick = 1; tick <= 20; ++tick) {
      for (const Team team : world::both_teams) {
        matchday::match::MatchReply& reply = recorder.reply(team);
        reply.set_tick(tick);
        wire::encode({{.number = 1, .velocity_local = {1, 0}}}, *reply.mutable_control());
        if (tick == 10) reply.mutable_request()->set_keeper(1);
        if (tick == 12) reply.mutable_request()->set_timeout_start(true);
        if (tick == 15) reply.mutable_request()->set_robot_to_leave(1);
      }
      if (tick == 17) recorder.new_teams(hellos);
      recorder.end_tick(tick, "");
    }
    recorder.close();
  }
  // The same messages without what guards the file.
  wire::proto::Recorded record;
  wire::RecordingReader reader(file);
  *record.mutable_start() = reader.start();
  std::string frames;
  wire::append_frame(frames, record);
  while (const wire::proto::Tick* tick = reader.next()) {
    *record.mutable_tick() = *tick;
    wire::append_frame(frames, record);
  }
  seed("recorded_game", "short", frames);
}

world::GameState in_play(const world::Time time) {
  world::GameState state;
  state.location = world::Location::GameOn;
  state.stage = world::Stage::First;
  state.command = {world::CommandKind::Start};
  state.time = time;
  state.last_touch = world::Touch{{Team::Blue, 1}, world::Time{}, {1, 1}};
  state.touch_team = Team::Blue;
  return state;
}

void write_judged(const fuzz::Passage& passage) {
  judge::Job job{"it", config(), {}};
  const fs::path file = place("judged_game", "exit");
  judge::RecordingWriter writer(file, judge::to_json(job));
  for (const auto& tick : passage.ticks) writer.add(tick.truth, tick.images, in_play(tick.truth.time));
  writer.close(static_cast<std::int64_t>(passage.ticks.size()), std::string(32, '0'));

  judge::GameResult result = judge::judge_again(file, {judge::parse_shadow("rules=paper")});
  seed("judged_result", "exit", judge::to_json(result));
  judge::Case extra{.shadow = "ours", .event = judge::Event::Collision, .result = judge::Result::Extra};
  extra.call = judge::Call{
      .event = judge::Event::Collision, .time = world::tick_time(9), .reported = world::tick_time(10)};
  extra.call->by = world::RobotId{Team::Yellow, 4};
  extra.remark = "a near miss";
  result.cases = {extra};
  seed("judged_result", "extra_call", judge::to_json(result));

  judge::Snippet snippet{
      "design it:0-40", "ssl-2015", world::tick_time(0), world::tick_time(40), {judge::Event::Exit}};
  judge::TrueEvent exit{
      .event = judge::Event::Exit, .time = world::tick_time(30), .margin = 2, .value = 0.08};
  exit.last = judge::LastTouch{.robot = {Team::Yellow, 1}, .time = world::tick_time(10)};
  snippet.truth = {exit};
  snippet.states = {{world::tick_time(40), in_play(world::tick_time(40))}};
  snippet.by_hand = {world::tick_time(2)};
  seed("snippet", "exit", judge::to_json(snippet));
}

void write_texts() {
  seed("config_json", "plain", record::to_json(config()));
  record::MatchConfig full = record::example_config();
  full.teams.yellow.robots = {0, 3, 5};
  seed("config_json", "everything", record::to_json(full));
  seed("record_json", "everything", record::to_json(record::example_record()));
  record::MatchRecord crashed;
  crashed.termination = record::Termination::Crashed;
  crashed.at_fault = record::Party::Blue;
  crashed.reason = "blue (b): ended by signal 11";
  seed("record_json", "crashed", record::to_json(crashed));

  seed("realism", "preset_and_keys",
       "[realism]\npreset = \"harsh\"\nvision.ball_sigma = 0.001\nradio = {latency = 2, loss = 0.05}\n");
  seed("design", "plain",
       "name = \"plain\"\nseed = 3\npairs = 4\nrealism = \"measured\"\nforfeit_goals = 3\n"
       "[rules]\nset = \"ssl-2015\"\nhalf_length = 30.0\nwinner = true\n"
       "[teams.a]\nname = \"a\"\ncommand = [\"team-a\", \"--flag\"]\nrobots = [0, 1, 2]\nspeed_factor = 0.5\n"
       "[teams.b]\ncommand = \"team-b 'two words'\"\nrobots = 3\n"
       "[limits]\nsilence = 60\ngame = 600\nteam_memory = 512\nfree_disk = 100\nsampled = 0.1\naudited = "
       "0.1\n");
  const std::string teams =
      "[teams.a]\ncommand = [\"a\"]\n[teams.b]\nrepository = \"../b\"\nrevision = \"main\"\nrun = \"b\"\n";
  seed("design", "sweep",
       "name = \"sweep\"\npairs = 2\n" + teams +
           "[realism]\npreset = \"harsh\"\nvision.ball_sigma = 0.001\n"
           "[[conditions]]\nname = \"half\"\nb.speed_factor = 0.5\na.arguments = "
           "[\"--press\"]\nrealism.radio.loss = 0.05\n"
           "[[sweeps]]\nname = \"s\"\na.robots = [1, 3]\na.flags.\"--press\" = [0.2, 0.5, "
           "\"off\"]\nrealism.vision.delay = [1, 2]\n");
  seed("design", "panel_and_stopping",
       "name = \"panel\"\npairs = 30\n" + teams +
           "[panel]\nhead_to_head = true\n[[panel.opponents]]\nname = \"c\"\ncommand = \"team-c\"\n"
           "[stopping]\nrule = \"sequential\"\nmetric = \"goal-difference\"\nh0 = 0.0\nh1 = 0.2\nalpha = "
           "0.05\nbeta = 0.05\n"
           "minimum_pairs = 8\nbatch_pairs = 4\nclip = 5\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "make_corpus FOLDER: writes the seeds there, one folder per target\n";
    return 2;
  }
  corpus = argv[1];
  const fuzz::Passage passage = fuzz::passage(40);
  write_vision(passage);
  write_referee();
  write_robots();
  write_simulator(passage);
  write_channel();
  write_reported();
  write_logs(passage);
  write_recordings();
  write_judged(passage);
  write_texts();
  return 0;
}
