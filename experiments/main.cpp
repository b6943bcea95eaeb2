// matchday: plays games and experiments. This file reads the command line; each command has its own file.
#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <iostream>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include "experiments/builds/builds.h"
#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/help.h"
#include "experiments/record/ledger.h"
#include "experiments/schedule/design.h"
#include "sim/console/printable.h"
#include "sim/console/standard_output.h"
#include "sim/wire/output_error.h"

namespace {

using commands::ExitCode;

const CLI::Range robot_number(0, 15);
const CLI::Range half_length(1.0, schedule::longest_half);  // [s]

/// CLI11 reads -3 as 2^64 - 3 and cuts what is too large.
CLI::Validator seed_up_to(std::uint64_t most) {
  return CLI::Validator(
      [most](const std::string& word) -> std::string {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error == std::errc{} && end == word.data() + word.size() && value <= most) return "";
        return word + ": must be a whole number from 0 to " + std::to_string(most);
      },
      "");
}
const CLI::Validator any_seed = seed_up_to(std::numeric_limits<std::uint64_t>::max());
const CLI::Validator design_seed = seed_up_to(std::numeric_limits<std::int64_t>::max());  // TOML's integers

/// A flag that takes away what is usual.
void add_no_preflight(CLI::App& app, bool& preflight) {
  app.add_flag_callback(
      "--no-preflight", [&preflight] { preflight = false; },
      "skip the short game that shows that both teams move");
}
const CLI::Range speed_factor(0.01, 1.0);

void add_team(CLI::App& app, const std::string& colour, commands::TeamOptions& team) {
  app.add_option("--" + colour, team.command,
                 "command of the " + colour + " team, as \"team-reference --flag\"")
      ->required();
  app.add_option("--" + colour + "-name", team.name, "its name, if not the program's");
  app.add_option("--" + colour + "-robots", team.robots, "numbers of its robots, as 0,1,2")
      ->delimiter(',')
      ->type_name("NUMBERS")
      ->check(CLI::Validator(robot_number).description("0 to 15"));
  app.add_option("--" + colour + "-speed", team.speed_factor, "factor of its speed and acceleration")
      ->check(speed_factor);
}

void add_realism(CLI::App& app, const std::string& flag, commands::RealismOptions& options) {
  app.add_option(flag, options.preset,
                 "none, friendly, measured, harsh, or a TOML file with a table [realism]")
      ->capture_default_str();
  app.add_option("--set", options.changes,
                 "change a number of it, as vision.ball_sigma=0.001; may be repeated")
      ->allow_extra_args(false);
}

void add_output(CLI::App& app, commands::OutputOptions& options) {
  app.add_option("--log", options.log, "write the game as a league log, FILE.log or FILE.log.gz");
  app.add_option("--record", options.recording,
                 "keep the teams' replies in FILE.replies, for `matchday continue`");
  app.add_option("--team-logs", options.team_logs, "folder for what the teams print");
  app.add_flag("--json", options.json, "print configuration and record as JSON");
  app.add_flag("--explain", options.explain,
               "after each call a line of JSON: what was seen, thresholds, alternatives");
}

void add_isolation(CLI::App& app, commands::IsolationOptions& options) {
  app.add_option(
      "--isolation", options.level,
      "what teams see of the machine: none (all), files (own home, temporary files and processes), "
      "network (no network either); default: the strongest that is possible");
  app.add_option("--visible", options.visible,
                 "file or folder of the home that isolated teams may read nevertheless; may be repeated")
      ->allow_extra_args(false);
}

/// The same for a worker, which is told what was chosen.
void add_worker_isolation(CLI::App& app, commands::IsolationOptions& options,
                          std::vector<std::filesystem::path>& hidden) {
  add_isolation(app, options);
  app.add_option("--hide", hidden)->allow_extra_args(false);
}

