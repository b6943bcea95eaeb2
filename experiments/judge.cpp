#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <charconv>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/host/play.h"
#include "experiments/judge/failures.h"
#include "experiments/judge/game_file.h"
#include "experiments/judge/net/namespace.h"
#include "experiments/judge/tables.h"
#include "experiments/process/child.h"
#include "experiments/process/whole_file.h"
#include "experiments/record/ledger.h"
#include "experiments/runner/manifest.h"
#include "experiments/runner/program_files.h"
#include "experiments/runner/result_folder.h"
#include "experiments/runner/signals.h"
#include "experiments/schedule/command_line.h"
#include "experiments/schedule/schedule.h"
#include "experiments/start.h"
#include "sim/files/regular_file.h"
#include "sim/wire/match.h"

namespace commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* recording_ending = ".judged";
constexpr std::size_t longest_settings = std::size_t{64} << 20;  // [bytes] ours: jobs and logs have some KiB

std::string own_program() { return fs::read_symlink("/proc/self/exe").string(); }

std::vector<int> processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  ::sched_getaffinity(0, sizeof set, &set);
  std::vector<int> found;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(static_cast<std::size_t>(cpu), &set)) found.push_back(cpu);
  }
  return found;
}

std::string read(const fs::path& file) {
  return fs::exists(file) ? files::text_of(file, longest_settings) : "";
}

/// The games of one design that are judged into one folder, each into a file of its own.
class Judging {
 public:
  Judging(const JudgeOptions& options, const schedule::Design& design)
      : isolation_(chosen_isolation(options.again.empty() ? design.isolation : process::Isolation::None,
                                    options.design.string() + ": isolation =")),
        visible_(visible_paths(design.visible, options.design.string() + ": visible =")),
        folder_(options.out.empty() ? fs::path("results") / ("judge-" + design.name) : options.out),
        keep_(options.keep),
        again_(options.again) {
    if (!keep_.empty() && fs::exists(keep_) && !fs::is_directory(keep_)) {
      throw std::invalid_argument("--keep " + keep_.string() +
                                  ": is no folder; give one, or a name that is free");
    }
    if (design.conditions.size() > 1) {
      for (const schedule::Condition& condition : design.conditions) {
        if (condition.realism.preset != design.conditions.front().realism.preset) {
          throw std::invalid_argument(design.name +
                                      ": its conditions differ in realism; judge one realism at a time");
        }
      }
    }
    std::vector<std::string> shadows = {"rules=paper"};
    shadows.insert(shadows.end(), options.shadows.begin(), options.shadows.end());
    for (std::string text : shadows) {
      if (text.starts_with("net:") && options.net_speed != 1)
        text.insert(3, fmt::format("@{}", options.net_speed));
      add(judge::parse_shadow(text));
      if (!shadows_.back().command.empty()) judge::check_network_namespace();
    }
    if (options.sweep) {
      for (const judge::ShadowConfig& shadow : judge::sweeps()) add(shadow);
    }
    std::size_t games = schedule::game_count(design);
    if (options.games > 0) games = std::min(games, static_cast<std::size_t>(options.games));
    for (std::size_t n = 0; n < games; ++n) games_.push_back(schedule::game(design, n));
    for (std::size_t n = 0; n < games_.size() && !again_.empty(); ++n) {
      if (!fs::exists(again_ / recording(n))) {
        throw std::invalid_argument("--again " + again_.string() + ": " + recording(n) +
                                    " is not there; give the folder of matchday judge " +
                                    options.design.string() + " --keep FOLDER, or fewer --games");
      }
    }
    identify(options, design);
    // What was judged here before stays in the tables when fewer games are asked for now.
    for (std::size_t n = games; n < schedule::game_count(design); ++n) {
      games_.push_back(schedule::game(design, n));
      if (!fs::exists(result_file(games_.size() - 1))) games_.pop_back();
    }
  }

  const fs::path& folder() const { return folder_; }
  const std::string& isolation() const { return isolation_.sentence; }
  std::size_t count() const { return games_.size(); }
  const std::vector<judge::ShadowConfig>& shadows() const { return shadows_; }

  std::vector<std::size_t> open() const {
    std::vector<std::size_t> open;
    for (std::size_t n = 0; n < games_.size(); ++n) {
      if (!fs::exists(result_file(n))) open.push_back(n);
    }
    return open;
  }

