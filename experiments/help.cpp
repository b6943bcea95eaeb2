#include "experiments/help.h"

namespace commands {
namespace {

constexpr const char* exit_codes = R"(
Exit codes: 0 done, of a sequential test: A is better; 1 replay: the game went differently; 2 bad input; 3 run: the
teams cannot play, says the short game before the first one; 4 too many void games, or play: the game ended by a
fault, or verify: not everything could be verified; 5 trouble with a result folder, or verify: it is not as written;
10 sequential test: A is not better; 11 undecided when all games were played; 70 a mistake in matchday itself; 74
standard output, or the file of --log or --record, cannot be written; 129, 130 and 143 interrupted by HUP, Ctrl-C and TERM (run: the same command
continues); 141 whoever read standard output has gone.)";
constexpr const char* short_footer = "\nExit codes: matchday --help tells them.";
constexpr const char* verify_footer = R"(
Finds damage and what does not fit together; who computes all checksums anew is found only by games that go differently.
Games are played again from the teams' recorded replies where these were kept. Where not, and when the programs on this
machine are those that played, THIS STARTS THE PROGRAMS THAT THE FOLDER NAMES, isolated; --sample 0 starts nothing.)";
constexpr const char* replay_footer = R"(
Without --recorded THIS STARTS THE PROGRAMS THAT THE FOLDER NAMES, isolated.)";
constexpr const char* design_footer = R"(
A team loses a game by forfeit when it takes more of its own time, computing or asleep, than the design's [limits]
allow: team_reply (5 s, for a reply), team_second (20 s, for the replies of a simulated second), team_game (1440 s, for
those of a game). What the machine delays does not count.)";

}  // namespace

std::string footer() { return exit_codes; }

std::string footer_of(const std::string& command) {
  std::string text;
  if (command == "run" || command == "plan") text = design_footer;
  if (command == "verify") text = verify_footer;
  if (command == "replay") text = replay_footer;
  return text + short_footer;
}

}  // namespace commands