/// What a team may take of its own time, computing or asleep.
void add_team_time(CLI::App& app, schedule::TeamTime& time) {
  const auto add = [&](const char* flag, double& value, double least, const std::string& what) {
    app.add_option(flag, value, "seconds of its own time that a team may take for " + what)
        ->check(CLI::Range(least, 1e6))
        ->capture_default_str();
  };
  add("--team-reply", time.reply, 0.001, "a reply");
  add("--team-second", time.second, 0, "the replies of a simulated second; 0: any");
  add("--team-game", time.game, 0, "those of a game; 0: any");
}

void add_play(CLI::App& main, commands::PlayOptions& options) {
  CLI::App& app = *main.add_subcommand("play", "play one game and tell every call");
  add_team(app, "blue", options.blue);
  add_team(app, "yellow", options.yellow);
  app.add_option("--seed", options.seed, "the only source of chance")->check(any_seed)->capture_default_str();
  app.add_option("--rules", options.rules,
                 "rule set: ssl-2015 or paper; with -field-2014 or -division-a, that field")
      ->capture_default_str();
  add_realism(app, "--realism", options.realism);
  app.add_option("--half-length", options.half_length, "seconds of a half, if not the rule set's")
      ->check(half_length);
  app.add_flag("--winner", options.winner, "a draw is followed by extra time and a penalty shoot-out");
  app.add_flag("--blue-on-negative-half", options.blue_on_negative_half, "blue defends the goal at -x first");
  app.add_flag("--blue-kicks-off", options.blue_kicks_off, "blue has the first kickoff");
  add_isolation(app, options.isolation);
  add_team_time(app, options.team_time);
  add_output(app, options.output);
}

void add_continue(CLI::App& main, commands::ContinueOptions& options) {
  CLI::App& app = *main.add_subcommand(
      "continue", "play a recorded game again, to its end without teams, or on from a moment with live ones");
  app.add_option("recording", options.recording, "what `matchday play --record` wrote")->required();
  app.add_option("--from", options.from,
                 "seconds of the match at which live teams take over; no game is longer than 2400")
      ->check(CLI::Range(0.0, 2400.0));
  app.add_option("--blue", options.blue, "another command for the blue team");
  app.add_option("--yellow", options.yellow, "another command for the yellow team");
  add_isolation(app, options.isolation);
  add_output(app, options.output);
}

void add_run(CLI::App& main, commands::RunOptions& options) {
  CLI::App& app = *main.add_subcommand(
      "run", "play a design until all its games are in the ledger, then print its table");
  app.add_option("design", options.design, "design file, see experiments/designs/README.md")->required();
  app.add_option("--out", options.out, "result folder; default: results/<name of the design>");
  app.add_option("--workers", options.workers, "games at a time; default: one per processor")
      ->check(CLI::Range(1, 1024));
  add_no_preflight(app, options.preflight);
  app.add_option("--worker", options.worker)->group("");  // for tests
}

void add_plan(CLI::App& main, commands::PlanOptions& options) {
  CLI::App& app = *main.add_subcommand("plan", "say how long a design takes here and what it can show");
  app.add_option("design", options.design, "design file, see experiments/designs/README.md")->required();
  app.add_option("--from", options.from,
                 "result folder with games of these teams, for their speed and spread");
  app.add_option("--workers", options.workers, "games at a time, if not one per processor")
      ->check(CLI::Range(1, 1024));
}

void add_compare(CLI::App& main, commands::CompareOptions& options) {
  CLI::App& app = *main.add_subcommand(
      "compare", "build two revisions of a team and let them play: is the second better than the first?");
  app.add_option("base", options.base, "branch, tag or commit to be compared with: team B")->required();
  app.add_option("next", options.next, "branch, tag or commit that should be better: team A")->required();
  app.add_option("--team-repo", options.repository, "git repository of the team")->capture_default_str();
  app.add_option("--build", options.build, "builds a checkout, for the shell, as \"make -j4\"");
  app.add_option("--run", options.run, "starts the team, seen from the checkout, as \"build/my-team --flag\"")
      ->required();
  app.add_option("--games", options.games, "even number; with --sequential at most so many")
      ->capture_default_str();
  app.add_flag("--sequential", options.sequential, "stop as soon as a sequential test has its answer");
  app.add_option("--h1", options.h1,
                 "of that test: by how many standard deviations of a game A should be better")
      ->capture_default_str();
  app.add_option("--seed", options.seed, "the only source of chance")
      ->check(design_seed)
      ->capture_default_str();
  app.add_option("--rules", options.rules, "rule set")->capture_default_str();
  app.add_option("--realism", options.realism, "preset: none, friendly, measured, harsh")
      ->capture_default_str();
  app.add_option("--half-length", options.half_length, "seconds of a half, if not the rule set's")
      ->check(half_length);
  add_isolation(app, options.isolation);
  app.add_option("--out", options.run_options.out, "result folder, if not results/compare-BASE-NEXT-COMMITS");
  app.add_option("--workers", options.run_options.workers, "games at a time, if not one per processor")
      ->check(CLI::Range(1, 1024));
  add_no_preflight(app, options.run_options.preflight);
  app.add_option("--worker", options.run_options.worker)->group("");
}

