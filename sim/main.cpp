#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <iostream>
#include <stdexcept>
#include <string>

#include "sim/console/printable.h"
#include "sim/console/standard_output.h"
#include "sim/server/program.h"

namespace {

std::atomic<bool> stop = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

extern "C" void ask_to_stop(int) { stop = true; }

constexpr const char* footer = R"(
Teams and tools connect as to any simulator of the league: SSL-Vision frames by multicast, the simulation
protocol by UDP. Only programs on this machine are served unless --interface names another address.

  ssl-sim                                  two teams of six on the field of 2015
  ssl-sim --blue 0-10 --yellow none --realism none
  ssl-sim --set vision.ball_sigma=0.002 --set radio.latency=3
  ssl-sim --realism field.toml             as `ssl-autoref calibrate` or `matchday realism` wrote it
  ssl-sim --interface 192.168.1.5          for programs on other machines
  ssl-sim --control-port 20300 --blue-port 20301 --yellow-port 20302 --vision-port 20020
                                           a second one beside the first. It needs all four: two on one vision
                                           address show their frames in one picture, and neither can notice.

The protocol, error codes and limits: sim/server/README.md. Exit codes: 0 ended by --duration, Ctrl-C or TERM;
2 bad input or an address that cannot be used; 70 a mistake in ssl-sim itself; 74 standard output cannot be
written; 141 its reader has gone.)";

/// CLI11 would take a negative number for a very large one.
std::string not_negative(const std::string& word) {
  return word.starts_with('-') ? word + ": must be a whole number, 0 or more" : "";
}

/// CLI11 would complain of the flag's value too, and first.
void check_flags(const CLI::App& app, int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--") return;
    const std::string flag = word.substr(0, word.find('='));
    if (word.starts_with("--") && app.get_option_no_throw(flag) == nullptr) {
      throw std::invalid_argument("unknown flag '" + flag + "'; see ssl-sim --help");
    }
  }
}

int complain(const std::string& sentence, int code) {
  std::cerr << "ssl-sim: " << console::printable(sentence) << std::endl;
  return code;
}

int ssl_sim(int argc, char** argv) {
  server::Options options;
  CLI::App app("ssl-sim: the simulator in real time on the network, for teams of the RoboCup SSL");
  app.set_version_flag("--version", "ssl-sim " MATCHDAY_VERSION);
  app.footer(footer);
  app.add_option("--rules", options.rules, "rule set whose field is built")->capture_default_str();
  app.add_option("--realism", options.realism,
                 "none, friendly, measured, harsh, or a TOML file with a table [realism]")
      ->capture_default_str();
  app.add_option("--set", options.set, "KEY=NUMBER: change one number of it; may be given often")
      ->allow_extra_args(false);
  app.add_option("--blue", options.blue,
                 "robots on the field, as 0-5 or 1,4,7 or none; default: as the rules");
  app.add_option("--yellow", options.yellow, "the same");
  app.add_option("--seed", options.seed, "the only source of chance")
      ->check(not_negative)
      ->capture_default_str();
  app.add_option("--speed", options.speed, "simulated seconds in a second; 0: start paused")
      ->capture_default_str();
  app.add_option("--duration", options.duration, "stop after so many seconds");
  app.add_option("--interface", options.interface, "IPv4 address to listen on and to send multicast by")
      ->capture_default_str();
  app.add_option("--vision-address", options.vision_address,
                 "multicast group of the camera frames; one for each running ssl-sim, or one port")
      ->capture_default_str();
  app.add_option("--vision-port", options.vision_port, "their port")->capture_default_str();
  app.add_option("--control-port", options.control_port, "UDP port for SimulatorCommand")
      ->capture_default_str();
  app.add_option("--blue-port", options.blue_port, "UDP port for blue's RobotControl")->capture_default_str();
  app.add_option("--yellow-port", options.yellow_port, "UDP port for yellow's RobotControl")
      ->capture_default_str();
  try {
    check_flags(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help, --version
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + "; see ssl-sim --help", 2);
  } catch (const std::invalid_argument& error) {
    return complain(error.what(), 2);
  }
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  try {
    server::run(options, stop, std::cout, std::cerr);
    return 0;
  } catch (const std::runtime_error& error) {
    return complain(error.what(), 2);
  } catch (const std::invalid_argument& error) {
    return complain(error.what(), 2);
  } catch (const std::exception& error) {
    return complain(std::string("a mistake in the program: ") + error.what(), 70);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return console::run_program("ssl-sim", [&] { return ssl_sim(argc, argv); });
}
