#include "experiments/host/play.h"

#include <unistd.h>

#include <exception>

#include "experiments/host/match.h"
#include "experiments/host/processor.h"
#include "sim/wire/output_error.h"

namespace host {
namespace {

void note(const std::string& who, const process::Usage& usage, record::MatchRecord& record) {
  record.costs["user_seconds_" + who] = usage.user_seconds;
  record.costs["system_seconds_" + who] = usage.system_seconds;
  record.costs["peak_memory_" + who] = static_cast<double>(usage.peak_memory);
}

}  // namespace

void check(const record::MatchConfig& config) { model_of(config); }

void check_realism(const record::RealismConfig& config) { realism_of(config); }

record::MatchRecord play(const record::MatchConfig& config, const Options& options) {
  check(config);
  const BoundToProcessor bound(options.cpu);
  const auto begin = std::chrono::steady_clock::now();
  const process::Usage before = process::usage(::getpid()).value_or(process::Usage{});

  record::MatchRecord record;
  try {
    Match match(config, options);
    record = match.run();
    for (const world::Team team : world::both_teams) {
      note(world::name(team), match.usage(team), record);
      record.costs[std::string("own_seconds_") + world::name(team)] = match.own_seconds(team);
    }
  } catch (const wire::OutputError&) {
    throw;
  } catch (const std::exception& error) {
    record = {};
    record.termination = record::Termination::HarnessFault;
    record.at_fault = record::Party::Harness;
    record.reason = std::string("internal error: ") + error.what();
  }
  process::Usage own = process::usage(::getpid()).value_or(process::Usage{});
  own.user_seconds -= before.user_seconds;
  own.system_seconds -= before.system_seconds;
  note("host", own, record);
  record.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return record;
}

}  // namespace host