void add_report(CLI::App& main, commands::ReportOptions& options) {
  CLI::App& app =
      *main.add_subcommand("report", "print the table of a result folder, or write its page or figures");
  app.add_option("folder", options.folder, "result folder")->required();
  CLI::Option* format = app.add_option("--format", options.format, "text, markdown, csv, json or latex");
  format->capture_default_str();
  app.add_flag("--html", options.html, "write report.html in the folder: tables, figures, health, games")
      ->excludes(format);
  app.add_option("--figures", options.figures, "write the figures as SVG into this folder (needs gnuplot)")
      ->excludes(format);
}

/// What a command may do that starts the programs of a folder, which somebody else may have made.
void add_live(CLI::App& app, commands::LiveOptions& options) {
  app.add_option(
         "--isolation", options.isolation.level,
         "what they see of the machine: none (all), files, network, see matchday play --help; default: the "
         "strongest that is possible, whatever the folder says; where none is, they are not started")
      ->type_name("LEVEL");
  app.add_option("--visible", options.isolation.visible,
                 "file or folder of the home that they may read nevertheless; may be repeated")
      ->allow_extra_args(false);
  app.add_flag("--build", options.build,
               "build teams from git with the commands that the folder names; default: they are not played");
}

void add_replay(CLI::App& main, commands::ReplayOptions& options) {
  CLI::App& app =
      *main.add_subcommand("replay", "play one game of a result folder again and compare its hash");
  app.add_option("folder", options.folder, "result folder")->required();
  app.add_option("game", options.game, "name of the game, as half-speed-0003-1")->required();
  app.add_option("--log", options.log, "write the game as a league log, FILE.log or FILE.log.gz");
  app.add_option("--team-logs", options.team_logs, "folder for what the teams print");
  app.add_flag("--recorded", options.recorded,
               "from the teams' recorded replies instead of live teams; kept of faulty and sampled games");
  add_live(app, options.live);
}

void add_verify(CLI::App& main, commands::VerifyOptions& options) {
  CLI::App& app = *main.add_subcommand(
      "verify", "say whether the rows and files of a result folder are what was written, and by whom");
  app.add_option("folder", options.folder, "result folder")->required();
  app.add_option("--sample", options.sample, "games to be played again, to compare their hashes")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  app.add_flag("--json", options.json, "print all findings as JSON");
  add_live(app, options.live);
}

void add_bench(CLI::App& main, bench::BenchOptions& options, commands::RealismOptions& realism,
               std::string& isolation) {
  CLI::App& app =
      *main.add_subcommand("bench", "play the standard game and print what each part of a tick costs");
  app.add_option("--seed", options.game.seed, "the only source of chance")
      ->check(any_seed)
      ->capture_default_str();
  add_realism(app, "--realism", realism);
  app.add_option("--half-length", options.game.half_length, "seconds of a half, if not the rule set's")
      ->check(half_length);
  app.add_option("--cpu", options.cpu, "processor for host and teams; -1: wherever the system likes")
      ->capture_default_str();
  app.add_option("--isolation", isolation, "of the teams: none, files, network")->capture_default_str();
  app.add_option("--workers", options.workers,
                 "games at once, for the games per hour: 0 for none, -1 for one per processor")
      ->check(CLI::Range(-1, 1024))
      ->capture_default_str();
  CLI::Option* json = app.add_flag("--json", options.as_json, "print JSON");
  app.add_option("--compare", options.compare, "FILE of an older `bench --json`: a table of both")
      ->excludes(json);
}