  /// Plays what is missing; the signal that ended it early.
  std::optional<int> play(int workers) {
    runner::Signals signals;
    const std::vector<int> cpus = processors();
    std::vector<std::size_t> waiting = open();
    std::ranges::reverse(waiting);
    std::vector<std::pair<std::size_t, std::unique_ptr<process::Child>>> slots(
        workers > 0 ? static_cast<std::size_t>(workers) : cpus.size());
    while (true) {
      bool busy = false;
      for (std::size_t n = 0; n < slots.size(); ++n) {
        auto& [game, child] = slots[n];
        if (child && child->has_ended()) collect(game, *std::exchange(child, nullptr));
        if (!child && !waiting.empty() && faults_ < most_faults) {
          game = waiting.back();
          waiting.pop_back();
          child = start(game, cpus[n % cpus.size()]);
        }
        if (child) {
          child->drain();
          busy = true;
        }
      }
      if (!busy) return std::nullopt;
      if (const auto signal = signals.wait(std::chrono::milliseconds{20})) {
        for (auto& [game, child] : slots) {
          if (child) child->stop(std::chrono::milliseconds{3000});
        }
        return signal;
      }
    }
  }
  /// What the command ends with when not all games were judged.
  int exit_code() const { return refused_ ? bad_input : faults; }

  std::vector<judge::GameResult> results() const {
    std::vector<judge::GameResult> results;
    for (std::size_t n = 0; n < games_.size(); ++n) {
      if (auto result = judge::read_game(result_file(n))) results.push_back(*std::move(result));
    }
    return results;
  }

 private:
  static constexpr int most_faults = 3;

  void add(const judge::ShadowConfig& shadow) {
    if (std::ranges::find(shadows_, shadow.name, &judge::ShadowConfig::name) != shadows_.end()) return;
    shadows_.push_back(shadow);
  }
  std::string id(std::size_t n) const { return record::game_id(games_[n].key); }
  std::string recording(std::size_t n) const { return id(n) + recording_ending; }
  fs::path result_file(std::size_t n) const { return folder_ / "games" / (id(n) + ".jsonl"); }

  /// One folder, one experiment: what decides its numbers is written once and compared ever after.
  void identify(const JudgeOptions& options, const schedule::Design& design) {
    std::vector<runner::ProgramFile> files = runner::program_files(design);
    files.push_back(runner::program_file(own_program()));
    const std::string protocol = "match protocol " + std::to_string(wire::match_protocol_version);
    std::string identity = runner::experiment_hash(design, files, protocol);
    for (const judge::ShadowConfig& shadow : shadows_) identity += "\n" + shadow.name;
    if (!again_.empty()) identity += "\nagain " + again_.string();
    identity = runner::hash_of(identity);
    held_.emplace(folder_);  // all else is checked
    fs::create_directories(folder_ / "games");
    const fs::path file = folder_ / "experiment";
    if (!fs::exists(file)) {
      process::write_whole(file, identity + "\n");
      runner::write_manifest(folder_ / "manifest.json", {identity, design, files, options.version, protocol,
                                                         options.command_line, isolation_.sentence});
    } else if (read(file) != identity + "\n") {
      throw record::StorageError(
          folder_.string() + ": holds another experiment (other design, programs or shadows): " +
          read(file).substr(0, 32) + " there, " + identity + " now; give another --out");
    }
  }

  std::unique_ptr<process::Child> start(std::size_t n, int cpu) const {
    const fs::path job = folder_ / "games" / (id(n) + ".job");
    judge::Job its{id(n), games_[n].config, shadows_};
    if (!keep_.empty()) its.keep = keep_ / recording(n);
    if (!again_.empty()) its.again = again_ / recording(n);
    process::write_whole(job, judge::to_json(its));
    process::Command command;
    command.arguments = {own_program(), "judge-game", job.string(), result_file(n).string()};
    const std::vector<std::string> flags = worker_flags(isolation_.level, visible_, folder_);
    command.arguments.insert(command.arguments.end(), flags.begin(), flags.end());
    command.output = folder_ / "games" / (id(n) + ".log");
    command.cpu = cpu;
    return std::make_unique<process::Child>(command);
  }

  void collect(std::size_t n, process::Child& child) {
    const process::Exit exit = child.stop(std::chrono::milliseconds{0});
    const fs::path base = folder_ / "games" / id(n);
    if (!fs::exists(result_file(n))) {
      ++faults_;
      // With --again it is the recording that cannot be read; its sentence is enough.
      const bool refused = !again_.empty() && !exit.signalled && exit.number == bad_input;
      refused_ = refused_ || refused;
      std::cerr << id(n) << ": " << (refused ? "" : exit.describe() + ": ") << read(base.string() + ".log")
                << std::endl;
      return;
    }
    fs::remove(base.string() + ".job");
    fs::remove(base.string() + ".log");
    std::cerr << fmt::format("{} judged, {} of {}", id(n), games_.size() - open().size(), games_.size())
              << std::endl;
  }

