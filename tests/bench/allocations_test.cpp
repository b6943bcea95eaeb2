// No part of a tick allocates memory once the game is warm, but where the referee decides something:
// counted, not believed.

#include "tests/bench/allocations.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "tests/bench/game.h"

namespace hot {
namespace {

// By then an ordinary game has had most of its restarts and crowds, and the buffers have their size (ours).
constexpr double warm = 120;  // [s]
constexpr double end = 300;   // [s]

// A buffer may still reach a size it never had, with another crowd or in another corner; what allocates at
// every tick, kick, touch or message is many times this (ours).
constexpr std::size_t ticks_per_growth = 500;

TEST(Tick, AllocatesNothingOnceTheGameIsWarm) {
  Game game;
  game.play_to(warm);

  std::array<std::size_t, part_count> in_part{};  // all calm ticks together
  std::array<std::size_t, part_count> in_tick{};
  std::size_t last = 0;
  game.on_part = [&](Part part) {
    const std::size_t now = allocations();
    in_tick[static_cast<std::size_t>(part)] += now - last;
    last = allocations();
  };
  const bool tracing = std::getenv("TRACE_ALLOCATIONS") != nullptr;
  std::size_t calm_ticks = 0, in_play = 0;
  while (world::seconds(game.engine().time()) < end) {
    in_tick.fill(0);
    last = allocations();
    trace_allocations(tracing);
    ASSERT_TRUE(game.tick());
    trace_allocations(false);
    // A decision of the referee may allocate: its sentence, its record.
    const bool calm = game.referee().transitions().empty() && game.output().calls.empty();
    if (!calm) continue;
    ++calm_ticks;
    in_play += game.referee().state().location == world::Location::GameOn ? 1 : 0;
    for (std::size_t part = 0; part < part_count; ++part) in_part[part] += in_tick[part];
  }
  EXPECT_GT(in_play, 2000U);
  for (std::size_t part = 0; part < part_count; ++part) {
    EXPECT_LE(in_part[part], calm_ticks / ticks_per_growth)
        << name(static_cast<Part>(part)) << " in " << calm_ticks
        << " ticks; TRACE_ALLOCATIONS=1 prints who allocates";
  }
}

// The counter is one: it sees what operator new, C and an aligned request allocate.
TEST(Allocations, AreCountedWhoeverAsks) {
  const std::size_t before = allocations();
  void* volatile kept = ::operator new(1);  // volatile: the compiler may leave away what nobody sees
  ::operator delete(kept);
  kept = ::calloc(1, 8);
  ::free(kept);
  kept = ::aligned_alloc(64, 64);
  ::free(kept);
  EXPECT_EQ(allocations(), before + 3);
}

}  // namespace
}  // namespace hot
