// The whole program over real sockets on loopback, and its command line.
#include "sim/server/program.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <map>
#include <sstream>
#include <thread>

#include "sim/network/udp.h"
#include "tests/fakes/programs.h"
#include "tests/sim/server/bench.h"

namespace {

using network::Address;
using network::UdpSocket;
using testing::HasSubstr;
using testing::IsEmpty;
namespace proto = bench::proto;
using namespace std::chrono_literals;

constexpr const char* loopback = "127.0.0.1";
constexpr const char* group = "239.255.42.19";  // of our own: no real simulator is disturbed or heard

/// Free at the moment: a port that the system just gave away.
int free_port() { return UdpSocket::server({loopback, 0}).local().port; }

/// ssl-sim in a thread. Its end is bounded by the duration in any case.
class Running {
 public:
  explicit Running(server::Options options) {
    options.interface = loopback;
    options.vision_address = group;
    options.duration = 20;
    thread_ = std::thread([this, options] { server::run(options, stop_, out_, err_); });
  }
  ~Running() { stop(); }
  void stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }
  std::string out() const { return out_.str(); }  ///< only after `stop`
  std::string err() const { return err_.str(); }

 private:
  std::atomic<bool> stop_ = false;
  std::ostringstream out_, err_;
  std::thread thread_;
};

/// Waits for the next datagram for which `wanted` holds, at most 5 s.
bool wait_for(UdpSocket& socket, const std::function<bool(std::string_view)>& wanted) {
  UdpSocket* const sockets[] = {&socket};
  const auto deadline = network::Clock::now() + 5s;
  while (network::Clock::now() < deadline) {
    while (const auto datagram = socket.receive()) {
      if (wanted(datagram->bytes)) return true;
    }
    network::wait(sockets, deadline);
  }
  return false;
}

/// One question to a program that listens, and its answer, which may take 5 s.
template <class Answer, class Question>
Answer ask(UdpSocket& socket, int port, const Question& question) {
  Answer answer;
  EXPECT_TRUE(socket.send(question.SerializeAsString(), {loopback, static_cast<std::uint16_t>(port)}));
  EXPECT_TRUE(wait_for(socket, [&](std::string_view bytes) {
    EXPECT_TRUE(answer.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())));
    return true;
  })) << "no answer";
  return answer;
}

/// Runs ssl-sim; returns what it printed and "exit N".
std::string shell(const std::string& arguments) {
  const std::string command = fakes::bin_dir() + "/ssl-sim " + arguments + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), size);
  const int status = pclose(pipe);
  return text + "exit " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