  ChosenIsolation isolation_;
  std::vector<fs::path> visible_;
  std::optional<runner::ResultFolder> held_;  // against a second run
  fs::path folder_;
  fs::path keep_, again_;  // where recordings are written, or read
  std::vector<judge::ShadowConfig> shadows_;
  std::vector<schedule::Game> games_;
  int faults_ = 0;
  bool refused_ = false;  // a recording is damaged
};

// What a reader of judge.md needs who has not read the README.
constexpr const char* words =
    "Words. *Ours*, the acting referee: the one that ran these games. Other referees looked on (*shadows*): "
    "they saw the "
    "same images, and were asked in the acting one's state of the moment.\n"
    "*Band*: 40 mm, 0.2 m/s, 0.2 s (`harsh`: 60 mm, 0.3 m/s, 0.3 s). What happened is *clear* when it was "
    "beyond its limit "
    "by a band or more, *close* within one, a *near miss* lawful and within two. Only clear cases count for "
    "or against a "
    "referee.\n"
    "*Found*: called within 0.3 s of when it happened. *Extra*: called, and nothing like it had happened. "
    "*Of true*, "
    "recall: found, of what happened; *of called*, precision: right, of what was called.\n\n";

void write_tables(const fs::path& folder, const std::vector<judge::Failure>& failures,
                  const std::vector<judge::Table>& tables, const std::string& intro) {
  process::write_whole(folder / "judge.md", intro + words + judge::as_markdown(tables));
  process::write_whole(folder / "judge.json", judge::as_json(tables));
  for (const judge::Table& table : tables)
    process::write_whole(folder / (table.name + ".csv"), judge::as_csv(table));
  process::write_whole(folder / "failures.csv", judge::as_csv(failures));
}

// The cases that failed, and how to see the first of each kind again.
std::string told_cases(const std::vector<judge::Failure>& failures, const JudgeOptions& options,
                       const fs::path& folder) {
  std::string text = fmt::format("All tables: {}. ", (folder / "judge.md").string());
  if (failures.empty()) return text + "No case failed.\n";
  std::vector<std::string> line = {options.command_line.front(), "judge", options.design.string()};
  if (!options.again.empty()) line.insert(line.end(), {"--again", options.again.string()});
  text += fmt::format("Cases that failed: {}, in {}. The first of each kind, tick by tick:\n\n",
                      failures.size(), (folder / "failures.csv").string());
  std::vector<std::string> kinds;
  for (const judge::Failure& one : failures) {
    const std::string kind = one.event + ": " + one.what.substr(0, one.what.find(';'));
    if (std::ranges::find(kinds, kind) != kinds.end()) continue;
    kinds.push_back(kind);
    text += fmt::format("    {} --show {}:{}-{}    # {}\n", schedule::shell_line(line), one.game,
                        one.first_tick, one.last_tick, kind);
  }
  return text;
}

/// One passage of one game again, tick by tick; `where` is GAME:FIRST-LAST as in failures.csv.
int show(const schedule::Design& design, const JudgeOptions& options) {
  const std::string& where = options.show;
  const auto colon = where.rfind(':');
  const auto dash = where.rfind('-');
  judge::Passage passage;
  const auto number = [&](std::size_t from, std::size_t to, std::int64_t& value) {
    const char* end = where.data() + to;
    return std::from_chars(where.data() + from, end, value).ptr == end && from < to;
  };
  if (colon == std::string::npos || dash == std::string::npos || dash < colon ||
      !number(colon + 1, dash, passage.first) || !number(dash + 1, where.size(), passage.last)) {
    throw std::invalid_argument("--show " + where +
                                ": give GAME:FIRST-LAST, ticks, as base-0003-1:10624-10804");
  }
  if (passage.last < passage.first) {
    throw std::invalid_argument("--show " + where + ": the last tick is before the first");
  }
  const auto check_length = [&](const judge::GameResult& result) {
    if (result.ticks >= passage.first) return;
    throw std::invalid_argument(fmt::format("--show {}: the game has {} ticks", where, result.ticks));
  };
  const schedule::Game game = schedule::find_game(design, where.substr(0, colon));
  passage.out = &std::cout;
  passage.save = options.save;
  if (!options.again.empty()) {
    check_length(
        judge::judge_again(options.again / (where.substr(0, colon) + recording_ending), {}, passage));
    return done;
  }
  runner::Signals signals;
  host::Options settings;
  settings.isolation = chosen_isolation(design.isolation, options.design.string() + ": isolation =").level;
  settings.visible = visible_paths(design.visible, options.design.string() + ": visible =");
  settings.cpu = ::sched_getcpu();
  bool over = false;
  bool stopped = false;
  settings.interrupted = [&] {
    stopped = stopped || signals.wait(std::chrono::milliseconds{0}).has_value();
    return over || stopped;
  };
  settings.on_second = [&](world::Time time, const auto&) {
    over = world::seconds(time) * world::ticks_per_second > static_cast<double>(passage.last + 120);
  };
  const judge::GameResult played =
      judge::play_judged({where.substr(0, colon), game.config, {}}, settings, passage);
  if (stopped) return faults;
  check_length(played);
  return done;
}

}  // namespace

