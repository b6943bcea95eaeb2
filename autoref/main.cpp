#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "autoref/automaton/pictures.h"
#include "autoref/calibrate_log.h"
#include "autoref/replay.h"
#include "sim/console/printable.h"
#include "sim/console/standard_output.h"

namespace {

int complain(const std::string& sentence) {
  std::cerr << "ssl-autoref: " << console::printable(sentence) << std::endl;
  return 2;
}

int ssl_autoref(int argc, char** argv) {
  using autoref::ReplayOptions;
  CLI::App app("ssl-autoref: what can be told of a recorded game: the referee's calls, a realism preset");
  app.require_subcommand(1);
  app.footer(
      "\nExit codes: 0 done; 2 bad input; 74 standard output cannot be written; 141 its reader has gone.");

  ReplayOptions options;
  CLI::App* replay = app.add_subcommand(
      "replay", "read a league log (.log or .log.gz) and print every call with its reason");
  replay->add_option("FILE", options.file, "the log")->required();
  replay->add_option("--rules", options.rules, "rule set; default: that of the log, or ssl-2015");
  replay->add_flag("--json", options.json, "one JSON object per line");
  const std::map<std::string, ReplayOptions::Mode> modes = {{"auto", ReplayOptions::Mode::Auto},
                                                            {"referee", ReplayOptions::Mode::Referee},
                                                            {"watch", ReplayOptions::Mode::Watch}};
  replay
      ->add_option(
          "--mode", options.mode,
          "referee: decide anew; watch: follow the recorded referee and print what the detectors see; "
          "auto: referee for logs of matchday, watch for all others")
      ->transform(CLI::CheckedTransformer(modes).description("{auto,referee,watch}"));

  autoref::CalibrateOptions calibration;
  CLI::App* calibrate = app.add_subcommand(
      "calibrate",
      "measure a league log: noise, bias, losses, ball and robots, as a realism preset; of a long one its "
      "beginning: 10 million images and objects, about 1.5 hours of four cameras");
  calibrate->add_option("FILE", calibration.file, "the log, .log or .log.gz")->required();
  calibrate->add_option("--out", calibration.out, "write the preset (TOML) there");
  calibrate->add_flag("--json", calibration.json, "print JSON instead of a table");

  std::string rules = "ssl-2015";
  const CLI::App* table = app.add_subcommand(
      "automaton", "print the table of transitions as JSON, for scripts/draw_automaton.py");
  CLI::App* positions =
      app.add_subcommand("positions", "print as JSON where the ball goes for free kicks, for the same");
  positions->add_option("--rules", rules, "rule set")->capture_default_str();

  const std::vector<std::string_view> known = {"replay", "calibrate", "automaton", "positions"};
  if (argc > 1 && argv[1][0] != '-' && std::ranges::find(known, argv[1]) == known.end()) {
    return complain("unknown command '" + std::string(argv[1]) +
                    "'; known are: replay, calibrate, automaton, positions");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    return complain(std::string(error.what()) + " (ssl-autoref --help shows what is known)");
  }
  try {
    if (*table) {
      std::cout << automaton::table_json();
      return 0;
    }
    if (*positions) {
      std::cout << automaton::positions_json(world::rule_set(rules));
      return 0;
    }
    if (*calibrate) return autoref::calibrate_log(calibration, std::cout, std::cerr);
    return autoref::replay(options, std::cout, std::cerr);
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  return console::run_program("ssl-autoref", [&] { return ssl_autoref(argc, argv); });
}