TEST(Program, PlaysOverTheNetwork) {
  server::Options options;
  options.realism = "none";
  options.vision_port = free_port();
  options.control_port = free_port();
  options.blue_port = free_port();
  options.yellow_port = free_port();
  UdpSocket eyes =
      UdpSocket::multicast_receiver({group, static_cast<std::uint16_t>(options.vision_port)}, loopback);
  UdpSocket client = UdpSocket::server({loopback, 0});
  Running program(options);

  matchday::vision::SSL_WrapperPacket packet;
  const auto next = [&](const std::function<bool()>& wanted) {
    return wait_for(eyes, [&](std::string_view bytes) {
      EXPECT_TRUE(packet.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())));
      EXPECT_THAT(league::missing_required(packet, "ssl-vision HEAD"), IsEmpty());
      EXPECT_EQ(packet.source(), matchday::vision::SSL_SOURCE_OTHER);
      return wanted();
    });
  };
  ASSERT_TRUE(next([&] { return packet.has_geometry(); })) << "at the start";
  EXPECT_EQ(packet.geometry().calib_size(), 4);

  // Frames of all four cameras, each 1/60 s after the one before.
  std::map<unsigned, double> last;
  int frames = 0;
  ASSERT_TRUE(next([&] {
    if (!packet.has_detection()) return false;
    const auto& frame = packet.detection();
    if (last.contains(frame.camera_id())) {
      EXPECT_NEAR(frame.t_capture() - last[frame.camera_id()], 1.0 / 60, 2e-6) << "rounded to microseconds";
    }
    last[frame.camera_id()] = frame.t_capture();
    return ++frames == 40;
  }));
  EXPECT_EQ(last.size(), 4U);
  const double now =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  EXPECT_NEAR(packet.detection().t_sent(), now, 2) << "Unix time; a busy machine may be late";

  // The ball goes where it is told to, and everyone sees it.
  proto::SimulatorCommand command;
  command.mutable_control()->mutable_teleport_ball()->set_x(1.5);
  command.mutable_control()->mutable_teleport_ball()->set_y(-1.25);
  EXPECT_EQ(ask<proto::SimulatorResponse>(client, options.control_port, command).errors_size(), 0);
  EXPECT_TRUE(next([&] {
    return packet.detection().balls_size() == 1 && packet.detection().balls(0).x() == 1500 &&
           packet.detection().balls(0).y() == -1250;
  }));

  // Both teams are answered, with their own robots.
  const auto blue = ask<proto::RobotControlResponse>(client, options.blue_port, bench::local(2, 1));
  EXPECT_EQ(blue.errors_size(), 0);
  EXPECT_EQ(blue.feedback_size(), 6);
  const auto yellow = ask<proto::RobotControlResponse>(client, options.yellow_port, bench::local(9, 1));
  ASSERT_EQ(yellow.errors_size(), 1);
  EXPECT_EQ(yellow.errors(0).code(), "ROBOT_ABSENT");

  // A new geometry is sent at once, not after up to 3 s; and to the new port.
  const int new_port = free_port();
  UdpSocket new_eyes = UdpSocket::multicast_receiver({group, static_cast<std::uint16_t>(new_port)}, loopback);
  command.Clear();
  command.mutable_config()->set_vision_port(static_cast<unsigned>(new_port));
  auto& field = *command.mutable_config()->mutable_geometry()->mutable_field();
  field.set_field_length(8000);
  field.set_field_width(5000);
  EXPECT_EQ(ask<proto::SimulatorResponse>(client, options.control_port, command).errors_size(), 0);
  EXPECT_TRUE(wait_for(new_eyes, [&](std::string_view bytes) {
    EXPECT_TRUE(packet.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())));
    EXPECT_TRUE(packet.has_geometry()) << "the first packet at the new port";
    return packet.geometry().field().field_length() == 8000;
  }));

  // Paused: no frames, but answers.
  command.Clear();
  command.mutable_control()->set_simulation_speed(0);
  ask<proto::SimulatorResponse>(client, options.control_port, command);
  std::this_thread::sleep_for(50ms);
  while (new_eyes.receive()) {
  }
  std::this_thread::sleep_for(100ms);  // six ticks, if there were any
  while (const auto datagram = new_eyes.receive()) {
    ASSERT_TRUE(packet.ParseFromArray(datagram->bytes.data(), static_cast<int>(datagram->bytes.size())));
    EXPECT_FALSE(packet.has_detection());
  }
  EXPECT_EQ(
      ask<proto::RobotControlResponse>(client, options.blue_port, proto::RobotControl{}).feedback_size(), 6);

  program.stop();
  EXPECT_THAT(program.out(), HasSubstr("realism none, blue 0-5, yellow 0-5, speed 1, seed 1\n"));
  EXPECT_THAT(program.out(), HasSubstr("1 yellow messages answered, 1 parts refused; 0 datagrams not sent"));
  EXPECT_THAT(program.err(), HasSubstr("refused from yellow: 1 ROBOT_ABSENT"));
}