int judge(const JudgeOptions& options) {
  if (options.again.empty()) check_temporary_folder(Games::Here);
  const schedule::Design design = schedule::read_design(options.design, host::check_realism);
  for (std::size_t i = 0; i < design.conditions.size(); ++i) {
    host::check(schedule::game(design, 2 * i).config);
  }
  if (!options.save.empty() && options.show.empty()) {
    throw std::invalid_argument("--save " + options.save.string() +
                                ": only a passage can be saved; give --show GAME:FIRST-LAST too");
  }
  if (!options.save.empty() && !options.again.empty()) {
    throw std::invalid_argument("--save " + options.save.string() +
                                ": a recorded game lacks what a scenario needs; leave out --again");
  }
  if (!options.show.empty()) return show(design, options);
  Judging judging(options, design);
  std::cerr << fmt::format("{}: {} games, realism {}, rule set {}, {} shadows, results in {}", design.name,
                           judging.count(), record::text(design.realism), design.rules,
                           judging.shadows().size(), judging.folder().string())
            << std::endl
            << judging.isolation() << std::endl;
  const std::optional<int> signal = judging.play(options.workers);

  const std::vector<judge::GameResult> games = judging.results();
  const std::string command = schedule::shell_line(options.command_line);
  std::int64_t ticks = 0;
  for (const judge::GameResult& game : games) ticks += game.ticks;
  const double minutes = static_cast<double>(ticks) / world::ticks_per_second / 60;
  const std::string played =
      minutes < 90 ? fmt::format("{:.0f} min", minutes) : fmt::format("{:.1f} h", minutes / 60);
  const std::string intro = fmt::format(
      "# The referee against the truth: {}\n\n{} of {} games, {} simulated, rule set {}, realism {}.\n"
      "Made by `{}`; how to make it again: manifest.json. Failing cases: failures.csv.\n"
      "Who stands where at penalty kicks and in shoot-outs is not judged.\n\n",
      design.name, games.size(), judging.count(), played, design.rules,
      record::text(design.conditions.front().realism), command);
  const std::vector<judge::Table> tables = judge::tables(games, command);
  const std::vector<judge::Failure> failures = judge::failures(games, judge::acting_name);
  if (!games.empty()) write_tables(judging.folder(), failures, tables, intro);
  if (signal) {
    std::cerr << "interrupted, nothing is lost; continue with: " << command << std::endl;
    return signal_base + *signal;
  }
  if (games.empty()) return judging.exit_code();
  std::cout << intro << judge::as_markdown(std::span(tables).first(1))
            << told_cases(failures, options, judging.folder());
  return games.size() == judging.count() ? done : judging.exit_code();
}

int judge_game(const JudgeGameOptions& options) {
  const judge::Job job = judge::job_from_json(read(options.job));
  runner::Signals signals;
  host::Options settings = game_as_told(options.isolation, options.hidden);
  bool interrupted = false;
  settings.interrupted = [&] {
    interrupted = interrupted || signals.wait(std::chrono::milliseconds{0}).has_value();
    return interrupted;
  };
  const judge::GameResult result =
      job.again.empty() ? judge::play_judged(job, settings) : judge::judge_again(job.again, job.shadows);
  if (interrupted) return faults;
  if (!job.again.empty() && (result.game != job.game || result.seed != job.config.seed)) {
    throw std::invalid_argument(job.again.string() + ": is game " + result.game + " with seed " +
                                std::to_string(result.seed) + ", not " + job.game + " with seed " +
                                std::to_string(job.config.seed) +
                                " of this design; was it renamed, or kept for another design?");
  }
  if (!result.fault.empty()) throw std::runtime_error(result.fault);
  judge::write_game(options.result, result);
  return done;
}

}  // namespace commands
