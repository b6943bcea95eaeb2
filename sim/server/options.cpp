#include "sim/server/options.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <set>
#include <stdexcept>

#include "sim/network/udp.h"
#include "sim/server/realism_file.h"
#include "sim/server/server.h"
#include "sim/world/rules/rule_set.h"

namespace server {
namespace {

void require(bool holds, const std::string& sentence) {
  if (!holds) throw std::invalid_argument(sentence);
}

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(at, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

void check_port(const char* flag, int port) {
  require(port >= 0 && port <= 65535,
          fmt::format("--{} {}: ports go from 1 to 65535 (0: any free one)", flag, port));
}

void check_different(const char* flag, int port, const char* other_flag, int other_port) {
  require(port != other_port || port == 0,
          fmt::format("--{} {} and --{} {}: must not be the same", flag, port, other_flag, other_port));
}

}  // namespace

std::vector<int> parse_numbers(std::string_view text) {
  if (text == "none") return {};
  std::set<int> numbers;
  for (const std::string_view part : split(text, ',')) {
    const auto ends = split(part, '-');
    const auto first = whole_number(ends.front());
    const auto last = whole_number(ends.back());
    require(ends.size() <= 2 && first && last && *first >= 0 && *first <= *last &&
                *last <= world::max_robot_number,
            fmt::format("robot numbers \"{}\": must be like 0-5 or 1,4,7 or none, from 0 to {}", text,
                        world::max_robot_number));
    for (int n = *first; n <= *last; ++n) numbers.insert(n);
  }
  return {numbers.begin(), numbers.end()};
}

void check(const Options& options) {
  make_setup(options);
  robots(options);
  require(options.speed == 0 || (options.speed >= slowest_speed && options.speed <= fastest_speed),
          fmt::format("--speed {}: must be 0 (start paused) or from {} to {}", options.speed, slowest_speed,
                      fastest_speed));
  if (options.duration) {
    require(*options.duration > 0 && *options.duration <= 1e8,
            fmt::format("--duration {}: must be a positive number of seconds", *options.duration));
  }
  require(network::is_ipv4(options.interface),
          fmt::format("--interface {}: must be the IPv4 address of an interface of this machine, as "
                      "192.168.1.5 (127.0.0.1: only programs on this machine; 0.0.0.0: all interfaces)",
                      options.interface));
  require(network::is_multicast(options.vision_address),
          fmt::format("--vision-address {}: must be a multicast group, 224.0.0.0 to 239.255.255.255",
                      options.vision_address));
  require(options.vision_port >= 1 && options.vision_port <= 65535,
          fmt::format("--vision-port {}: ports go from 1 to 65535", options.vision_port));
  check_port("control-port", options.control_port);
  check_port("blue-port", options.blue_port);
  check_port("yellow-port", options.yellow_port);
  check_different("control-port", options.control_port, "blue-port", options.blue_port);
  check_different("control-port", options.control_port, "yellow-port", options.yellow_port);
  check_different("blue-port", options.blue_port, "yellow-port", options.yellow_port);
}

Setup make_setup(const Options& options) {
  engine::Realism realism = named_realism(options.realism);
  for (const std::string& text : options.set) {
    const std::size_t equals = text.find('=');
    const auto value = number(std::string_view(text).substr(equals + 1));
    require(equals != std::string::npos && value,
            fmt::format("--set {}: must be KEY=NUMBER, as vision.ball_sigma=0.001", text));
    engine::set(realism, text.substr(0, equals), *value);
  }
  const Setup setup = make_setup(world::rule_set(options.rules).field, realism, options.seed);
  check(setup);
  return setup;
}

world::PerTeam<std::vector<int>> robots(const Options& options) {
  const int count = world::rule_set(options.rules).robots_per_team;
  const std::string usual = fmt::format("0-{}", count - 1);
  return {.yellow = parse_numbers(options.yellow.value_or(usual)),
          .blue = parse_numbers(options.blue.value_or(usual))};
}

}  // namespace server
