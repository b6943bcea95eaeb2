#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/server/setup.h"

namespace server {

/// The command line of ssl-sim.
struct Options {
  std::string rules = "ssl-2015";
  std::string realism = "measured";  ///< preset or TOML file
  std::vector<std::string> set;      ///< "key=value", in this order, on top of it
  std::optional<std::string> blue;  ///< as "0-5" or "1,4,7" or "none"; nothing: as many as the rules let play
  std::optional<std::string> yellow;
  std::uint64_t seed = 1;
  double speed = 1;
  std::optional<double> duration;  ///< [s] of the clock on the wall

  std::string interface = "127.0.0.1";
  std::string vision_address = "224.5.23.2";
  int vision_port = 10020;
  int control_port = 10300;
  int blue_port = 10301;
  int yellow_port = 10302;
};

/// "0-5" or "1,4,7" or "0-2,9" or "none": robot numbers in rising order.
/// @throws std::invalid_argument
std::vector<int> parse_numbers(std::string_view text);

/// Everything that can be wrong with the command line is found here.
/// @throws std::invalid_argument in one sentence
void check(const Options& options);
Setup make_setup(const Options& options);
world::PerTeam<std::vector<int>> robots(const Options& options);

}  // namespace server
