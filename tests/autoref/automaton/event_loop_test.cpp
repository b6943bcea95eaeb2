#include "autoref/automaton/event_loop.h"

#include <gtest/gtest.h>

#include <string>

namespace automaton {
namespace {

// R-6.4-4: a turnstile. A coin unlocks it, a push goes through and locks it;
// it closes by itself when it is full.
struct Turnstile {
  bool open = false;
  int inside = 0;
  bool closed_for_today = false;
};

struct TurnstileRow {
  const char* name;
  bool awaits_occurrence;
  bool (*holds)(const Turnstile&, const std::string*);
  void (*effect)(Turnstile&);
};

constexpr TurnstileRow turnstile_rows[] = {
    {"full", false,
     [](const Turnstile& t, const std::string*) { return t.inside == 2 && !t.closed_for_today; },
     [](Turnstile& t) { t.closed_for_today = true; }},
    {"coin", true, [](const Turnstile& t, const std::string* o) { return *o == "coin" && !t.open; },
     [](Turnstile& t) { t.open = true; }},
    {"push", true,
     [](const Turnstile& t, const std::string* o) { return *o == "push" && t.open && !t.closed_for_today; },
     [](Turnstile& t) {
       t.open = false;
       ++t.inside;
     }},
};

std::string run(Turnstile& turnstile, std::vector<std::string> occurrences) {
  EventLoop loop;
  std::string taken;
  loop.run(
      std::span<const TurnstileRow>(turnstile_rows), std::span<const std::string>(occurrences),
      [&](const TurnstileRow& row, const std::string* o) { return row.holds(turnstile, o); },
      [&](const TurnstileRow& row, const std::string*) {
        row.effect(turnstile);
        taken += std::string(taken.empty() ? "" : " ") + row.name;
      });
  return taken;
}

TEST(EventLoop, RunsAnotherAutomatonThanSoccer) {
  Turnstile turnstile;
  EXPECT_EQ(run(turnstile, {"push"}), "");
  EXPECT_EQ(run(turnstile, {"push", "coin"}), "coin push");  // table order, then again from the top
  EXPECT_EQ(run(turnstile, {"coin", "push", "coin", "push"}), "coin push full coin");
  EXPECT_EQ(turnstile.inside, 2);
}

TEST(EventLoop, TakesEachOccurrenceOnce) {
  Turnstile turnstile;
  EXPECT_EQ(run(turnstile, {"coin", "push", "push"}), "coin push");
}

TEST(EventLoop, IsCutShortWhenARowNeverStopsHolding) {
  const TurnstileRow endless[] = {
      {"endless", false, [](const Turnstile&, const std::string*) { return true; }, nullptr}};
  EventLoop loop;
  const auto result = loop.run(
      std::span<const TurnstileRow>(endless), std::span<const std::string>(),
      [](const TurnstileRow&, const std::string*) { return true; },
      [](const TurnstileRow&, const std::string*) {});
  EXPECT_TRUE(result.cut_short);
  EXPECT_EQ(result.transitions, EventLoop::cap);
}

}  // namespace
}  // namespace automaton
