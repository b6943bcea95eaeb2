#include "experiments/one_game.h"

#include <sched.h>

#include <chrono>
#include <cmath>
#include <ostream>

#include "experiments/runner/signals.h"
#include "experiments/tell.h"

namespace commands {

void set_team_time(const schedule::TeamTime& time, host::Options& options) {
  const auto milliseconds = [](double seconds) {
    return std::chrono::milliseconds(static_cast<std::int64_t>(std::ceil(1000 * seconds)));
  };
  options.reply_deadline = milliseconds(time.reply);
  options.budget = {.second = milliseconds(time.second), .game = milliseconds(time.game)};
}

OneGame play_one_game(const record::MatchConfig& config, std::ostream* calls, bool explain,
                      host::Options options) {
  OneGame game;
  runner::Signals signals;
  options.cpu = ::sched_getcpu();
  options.interrupted = [&, calls, also = options.interrupted] {
    if (also && also()) return true;
    if (!game.signal) game.signal = signals.wait(std::chrono::milliseconds{0});
    // Whoever read the calls has gone or the disk is full: without a file to be written,
    // nobody wants the rest.
    const bool told = calls == nullptr || calls->good() || config.log || config.recording;
    return game.signal.has_value() || !told;
  };
  options.explain = explain;
  if (calls != nullptr) {
    std::optional<std::int64_t> takeover;
    if (config.continuation) takeover = config.continuation->tick;
    options.on_call = [calls, takeover](const record::CallEntry& call,
                                        const world::PerTeam<int>& score) mutable {
      if (takeover && world::seconds(call.time.time_since_epoch()) >=
                          static_cast<double>(*takeover) * world::tick_length) {
        *calls << "    ---- from here on the live teams play ----\n";
        takeover.reset();
      }
      *calls << call_line(call, score) << std::endl;
      if (!call.evidence.empty()) *calls << call.evidence << std::endl;
    };
  }
  game.record = host::play(config, options);
  return game;
}

}  // namespace commands
