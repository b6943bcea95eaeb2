// Whatever comes in at the ports: the server answers, stays alive, and a message it does not understand
// changes nothing, to the bit.
#include <gmock/gmock.h>
#include <google/protobuf/stubs/logging.h>

#include <cmath>
#include <cstring>

#include "sim/proto/simulation_custom.pb.h"
#include "sim/wire/vision.h"
#include "sim/world/random.h"
#include "tests/sim/server/bench.h"

namespace {

using bench::Bench;
namespace proto = bench::proto;
using world::Team;

void append(std::string& bytes, double value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Everything that a message could have changed, to the bit.
std::string fingerprint(const server::Server& server) {
  std::string bytes = server.geometry();
  append(bytes, server.speed());
  append(bytes, server.vision_port());
  append(bytes, static_cast<double>(server.simulation().tick()));
  const truth::Frame& truth = server.simulation().truth();
  for (const world::Vector3d& v : {truth.ball.position, truth.ball.velocity, truth.ball.spin}) {
    for (int i = 0; i < 3; ++i) append(bytes, v[i]);
  }
  for (const truth::Robot& robot : truth.robots) {
    bytes += static_cast<char>(robot.id.number);
    for (const double value : {robot.position.x(), robot.position.y(), robot.orientation, robot.velocity.x(),
                               robot.velocity.y(), robot.angular_velocity}) {
      append(bytes, value);
    }
  }
  const server::Setup& setup = server.simulation().setup();
  for (const engine::RealismKey& key : engine::realism_keys()) append(bytes, key.get(setup.realism));
  for (const Team team : world::both_teams) {
    for (const world::RobotSpecs& specs : setup.specs[team]) {
      wire::proto::RobotSpecs message;
      wire::encode(specs, message);
      bytes += message.SerializeAsString();
    }
  }
  return bytes;
}

/// One message with every field there is, and the smaller ones it is made of.
std::vector<std::string> corpus() {
  proto::SimulatorCommand control;
  auto& ball = *control.mutable_control()->mutable_teleport_ball();
  for (auto set :
       {&proto::TeleportBall::set_x, &proto::TeleportBall::set_y, &proto::TeleportBall::set_z,
        &proto::TeleportBall::set_vx, &proto::TeleportBall::set_vy, &proto::TeleportBall::set_vz}) {
    (ball.*set)(0.5F);
  }
  ball.set_teleport_safely(true);
  ball.set_roll(true);
  for (unsigned number : {0U, 7U}) {
    auto& robot = *control.mutable_control()->add_teleport_robot();
    robot.mutable_id()->set_id(number);
    robot.mutable_id()->set_team(proto::YELLOW);
    robot.set_x(-1.5F);
    robot.set_y(1.5F);
    robot.set_orientation(1);
    robot.set_v_x(0.5F);
    robot.set_v_angular(2);
    robot.set_present(true);
    robot.set_by_force(number == 0);
  }
  control.mutable_control()->set_simulation_speed(2);

  proto::SimulatorCommand config;
  world::Geometry geometry;
  geometry.cameras = world::quarter_cameras(geometry.field);
  wire::encode(geometry, *config.mutable_config()->mutable_geometry());
  world::RobotSpecs specs;
  specs.id = {Team::Blue, 1};
  wire::encode(specs, *config.mutable_config()->add_robot_specs());
  auto& angles = *config.mutable_config()->mutable_robot_specs(0)->mutable_wheel_angles();
  angles.set_front_right(1);
  angles.set_back_right(2);
  angles.set_back_left(4);
  angles.set_front_left(5);
  config.mutable_config()->set_vision_port(10021);

  proto::SimulatorCommand realism;
  proto::RealismMatchday ours;
  ours.set_preset("harsh");
  ours.add_values()->set_key("radio.latency");
  ours.mutable_values(0)->set_value(3);
  realism.mutable_config()->mutable_realism_config()->add_custom()->PackFrom(ours);
  proto::RealismConfigErForce theirs;
  theirs.set_stddev_ball_p(0.001F);
  theirs.set_vision_delay(30'000'000);
  auto& any = *realism.mutable_config()->mutable_realism_config()->add_custom();
  any.set_type_url("type.googleapis.com/RealismConfigErForce");
  any.set_value(theirs.SerializeAsString());

  proto::RobotControl robots = bench::local(0, 2, 1, 3);
  robots.mutable_robot_commands(0)->set_kick_speed(5);
  robots.mutable_robot_commands(0)->set_dribbler_speed(3000);
  auto& second = *robots.add_robot_commands();
  second.set_id(1);
  second.mutable_move_command()->mutable_wheel_velocity()->set_back_left(1);
  return {control.SerializeAsString(), config.SerializeAsString(), realism.SerializeAsString(),
          robots.SerializeAsString()};
}

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed, "fuzz") {}