void add_show_realism(CLI::App& main, commands::RealismOptions& options) {
  CLI::App& app = *main.add_subcommand("realism", "print a preset with the meaning and range of every key");
  add_realism(app, "preset", options);
}

void add_judge(CLI::App& main, commands::JudgeOptions& options) {
  CLI::App& app = *main.add_subcommand(
      "judge", "play games of a design, compare the referee's calls with the truth, and write the tables");
  app.add_option("design", options.design, "design file, see experiments/designs/README.md")->required();
  app.add_option("--out", options.out, "result folder; default: results/judge-<name of the design>");
  app.add_option("--games", options.games, "only so many of its games")->check(CLI::Range(1, 1000000));
  app.add_option("--workers", options.workers, "games at a time; default: one per processor")
      ->check(CLI::Range(1, 1024));
  app.add_option("--shadow", options.shadows,
                 "compare another referee too, as touch=accel+line or vision.ball_sigma=0.002, or an outside "
                 "autoref, "
                 "net:COMMAND; may be repeated; rules=paper, the paper's referee, is always compared")
      ->allow_extra_args(false);
  app.add_option("--net-speed", options.net_speed, "pace of outside autorefs, in real times")
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  app.add_option("--show", options.show,
                 "only play one game again and tell a passage tick by tick: GAME:FIRST-LAST, as failures.csv "
                 "names it");
  app.add_option("--save", options.save,
                 "with --show: write the passage as a recorded scenario, FILE.log.gz and FILE.json");
  app.add_flag("--sweep", options.sweep, "compare referees with worse and better eyes: 14 shadows");
  auto* keep = app.add_option("--keep", options.keep, "record the games in that folder, 80 MB each");
  app.add_option("--again", options.again,
                 "judge the games recorded in that folder with the referee of today; nothing is played")
      ->check(CLI::ExistingDirectory)
      ->excludes(keep);
}

void add_judge_game(CLI::App& main, commands::JudgeGameOptions& options) {
  CLI::App& app = *main.add_subcommand("judge-game", "one game for judge")->group("");
  app.add_option("job", options.job)->required();
  app.add_option("result", options.result)->required();
  add_worker_isolation(app, options.isolation, options.hidden);
}

void add_worker(CLI::App& main, commands::WorkerOptions& options) {
  CLI::App& app = *main.add_subcommand("worker", "play one game for a runner")->group("");
  app.add_option("job", options.job)->required();
  app.add_option("result", options.result)->required();
  app.add_option("--team-memory", options.team_memory, "[MiB]");
  app.add_option("--output", options.output, "[MiB]");
  add_worker_isolation(app, options.isolation, options.hidden);
  add_team_time(app, options.team_time);
}

/// CLI11 would only say that a command is missing.
void check_command(const CLI::App& app, const std::string& word) {
  std::string known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == word) return;
    if (!command->get_group().empty()) known += (known.empty() ? "" : ", ") + command->get_name();
  }
  throw std::invalid_argument("unknown command '" + word + "'; known are: " + known);
}

/// CLI11 would complain of a missing flag first, which hides the misspelt one.
void check_flags(const CLI::App& app, int argc, char** argv) {
  const auto named = [&](const CLI::App* command) { return argc > 1 && command->get_name() == argv[1]; };
  const std::vector<const CLI::App*> commands = app.get_subcommands(named);
  if (commands.empty()) return;
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (!word.starts_with("--") || word == "--") continue;
    const std::string flag = word.substr(0, word.find('='));
    if (commands.front()->get_option_no_throw(flag) == nullptr) {
      throw std::invalid_argument("unknown flag '" + flag + "'; see matchday " + argv[1] + " --help");
    }
  }
}

int complain(const std::string& sentence, int code) {
  std::cerr << "matchday: " << console::printable(sentence) << std::endl;
  return code;
}

