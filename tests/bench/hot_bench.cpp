// Microseconds of each part of a tick, over ticks of a real game of the reference team against itself.

#include <benchmark/benchmark.h>

#include <chrono>

#include "tests/bench/parts.h"

namespace {

constexpr double seconds = 60;  // of the game; the first tenth warms up
constexpr std::size_t warm_ticks = 360;

const hot::Recording& game() {
  static const hot::Recording recording = hot::recorded(hot::reference_team(), seconds);
  return recording;
}

// Each round is the whole game; the clock runs for the part alone.
void one_part(benchmark::State& state, const hot::PartOfTick& part) {
  using Clock = std::chrono::steady_clock;
  const hot::Recording& recording = game();
  for (auto _ : state) {
    const auto runner = part.make(recording);
    Clock::duration spent{};
    for (std::size_t i = 0; i < recording.ticks.size(); ++i) {
      runner->prepare(recording.ticks[i]);
      const auto begin = Clock::now();
      runner->run(recording.ticks[i]);
      if (i >= warm_ticks) spent += Clock::now() - begin;
    }
    const double ticks = static_cast<double>(recording.ticks.size() - warm_ticks);
    state.SetIterationTime(std::chrono::duration<double>(spent).count() / ticks);
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (const hot::PartOfTick& part : hot::parts()) {
    benchmark::RegisterBenchmark(part.name.c_str(), one_part, part)
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond)
        ->Iterations(5);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