  std::string next(const std::vector<std::string>& corpus) {
    std::string bytes = corpus[random_.below(corpus.size())];
    switch (random_.below(6)) {
      case 0:  // cut
        bytes.resize(random_.below(bytes.size() + 1));
        break;
      case 1:
      case 2:  // a few bits the other way
        for (std::uint64_t i = random_.below(8) + 1; i > 0; --i) flip(bytes);
        break;
      case 3:  // noise
        bytes.resize(random_.below(300));
        for (char& c : bytes) c = byte();
        break;
      case 4:  // a piece of another one inside
        bytes.insert(random_.below(bytes.size() + 1), piece(corpus[random_.below(corpus.size())]));
        break;
      default:  // a piece missing, a byte changed
        bytes.erase(random_.below(bytes.size() + 1), random_.below(12));
        if (!bytes.empty()) bytes[random_.below(bytes.size())] = byte();
    }
    return bytes;
  }
  std::uint64_t below(std::uint64_t count) { return random_.below(count); }

 private:
  char byte() { return static_cast<char>(random_.below(256)); }
  void flip(std::string& bytes) {
    if (bytes.empty()) return;
    bytes[random_.below(bytes.size())] ^= static_cast<char>(1 << random_.below(8));
  }
  std::string piece(const std::string& from) {
    const std::size_t begin = random_.below(from.size());
    return from.substr(begin, random_.below(40));
  }
  world::RandomStream random_;
};

class Fuzz : public testing::Test {
 protected:
  void SetUp() override { before_ = google::protobuf::SetLogHandler(nullptr); }  // as the program does
  void TearDown() override { google::protobuf::SetLogHandler(before_); }

 private:
  google::protobuf::LogHandler* before_ = nullptr;
};

}  // namespace

TEST_F(Fuzz, NothingUnderstoodMeansNothingChanged) {
  const std::vector<std::string> seeds = corpus();
  Mutator mutator(2026);
  Bench b;
  int unreadable = 0;
  int understood = 0;
  constexpr int messages = 6000;
  for (int i = 0; i < messages; ++i) {
    const std::string bytes = mutator.next(seeds);
    const std::string before = fingerprint(b.server);
    std::string code;
    if (mutator.below(2) == 0) {
      proto::SimulatorResponse response;
      ASSERT_TRUE(response.ParseFromString(b.server.handle_control(bytes)));
      if (response.errors_size() > 0) code = response.errors(0).code();
    } else {
      const Team team = world::both_teams[mutator.below(2)];
      proto::RobotControlResponse response;
      ASSERT_TRUE(response.ParseFromString(b.server.handle_robots(team, bytes)));
      if (response.errors_size() > 0) code = response.errors(0).code();
      ASSERT_EQ(fingerprint(b.server), before) << "robot commands act in the next tick only";
    }
    if (code == "UNREADABLE" || code == "TOO_LONG") {
      ++unreadable;
      ASSERT_EQ(fingerprint(b.server), before);
    } else {
      ++understood;
    }
    if (i % 20 == 0) {
      for (const server::VisionPacket& packet : b.server.step()) ASSERT_LE(packet.bytes.size(), 8192U);
      const truth::Frame& truth = b.server.simulation().truth();
      ASSERT_TRUE(truth.ball.position.allFinite() && truth.ball.velocity.allFinite());
      for (const truth::Robot& robot : truth.robots) {
        ASSERT_TRUE(robot.position.allFinite() && robot.velocity.allFinite() &&
                    std::isfinite(robot.orientation));
      }
    }
  }
  // Both kinds in numbers, or the test tests nothing.
  EXPECT_GT(unreadable, messages / 10);
  EXPECT_GT(understood, messages / 10);
}

TEST_F(Fuzz, EveryCutOfAMessageIsHarmless) {
  const std::vector<std::string> seeds = corpus();
  Bench b;
  int unreadable = 0;
  for (const std::string& whole : seeds) {
    for (std::size_t size = 0; size <= whole.size(); ++size) {
      const std::string before = fingerprint(b.server);
      proto::SimulatorResponse response;
      ASSERT_TRUE(response.ParseFromString(b.server.handle_control(whole.substr(0, size))));
      if (response.errors_size() > 0 && response.errors(0).code() == "UNREADABLE") {
        ++unreadable;
        ASSERT_EQ(fingerprint(b.server), before);
      }
    }
  }
  EXPECT_GT(unreadable, 500);
}