int matchday(int argc, char** argv) {
  CLI::App app("Plays refereed robot soccer in simulation and says which team is better.", "matchday");
  app.set_version_flag("--version", "matchday " MATCHDAY_VERSION);
  app.require_subcommand(1);
  commands::PlayOptions play;
  commands::ContinueOptions continuation;
  commands::RunOptions run;
  commands::PlanOptions plan;
  commands::CompareOptions compare;
  commands::ReportOptions report;
  commands::ReplayOptions replay;
  commands::VerifyOptions verify;
  commands::WorkerOptions worker;
  commands::JudgeOptions judge;
  commands::JudgeGameOptions judge_game;
  bench::BenchOptions bench;
  commands::RealismOptions bench_realism;
  std::string bench_isolation = "none";  // so that figures of all machines can be compared
  commands::RealismOptions realism;
  add_play(app, play);
  add_continue(app, continuation);
  add_run(app, run);
  add_plan(app, plan);
  add_compare(app, compare);
  add_report(app, report);
  add_replay(app, replay);
  add_verify(app, verify);
  add_bench(app, bench, bench_realism, bench_isolation);
  add_show_realism(app, realism);
  add_worker(app, worker);
  add_judge(app, judge);
  add_judge_game(app, judge_game);
  app.footer(commands::footer());  // after them: they would inherit it
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    command->footer(commands::footer_of(command->get_name()));

  if (argc > 1 && argv[1][0] != '-') check_command(app, argv[1]);
  check_flags(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help, --version
  } catch (const CLI::ParseError& error) {
    const std::vector<CLI::App*> used = app.get_subcommands();
    const std::string where = used.empty() ? "" : used.front()->get_name() + " ";
    return complain(std::string(error.what()) + "; see matchday " + where + "--help", ExitCode::bad_input);
  }

  if (app.got_subcommand("play")) return commands::play(play);
  if (app.got_subcommand("continue")) return commands::continue_game(continuation);
  if (app.got_subcommand("plan")) return commands::plan(plan);
  if (app.got_subcommand("report")) return commands::report(report);
  if (app.got_subcommand("replay")) return commands::replay(replay);
  if (app.got_subcommand("verify")) {
    verify.version = MATCHDAY_VERSION;
    return commands::verify(verify);
  }
  if (app.got_subcommand("worker")) return commands::worker(worker);
  if (app.got_subcommand("judge-game")) return commands::judge_game(judge_game);
  if (app.got_subcommand("judge")) {
    judge.version = MATCHDAY_VERSION;
    judge.command_line.assign(argv, argv + argc);
    return commands::judge(judge);
  }
  if (app.got_subcommand("bench")) return commands::bench(bench, bench_realism, bench_isolation);
  if (app.got_subcommand("realism")) return commands::realism(realism);
  if (app.got_subcommand("compare")) {
    compare.run_options.version = MATCHDAY_VERSION;
    compare.run_options.command_line.assign(argv, argv + argc);
    return commands::compare(compare);
  }
  run.version = MATCHDAY_VERSION;
  run.command_line.assign(argv, argv + argc);
  return commands::run(run);
}

/// The same with every failure as one sentence.
int guarded(int argc, char** argv) {
  try {
    return matchday(argc, argv);
  } catch (const builds::Interrupted& interrupted) {
    complain(interrupted.what(), ExitCode::signal_base);
    return ExitCode::signal_base + interrupted.signal;
  } catch (const record::StorageError& error) {
    return complain(error.what(), ExitCode::storage);
  } catch (const wire::OutputError& error) {
    return complain(error.what(), console::cannot_print);
  } catch (const std::invalid_argument& error) {
    return complain(error.what(), ExitCode::bad_input);
  } catch (const std::system_error& error) {
    return complain(error.what(), ExitCode::storage);
  } catch (const std::runtime_error& error) {
    return complain(error.what(), ExitCode::bad_input);
  } catch (const std::exception& error) {
    return complain(std::string("internal error: ") + error.what(), ExitCode::internal);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return console::run_program("matchday", [&] { return guarded(argc, argv); });
}
