#include "experiments/judge/game.h"

#include <fmt/format.h>

#include <optional>
#include <ostream>
#include <stdexcept>

#include "experiments/host/match.h"
#include "experiments/host/play.h"
#include "experiments/judge/failures.h"
#include "experiments/judge/game_file.h"
#include "experiments/judge/recording.h"
#include "experiments/judge/watch.h"

namespace judge {
namespace {

/// The job with which it was recorded, checked as if it were to be played.
Job job_of(const RecordingReader& recording, const std::filesystem::path& file) {
  try {
    Job job = job_from_json(recording.job());
    host::check(job.config);
    return job;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(file.string() + ": " + error.what() +
                                "; remove it and let matchday judge DESIGN --keep play the game again");
  }
}

}  // namespace

GameResult play_judged(const Job& job, const host::Options& options, const Passage& passage) {
  Watch watch(job.config, job.shadows);
  if (!passage.save.empty()) watch.keep(passage);
  std::optional<RecordingWriter> recording;
  if (!job.keep.empty()) recording.emplace(job.keep, to_json(job));
  host::Options with_watch = options;
  with_watch.on_start = [&](engine::Engine& engine) { watch.start(engine); };
  with_watch.on_tick = [&](const engine::Engine& engine, const referee::Referee& referee) {
    watch.tick(engine, referee);
    const Watch::Seen seen{engine.truth(), engine.detections(), referee.frame(), referee.state()};
    if (recording) recording->add(seen.truth, seen.images, seen.state);
    if (passage.holds(engine.tick())) watch.tell(seen, *passage.out);
  };
  with_watch.interrupted = [&] {
    return !watch.failure().empty() || (options.interrupted && options.interrupted());
  };
  const record::MatchRecord record = host::play(job.config, with_watch);

  GameResult result;
  result.game = job.game;
  result.preset = job.config.realism.preset;
  result.seed = job.config.seed;
  result.ticks = record.ticks;
  result.hash = record.hash;
  if (record.at_fault != record::Party::Nobody) result.fault = record.reason;
  if (!watch.failure().empty()) result.fault = watch.failure();
  watch.finish(result);
  if (recording && result.fault.empty() && !(options.interrupted && options.interrupted()))
    recording->close(result.ticks, result.hash);
  if (passage.out != nullptr) watch.tell_events(passage);
  if (!passage.save.empty()) {
    for (const Case& one : watch.save(job.game)) {
      *passage.out << fmt::format("kept: {}, {}; {}\n", judge::name(one.event), judge::name(one.result),
                                  sentence(one));
    }
  }
  return result;
}

GameResult judge_again(const std::filesystem::path& file, const std::vector<ShadowConfig>& shadows,
                       const Passage& passage) {
  RecordingReader recording(file);
  const Job job = job_of(recording, file);
  for (const ShadowConfig& shadow : shadows) {
    if (shadow.realism.empty() && shadow.command.empty()) continue;
    throw std::invalid_argument("--shadow " + shadow.name + ": sees more than what was recorded in " +
                                file.string() + "; leave out --again, so that the game is played");
  }
  Watch watch(job.config, shadows);
  Eyes eyes(host::model_of(job.config).geometry, host::rules_of(job.config));
  while (const RecordedTick* tick = recording.next()) {
    eyes.see(tick->images);
    const Watch::Seen seen{tick->truth, tick->images, eyes.frame(), tick->state};
    watch.tick(seen);
    if (passage.holds(tick->truth.tick)) watch.tell(seen, *passage.out);
  }
  GameResult result;
  result.game = job.game;
  result.preset = job.config.realism.preset;
  result.seed = job.config.seed;
  result.ticks = recording.ticks();
  result.hash = recording.hash();
  watch.finish(result);
  if (passage.out != nullptr) watch.tell_events(passage);
  return result;
}

}  // namespace judge
