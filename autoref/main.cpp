#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "autoref/automaton/pictures.h"
#include "autoref/replay.h"

int main(int argc, char** argv) {
  using autoref::ReplayOptions;
  CLI::App app("ssl-autoref: the referee over a recorded game");
  app.require_subcommand(1);

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

  std::string rules = "ssl-2015";
  const CLI::App* table = app.add_subcommand(
      "automaton", "print the table of transitions as JSON, for scripts/draw_automaton.py");
  CLI::App* positions =
      app.add_subcommand("positions", "print as JSON where the ball goes for free kicks, for the same");
  positions->add_option("--rules", rules, "rule set")->capture_default_str();

  const std::vector<std::string_view> known = {"replay", "automaton", "positions"};
  if (argc > 1 && argv[1][0] != '-' && std::ranges::find(known, argv[1]) == known.end()) {
    std::cerr << "ssl-autoref: unknown command '" << argv[1]
              << "'; known are: replay, automaton, positions\n";
    return 2;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    std::cerr << "ssl-autoref: " << error.what() << " (ssl-autoref --help shows what is known)\n";
    return 2;
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
    return autoref::replay(options, std::cout, std::cerr);
  } catch (const std::exception& error) {
    std::cerr << "ssl-autoref: " << error.what() << '\n';
    return 2;
  }
}
