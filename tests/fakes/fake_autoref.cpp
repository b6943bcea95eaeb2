// An outside autoref, as simple as can be: it finds the game controller by the referee's packets, registers,
// and reports every ball that is outside the lines in three images running while it is in play.

#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>

#include "sim/network/udp.h"
#include "sim/proto/referee.pb.h"
#include "sim/proto/vision.pb.h"
#include "tests/fakes/controller.h"

namespace {

namespace proto = matchday::referee;

constexpr double reach = 0.13;  // [m] centre of a robot to a ball that it may have touched
constexpr int images_outside = 3;

class Autoref {
 public:
  void hear(const proto::Referee& message) {
    const auto command = message.command();
    in_play_ = command == proto::Referee::NORMAL_START || command == proto::Referee::FORCE_START ||
               command == proto::Referee::DIRECT_FREE_YELLOW || command == proto::Referee::DIRECT_FREE_BLUE ||
               command == proto::Referee::INDIRECT_FREE_YELLOW ||
               command == proto::Referee::INDIRECT_FREE_BLUE;
    if (message.command_counter() != counter_) reported_ = false;
    counter_ = message.command_counter();
  }

  std::optional<proto::GameEvent> see(const matchday::vision::SSL_WrapperPacket& packet) {
    if (packet.has_geometry()) {
      half_length_ = packet.geometry().field().field_length() / 2000.0;
      half_width_ = packet.geometry().field().field_width() / 2000.0;
    }
    if (!packet.has_detection() || packet.detection().balls().empty()) return std::nullopt;
    const auto& image = packet.detection();
    const double x = image.balls(0).x() / 1000.0;
    const double y = image.balls(0).y() / 1000.0;
    const auto near = [&](const auto& robots, proto::Team team) {
      for (const auto& robot : robots) {
        if (std::hypot(robot.x() / 1000.0 - x, robot.y() / 1000.0 - y) > reach) continue;
        team_ = team;
        robot_ = robot.robot_id();
      }
    };
    near(image.robots_yellow(), proto::YELLOW);
    near(image.robots_blue(), proto::BLUE);

    const double radius = 0.0215;
    const bool over_touch_line = std::abs(y) > half_width_ + radius;
    const bool over_goal_line = std::abs(x) > half_length_ + radius;
    if (!over_touch_line && !over_goal_line) {
      outside_ = 0;
      return std::nullopt;
    }
    if (outside_++ == 0) since_ = image.t_capture();
    if (outside_ < images_outside || reported_ || !in_play_ || !team_) return std::nullopt;
    reported_ = true;
    proto::GameEvent event;
    event.set_type(over_goal_line ? proto::GameEvent::BALL_LEFT_FIELD_GOAL_LINE
                                  : proto::GameEvent::BALL_LEFT_FIELD_TOUCH_LINE);
    auto& left = over_goal_line ? *event.mutable_ball_left_field_goal_line()
                                : *event.mutable_ball_left_field_touch_line();
    left.set_by_team(*team_);
    left.set_by_bot(robot_);
    left.mutable_location()->set_x(static_cast<float>(x));
    left.mutable_location()->set_y(static_cast<float>(y));
    event.set_created_timestamp(static_cast<std::uint64_t>(since_ * 1e6));
    return event;
  }

 private:
  double half_length_ = 4.5, half_width_ = 3;  // [m]
  bool in_play_ = false, reported_ = false;
  std::uint32_t counter_ = 0;
  std::optional<proto::Team> team_;
  std::uint32_t robot_ = 0;
  int outside_ = 0;   // images running
  double since_ = 0;  // [s, Unix] of the first of them
};

void run() {
  network::UdpSocket vision = network::UdpSocket::multicast_receiver({"224.5.23.2", 10006}, "127.0.0.1");
  network::UdpSocket referee = network::UdpSocket::multicast_receiver({"224.5.23.1", 10003}, "127.0.0.1");
  network::UdpSocket* const both[] = {&vision, &referee};
  std::optional<fakes::Controller> controller;
  Autoref autoref;
  proto::Referee message;
  matchday::vision::SSL_WrapperPacket packet;
  while (true) {
    network::wait(both, network::Clock::now() + std::chrono::seconds{1});
    while (const auto datagram = referee.receive()) {
      if (!controller) controller.emplace(datagram->sender.host, "fake-autoref");
      if (message.ParsePartialFromArray(datagram->bytes.data(), static_cast<int>(datagram->bytes.size()))) {
        autoref.hear(message);
      }
    }
    while (const auto datagram = vision.receive()) {
      if (!packet.ParsePartialFromArray(datagram->bytes.data(), static_cast<int>(datagram->bytes.size())))
        continue;
      const auto event = autoref.see(packet);
      if (!event || !controller) continue;
      proto::AutoRefToController report;
      *report.mutable_game_event() = *event;
      controller->send(report);
    }
  }
}

}  // namespace

int main() {
  try {
    run();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