TEST(Program, SurvivesAFloodAndStillPlays) {
  server::Options options;
  options.realism = "none";
  options.vision_port = free_port();
  options.control_port = free_port();
  options.blue_port = free_port();
  options.yellow_port = free_port();
  UdpSocket client = UdpSocket::server({loopback, 0});
  UdpSocket eyes =
      UdpSocket::multicast_receiver({group, static_cast<std::uint16_t>(options.vision_port)}, loopback);
  Running program(options);
  ASSERT_TRUE(wait_for(eyes, [](std::string_view) { return true; }));
  for (int i = 0; i < 5000; ++i) {
    client.send(std::string(1000, '\xff'), {loopback, static_cast<std::uint16_t>(options.control_port)});
    client.send("\xff", {loopback, static_cast<std::uint16_t>(options.blue_port)});
  }
  while (eyes.receive()) {
  }
  int frames = 0;
  EXPECT_TRUE(wait_for(eyes, [&](std::string_view) { return ++frames == 60; })) << "frames still come";
  UdpSocket other = UdpSocket::server({loopback, 0});  // the first one has thousands of answers to read
  EXPECT_EQ(
      ask<proto::RobotControlResponse>(other, options.yellow_port, proto::RobotControl{}).feedback_size(), 6)
      << "a flood at other ports does not shut out this one";
  program.stop();
  const std::string told = program.err();
  EXPECT_THAT(told, HasSubstr("UNREADABLE"));
  EXPECT_LE(std::count(told.begin(), told.end(), '\n'), 22)
      << "one line in each of at most 20 s, one at the end";
}

TEST(CommandLine, HelpsAndRefuses) {
  EXPECT_THAT(shell("--help"), testing::AllOf(HasSubstr("--interface"), HasSubstr("exit 0")));
  EXPECT_THAT(shell("--version"), testing::AllOf(testing::StartsWith("ssl-sim 0."), HasSubstr("exit 0")));
  for (const char* flag : {"--durration", "--durration 5", "--durration=5", "--speed 2 --durration 5"}) {
    EXPECT_EQ(shell(flag), "ssl-sim: unknown flag '--durration'; see ssl-sim --help\nexit 2");
  }
  EXPECT_THAT(shell("harsh"), testing::AllOf(HasSubstr("harsh"), HasSubstr("see ssl-sim --help\nexit 2")));
  EXPECT_EQ(shell("--seed -1"),
            "ssl-sim: --seed: -1: must be a whole number, 0 or more; see ssl-sim --help\nexit 2");
  EXPECT_THAT(shell("--realism perfect"),
              HasSubstr("known are none, friendly, measured, harsh, or a file that ends in .toml\nexit 2"));
  EXPECT_THAT(shell("--interface 192.0.2.1"), testing::AllOf(HasSubstr("192.0.2.1"), HasSubstr("exit 2")));
}

TEST(CommandLine, NamesAllPortsThatAreTaken) {
  const UdpSocket first = UdpSocket::server({loopback, 0});
  const UdpSocket second = UdpSocket::server({loopback, 0});
  const std::string control = "--control-port " + std::to_string(first.local().port);
  const std::string yellow = "--yellow-port " + std::to_string(second.local().port);
  EXPECT_EQ(
      shell(control + " --blue-port 0 " + yellow),
      "ssl-sim: already in use on 127.0.0.1: " + control + ", " + yellow +
          "; choose other ports, and for a second ssl-sim also another --vision-port or --vision-address, "
          "since the frames of both would mix\nexit 2");
}

TEST(CommandLine, EndsByItselfAndBySignal) {
  const std::string ports = "--vision-address 239.255.42.19 --control-port 0 --blue-port 0 --yellow-port 0 ";
  EXPECT_THAT(shell(ports + "--duration 0.2"),
              testing::AllOf(HasSubstr("ssl-sim: vision 239.255.42.19:10020 by 127.0.0.1"),
                             HasSubstr("ssl-sim: stopped after 0.2 s"), HasSubstr("exit 0")));
  for (const char* signal : {"INT", "TERM"}) {
    const std::string text =
        shell(ports + "--duration 20 & pid=$!; sleep 0.5; kill -" + signal + " $pid; wait $pid");
    // At once, however late the signal is: not after its 20 seconds.
    EXPECT_THAT(text,
                testing::AllOf(HasSubstr("ssl-sim: stopped after "),
                               testing::Not(HasSubstr("ssl-sim: stopped after 20")), HasSubstr("exit 0")))
        << signal;
  }
}
