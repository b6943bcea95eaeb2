#include "sim/server/program.h"

#include <fmt/format.h>
#include <google/protobuf/stubs/logging.h>

#include <algorithm>
#include <array>
#include <deque>
#include <ostream>
#include <utility>
#include <vector>

#include "sim/network/udp.h"
#include "sim/server/pacer.h"
#include "sim/server/report.h"
#include "sim/server/server.h"

namespace server {
namespace {

using network::Clock;
using network::UdpSocket;
using world::Team;

constexpr auto geometry_period = std::chrono::seconds{3};  // as SSL-Vision
constexpr auto report_period = std::chrono::seconds{1};
// A flood at one port leaves time for the ticks and the other ports: 32 datagrams in 1/60 s are 1920 a
// second, what a team needs is 60. Control has fewer, since a new set-up costs a millisecond. The rest waits
// in the system's buffer, which drops what is too much.
constexpr int most_commands = 32;
constexpr int most_controls = 8;
constexpr auto budget_period = std::chrono::nanoseconds{1'000'000'000 / world::ticks_per_second};

std::uint16_t port(int number) { return static_cast<std::uint16_t>(number); }

/// Listens on the ports one after the other, control, blue, yellow; a sentence names all that are taken.
std::vector<UdpSocket> listen(const Options& options) {
  std::vector<UdpSocket> sockets;
  std::string taken;
  for (const auto& [flag, number] :
       {std::pair{"control-port", options.control_port}, std::pair{"blue-port", options.blue_port},
        std::pair{"yellow-port", options.yellow_port}}) {
    try {
      sockets.push_back(UdpSocket::server({options.interface, port(number)}));
    } catch (const network::AddressInUse&) {
      taken += fmt::format("{}--{} {}", taken.empty() ? "" : ", ", flag, number);
    } catch (const network::NetworkError& error) {
      throw network::NetworkError(fmt::format("{} (choose with --{} and --interface)", error.what(), flag));
    }
  }
  if (!taken.empty()) {
    throw network::NetworkError(
        fmt::format("already in use on {}: {}; choose other ports, and for a second ssl-sim also another "
                    "--vision-port or --vision-address, since the frames of both would mix",
                    options.interface, taken));
  }
  return sockets;
}

wire::Epoch epoch_now() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {std::chrono::round<std::chrono::microseconds>(now).count() * 1000};
}

std::string numbers(const std::vector<int>& robots) {
  if (robots.empty()) return "none";
  std::string text;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    std::size_t last = i;
    while (last + 1 < robots.size() && robots[last + 1] == robots[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text += last == i ? fmt::format("{}", robots[i]) : fmt::format("{}-{}", robots[i], robots[last]);
    i = last;
  }
  return text;
}

/// One port: a socket, and what answers.
struct Port {
  UdpSocket& socket;
  int budget = 0;  // datagrams that may still be handled in this period

  template <class Answer>
  void serve(std::uint64_t& not_sent, const Answer& answer) {
    for (; budget > 0; --budget) {
      const auto datagram = socket.receive();
      if (!datagram) return;
      if (!socket.send(answer(datagram->bytes), datagram->sender)) ++not_sent;
    }
  }
};

class Program {
 public:
  Program(const Options& options, std::ostream& out, std::ostream& err)
      : options_(options),
        out_(out),
        err_(err),
        vision_(UdpSocket::multicast_sender(options.interface)),
        sockets_(listen(options)),
        control_{sockets_[0]},
        blue_{sockets_[1]},
        yellow_{sockets_[2]},
        start_(Clock::now()),
        epoch_(epoch_now()),
        server_(make_setup(options), robots(options), options.speed, port(options.vision_port), epoch_),
        pacer_(start_, server_.time(), options.speed) {}

  void run(const std::atomic<bool>& stop) {
    greet();
    const auto end =
        options_.duration
            ? start_ + std::chrono::round<Clock::duration>(std::chrono::duration<double>(*options_.duration))
            : Clock::time_point::max();
    for (Clock::time_point now = start_; !stop && now < end; now = Clock::now()) {
      serve(now);
      publish(now);
      report(now);
      if (now >= pacer_.due(server_.time())) {
        play(now);
      } else {
        sleep(end);
      }
    }
    take_leave();
  }

 private:
  void greet() {
    out_ << fmt::format(
                "ssl-sim: vision {}:{} by {}, control {}, blue {}, yellow {}; rules {}, realism {}, blue {}, "
                "yellow {}, speed {:g}, seed {}",
                options_.vision_address, server_.vision_port(), options_.interface,
                network::to_string(control_.socket.local()), network::to_string(blue_.socket.local()),
                network::to_string(yellow_.socket.local()), options_.rules, options_.realism,
                numbers(robots(options_).blue), numbers(robots(options_).yellow), options_.speed,
                options_.seed)
         << std::endl;
  }

  void serve(Clock::time_point now) {
    if (now >= next_budget_) {
      control_.budget = most_controls;
      blue_.budget = yellow_.budget = most_commands;
      next_budget_ = now + budget_period;
    }
    control_.serve(not_sent_, [this](std::string_view bytes) { return server_.handle_control(bytes); });
    blue_.serve(not_sent_,
                [this](std::string_view bytes) { return server_.handle_robots(Team::Blue, bytes); });
    yellow_.serve(not_sent_,
                  [this](std::string_view bytes) { return server_.handle_robots(Team::Yellow, bytes); });
    if (server_.speed() != pacer_.speed()) pacer_.set_speed(now, server_.time(), server_.speed());
  }

  void publish(Clock::time_point now) {
    if (now >= next_geometry_ || server_.geometry() != geometry_sent_ ||
        server_.vision_port() != geometry_port_) {
      geometry_sent_ = server_.geometry();
      geometry_port_ = server_.vision_port();
      next_geometry_ = now + geometry_period;
      send(geometry_sent_);
      ++geometries_;
    }
    for (; !waiting_.empty() && now >= pacer_.due(waiting_.front().due); waiting_.pop_front()) {
      send(waiting_.front().bytes);
      ++frames_;
    }
  }

  void send(const std::string& bytes) {
    if (!vision_.send(bytes, {options_.vision_address, server_.vision_port()})) ++not_sent_;
  }

  // A tick is played when it begins, so that its frames can leave at their own instants within it.
  void play(Clock::time_point now) {
    const Clock::duration skipped = pacer_.give_up(now, server_.time());
    if (skipped > Clock::duration::zero()) skipped_at_ = pacer_.speed();
    skipped_ += skipped;
    for (const VisionPacket& packet : server_.step()) waiting_.push_back(packet);
  }

  void sleep(Clock::time_point end) {
    auto deadline = std::min({end, pacer_.due(server_.time()), next_geometry_, next_budget_ + budget_period});
    if (!waiting_.empty()) deadline = std::min(deadline, pacer_.due(waiting_.front().due));
    std::vector<UdpSocket*> sockets;  // those that may not be read before the next period are not waited for
    for (Port* port : {&control_, &blue_, &yellow_}) {
      if (port->budget > 0) {
        sockets.push_back(&port->socket);
      } else {
        deadline = std::min(deadline, next_budget_);
      }
    }
    network::wait(sockets, deadline);
  }

  Troubles troubles() const {
    return {server_.control_counts(),
            {.yellow = server_.robot_counts(Team::Yellow), .blue = server_.robot_counts(Team::Blue)},
            not_sent_,
            skipped_,
            skipped_at_};
  }

  void report(Clock::time_point now) {
    if (now < next_report_) return;
    next_report_ = now + report_period;
    const Troubles present = troubles();
    const std::string text = news(reported_, present);
    if (!text.empty()) err_ << "ssl-sim: " << text << std::endl;
    reported_ = present;
  }

  void take_leave() {
    report(Clock::time_point::max() - report_period);
    std::uint64_t refused = 0;
    for (const PortCounts* counts : {&reported_.control, &reported_.robots.blue, &reported_.robots.yellow}) {
      for (const auto& [code, count] : counts->refused) refused += count;
    }
    out_ << fmt::format(
                "ssl-sim: stopped after {:.1f} s, {:.1f} s simulated: {} ticks, {} camera frames and {} "
                "geometries sent; {} control, {} blue and {} yellow messages answered, {} parts refused; {} "
                "datagrams not sent, {:.3f} s not played",
                std::chrono::duration<double>(Clock::now() - start_).count(), world::seconds(server_.time()),
                server_.simulation().tick(), frames_, geometries_, reported_.control.messages,
                reported_.robots.blue.messages, reported_.robots.yellow.messages, refused, not_sent_,
                std::chrono::duration<double>(skipped_).count())
         << std::endl;
  }

  Options options_;
  std::ostream& out_;
  std::ostream& err_;
  UdpSocket vision_;
  std::vector<UdpSocket> sockets_;  // of the three ports
  Port control_;
  Port blue_;
  Port yellow_;
  Clock::time_point start_;
  wire::Epoch epoch_;  // Unix time of start_
  Server server_;
  Pacer pacer_;

  std::deque<VisionPacket> waiting_;  // for their instants
  std::string geometry_sent_;
  std::uint16_t geometry_port_ = 0;
  Clock::time_point next_geometry_;
  Clock::time_point next_budget_;
  Clock::time_point next_report_;
  Clock::duration skipped_{};
  double skipped_at_ = 1;  // the speed that was in force
  Troubles reported_;
  std::uint64_t not_sent_ = 0;
  std::uint64_t frames_ = 0;
  std::uint64_t geometries_ = 0;
};

}  // namespace

void run(const Options& options, const std::atomic<bool>& stop, std::ostream& out, std::ostream& err) {
  check(options);
  // Protobuf writes a line about every text that is not UTF-8; one of ours a second is enough.
  google::protobuf::SetLogHandler(nullptr);
  Program(options, out, err).run(stop);
}

}  // namespace server
