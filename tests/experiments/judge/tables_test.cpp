#include "experiments/judge/tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "experiments/judge/failures.h"
#include "experiments/judge/game_file.h"

namespace judge {
namespace {

using testing::HasSubstr;

world::Time at(double seconds) { return world::Time{world::from_seconds(seconds)}; }

world::Touch touch(world::Team team, double probability) {
  return world::Touch{{team, 1}, at(0), world::Vector2d::Zero(), probability};
}

/// An exit that blue touched last, called after 50 ms; `said` by "all three" and "likelihood".
Case exit_case(bool three, bool likelihood, double probability) {
  const auto team = [](bool right) { return right ? world::Team::Blue : world::Team::Yellow; };
  Case one{acting_name, Event::Exit, Result::Found};
  one.truth.emplace();
  one.truth->time = at(100);
  one.truth->margin = 10;
  one.truth->last = LastTouch{{world::Team::Blue, 1}, at(99)};
  one.call.emplace();
  one.call->time = at(100);
  one.call->reported = at(100.05);
  one.call->last = touch(team(likelihood), probability);
  one.call->by = one.call->last->robot;
  one.call->witnesses = {touch(team(three), 1), touch(team(likelihood), probability)};
  return one;
}

GameResult game() {
  GameResult game;
  game.game = "base-0000-0";
  game.preset = "measured";
  game.shadows = {acting_name};
  game.witnesses = {"all three", "likelihood"};
  return game;
}

const Table& table(const std::vector<Table>& all, const std::string& name) {
  return *std::ranges::find(all, name, &Table::name);
}

TEST(Tables, CountAsThePaperDid) {
  // Its own figures (reference "requirements", 1.6): 132 of 158 right is [.770, .885];
  // ten false exits from chips.
  GameResult result = game();
  for (int n = 0; n < 158; ++n) result.cases.push_back(exit_case(true, n < 132, 0.9));
  for (int n = 0; n < 12; ++n) {
    Case extra{acting_name, Event::Exit, Result::Extra};
    extra.call.emplace();
    extra.chip = n < 10;
    result.cases.push_back(extra);
  }
  const auto all = tables({&result, 1});
  const auto& row = table(all, "a_exits").rows.at(0);
  EXPECT_EQ(row[1], "158");
  EXPECT_EQ(row[2], "132");
  EXPECT_EQ(row[3], "26");
  EXPECT_EQ(row[4], "0");
  EXPECT_EQ(row[5], "2");
  EXPECT_EQ(row[6], "10");
  EXPECT_EQ(row[10], "132/158 = 0.835 [0.770, 0.885]");
  EXPECT_EQ(row[11], "158/158 = 1.000 [0.976, 1.000]");
  EXPECT_EQ(row[12], "75.95");  // 12 of 158
  EXPECT_EQ(row[14], "50, 50");
  EXPECT_EQ(row[15], "too few clear exits");
}

TEST(Tables, CompareWitnessesOnTheSameExits) {
  GameResult result = game();
  for (int n = 0; n < 9; ++n) result.cases.push_back(exit_case(false, true, 0.9));
  result.cases.push_back(exit_case(true, false, 0.9));
  const auto all = tables({&result, 1});
  // Exact binomial, 1 of 10: 2 (1 + 10) / 1024.
  EXPECT_EQ(table(all, "b_last_touch").rows.at(1).at(3), "0.021 (9:1)");
}

TEST(Tables, ScoreProbabilities) {
  GameResult result = game();
  for (const double probability : {0.95, 0.75}) {
    result.cases.push_back(exit_case(true, true, probability));
    result.cases.push_back(exit_case(true, false, probability));
  }
  const auto all = tables({&result, 1});
  // (0.05^2 + 0.95^2 + 0.25^2 + 0.75^2) / 4
  EXPECT_EQ(table(all, "f_calibration").rows.back().back(), "0.3825");
}

TEST(Tables, LeaveCloseAndAmbiguousEventsOutOfTheBars) {
  GameResult result = game();
  Case close = exit_case(true, false, 0.9);
  close.truth->margin = 0.9;
  Case ambiguous = exit_case(true, false, 0.9);
  ambiguous.truth->ambiguous = true;
  result.cases = {exit_case(true, true, 0.9), close, ambiguous};
  const auto all = tables({&result, 1});
  const auto& row = table(all, "a_exits").rows.at(0);
  EXPECT_EQ(row[1], "1");
  EXPECT_EQ(row[3], "0");
  EXPECT_EQ(row[7], "1");
  EXPECT_EQ(row[9], "1");
  EXPECT_TRUE(failures({&result, 1}, acting_name).empty());
}

TEST(Tables, CountWhatMadeExitsHard) {
  GameResult result = game();
  Case chip = exit_case(true, true, 0.9);
  chip.truth->last->chip = true;
  Case squeezed = exit_case(true, false, 0.9);
  squeezed.truth->last->kind = Kind::Squeeze;
  squeezed.truth->last->crowded = true;
  Case both = squeezed;
  both.truth->ambiguous = true;
  result.cases = {chip, squeezed, both, exit_case(true, true, 0.9)};
  const auto all = tables({&result, 1});
  const auto& rows = table(all, "a_situations").rows;
  const auto row = [&](const std::string& begin) {
    return *std::ranges::find_if(rows, [&](const auto& one) { return one[0].starts_with(begin); });
  };
  EXPECT_EQ(row("all")[1], "4");
  EXPECT_EQ(row("chipped")[1], "1");
  EXPECT_EQ(row("squeezed")[1], "2");
  EXPECT_EQ(row("squeezed")[3], "1");
  EXPECT_THAT(row("squeezed")[4], HasSubstr("0/1"));
  EXPECT_EQ(row("crowded")[1], "2");
  EXPECT_EQ(row("ambiguous")[3], "0");
  EXPECT_EQ(row("over")[1], "0");
}

/// The one row of `name` that begins like this.
std::vector<std::string> row_of(const std::vector<Table>& all, const std::string& name,
                                const std::string& begin, std::size_t column = 0) {
  for (const auto& row : table(all, name).rows) {
    if (row[column].starts_with(begin)) return row;
  }
  ADD_FAILURE() << "no row " << begin;
  return std::vector<std::string>(20);
}

TEST(Tables, SayWhatFailingExitsHaveInCommon) {
  GameResult result = game();
  Case gentle = exit_case(true, false, 0.9);
  gentle.truth->last->impulse = 0.015;
  Case hard = exit_case(true, true, 0.9);
  hard.truth->last->impulse = 0.1;
  Case plain = hard;
  plain.call->last->robot.team = world::Team::Yellow;
  result.cases = {gentle, hard, plain, hard};
  const auto all = tables({&result, 1});
  EXPECT_THAT(row_of(all, "a_failing", "gentle")[1], HasSubstr("1/2"));
  EXPECT_THAT(row_of(all, "a_failing", "gentle")[2], HasSubstr("1/4"));
  EXPECT_THAT(row_of(all, "a_failing", "none")[1], HasSubstr("1/2"));
}

TEST(Tables, CountAMissedExitWhoeverTouchedLast) {
  GameResult result = game();
  Case missed = exit_case(true, true, 0.9);
  missed.truth->ambiguous = true;
  missed.result = Result::Missed;
  missed.call.reset();
  result.cases = {exit_case(true, true, 0.9), missed};
  const auto all = tables({&result, 1});
  EXPECT_THAT(row_of(all, "a_exits", "ours")[11], HasSubstr("1/2"));
  EXPECT_EQ(row_of(all, "summary", "missed exits")[2], "1 of 2");
  EXPECT_EQ(failures({&result, 1}, acting_name).size(), 1u);
}

TEST(Tables, CountALateCallAsNeitherFoundNorExtra) {
  GameResult result = game();
  Case one{acting_name, Event::TooNearInStop, Result::Found};
  one.truth.emplace();
  one.truth->event = Event::TooNearInStop;
  one.truth->margin = 3;
  one.truth->time = one.truth->clear.emplace(at(10));
  one.truth->until = at(20);
  one.call.emplace();
  one.call->time = one.call->reported = at(10.2);
  Case late = one;
  late.call->time = late.call->reported = at(12);
  result.cases = {one, late};
  const auto all = tables({&result, 1});
  const auto row = row_of(all, "e_events", "too near in stop", 1);
  EXPECT_THAT(row[4], HasSubstr("1/1"));
  EXPECT_THAT(row[5], HasSubstr("1/2"));
  EXPECT_EQ(row[6], "1");
  EXPECT_EQ(row[12], "too few events, too few near misses");
  const auto failed = failures({&result, 1}, acting_name);
  ASSERT_EQ(failed.size(), 1u);
  EXPECT_THAT(failed[0].what, testing::StartsWith("late"));
}

TEST(Tables, SummarizeWhatIsReached) {
  GameResult result = game();
  for (int n = 0; n < 100; ++n) result.cases.push_back(exit_case(n >= 10, n < 99, 0.9));  // 0.99 exactly
  const auto reached = tables({&result, 1});
  EXPECT_EQ(row_of(reached, "summary", "last team")[3], "yes (too few clear exits)");
  EXPECT_EQ(row_of(reached, "summary", "extra exits")[3], "yes (too few clear exits)");
  EXPECT_EQ(row_of(reached, "summary", "missed goals")[3], "not known");
  // 10 : 1 discordant, exact binomial: 2 (1 + 11) / 2048.
  EXPECT_EQ(row_of(reached, "summary", "likelihood")[2], "p = 0.012 (10:1)");
  EXPECT_EQ(row_of(reached, "summary", "likelihood")[3], "no (too few clear exits)");
  result.cases.push_back(exit_case(true, false, 0.9));
  Case false_goal{acting_name, Event::Goal, Result::Extra};
  false_goal.call.emplace();
  result.cases.push_back(false_goal);
  const auto not_reached = tables({&result, 1});
  EXPECT_EQ(row_of(not_reached, "summary", "last team")[3], "no (too few clear exits)");
  EXPECT_THAT(table(not_reached, "summary").note, HasSubstr("Not reached: last team; false goals"));
  result.preset = "harsh";  // 0.97 asked
  const auto harsh = tables({&result, 1});
  EXPECT_EQ(row_of(harsh, "summary", "last team")[3], "yes (too few clear exits)");
  EXPECT_EQ(row_of(harsh, "summary", "false goals")[3], "") << "not asked for";
}

TEST(Tables, NameEveryColumnOnce) {
  const GameResult result = game();
  for (const Table& one : tables({&result, 1})) {
    std::set<std::string> names(one.columns.begin(), one.columns.end());
    EXPECT_EQ(names.size(), one.columns.size()) << one.name;
    for (const std::string& column : one.columns) EXPECT_NE(column.find_first_not_of(' '), std::string::npos);
    for (const auto& row : one.rows) EXPECT_EQ(row.size(), one.columns.size()) << one.name;
  }
}

TEST(Failures, NamePassageTruthAndCall) {
  GameResult result = game();
  result.cases = {exit_case(true, false, 0.62)};
  const auto failed = failures({&result, 1}, acting_name);
  ASSERT_EQ(failed.size(), 1u);
  EXPECT_EQ(failed[0].first_tick, 98 * 60);
  EXPECT_EQ(failed[0].last_tick, 101 * 60);
  EXPECT_THAT(failed[0].what, HasSubstr("last touch wrong"));
  EXPECT_THAT(failed[0].what, HasSubstr("by yellow 1 (probability 0.62)"));
}

TEST(Formats, QuoteWhatTheyMust) {
  const std::vector<Table> one = {{"x", "X", "n", {"a", "b"}, {{"1, 2", "say \"so\""}}}};
  EXPECT_EQ(as_csv(one[0]), "a,b\n\"1, 2\",\"say \"\"so\"\"\"\n");
  EXPECT_THAT(as_markdown(one), HasSubstr("| 1, 2 | say \"so\" |"));
  EXPECT_THAT(as_json(one), HasSubstr(R"(["1, 2", "say \"so\""])"));
}

TEST(Formats, NameTheCommandThatMadeThem) {
  const GameResult result = game();
  for (const Table& one : tables({&result, 1}, "matchday judge it")) {
    EXPECT_TRUE(as_csv(one).starts_with("# made by matchday judge it\n")) << one.name;
    EXPECT_THAT(as_markdown({&one, 1}), HasSubstr("Made by `matchday judge it`"));
    EXPECT_THAT(as_json({&one, 1}), HasSubstr("\"command\": \"matchday judge it\""));
  }
}

TEST(GameFile, IsReadBackAsItWas) {
  GameResult result = game();
  Case missed{acting_name, Event::DribbledTooFar, Result::Missed};
  missed.truth.emplace();
  missed.truth->event = Event::DribbledTooFar;
  missed.truth->by = world::RobotId{world::Team::Yellow, 11};
  Case extra{acting_name, Event::Exit, Result::Extra};
  extra.call.emplace();
  extra.call->witnesses = {std::nullopt, touch(world::Team::Yellow, 0.25)};
  extra.chip = true;
  result.cases = {exit_case(true, false, 0.62), missed, extra};
  result.touches.push_back({"all three", 0.1, {1, 2, 3, 4, 5}, {5, 4, 3, 2, 1}, 6, 7, 8});
  result.near_misses[3] = 9;
  const std::string text = to_json(result);
  EXPECT_EQ(to_json(game_from_json(text, "it")), text);
}

TEST(GameFile, SaysWhatIsDamaged) {
  GameResult result = game();
  result.cases = {exit_case(true, true, 0.9)};
  const std::string text = to_json(result);
  try {
    game_from_json(text.substr(0, text.size() / 2), "games/x.jsonl");
    FAIL() << "half a file was read";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("games/x.jsonl:"));
    EXPECT_THAT(error.what(), HasSubstr("remove the file"));
  }
}

// Numbers and names are looked up by the tables: what cannot be meant is damage, never arithmetic.
TEST(GameFile, RefusesWhatCannotBeMeant) {
  GameResult result = game();
  result.cases = {exit_case(true, true, 0.9)};
  const std::string text = to_json(result);
  const auto complaint = [&](const std::string& from, const std::string& to) -> std::string {
    std::string damaged = text;
    const auto at = damaged.find(from);
    if (at == std::string::npos) return "'" + from + "' is not in " + text;
    damaged.replace(at, from.size(), to);
    try {
      game_from_json(damaged, "x.jsonl");
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(complaint("\"ticks\":", "\"ticks\":1e300,\"t\":"),
              HasSubstr("x.jsonl:1: 1e+300 is no whole number"));
  EXPECT_THAT(complaint("\"ticks\":", "\"ticks\":18446744073709551615,\"t\":"), HasSubstr("no whole number"));
  EXPECT_THAT(complaint("\"seed\":", "\"seed\":-1,\"s\":"), HasSubstr("seed"));
  EXPECT_THAT(complaint("\"close\":[", "\"close\":[1,"), HasSubstr("counts"));
  EXPECT_THAT(complaint("\"ours\"", "\"rules=none\""), HasSubstr("none"));
  EXPECT_THAT(complaint("\"found\",", "\"fond\","), HasSubstr("no result"));
  EXPECT_THAT(complaint("\"time\":", "\"time\":9223372036854775807,\"t\":"), HasSubstr("no whole number"));
  for (const char* robot : {"\"Y16\"", "\"Y-1\"", "\"Y\"", "\"Y1x\"", "\"G1\"", "\"Y99999999999\""}) {
    EXPECT_THAT(complaint("\"by\":", std::string("\"by\":") + robot + ",\"b\":"), HasSubstr("no robot"))
        << robot;
  }
  EXPECT_THAT(complaint("\"place\":[", "\"place\":[1e300,"), HasSubstr("number up to"));
}

TEST(ParseShadow, ReadsItsParts) {
  const ShadowConfig shadow =
      parse_shadow("rules=paper,touch=accel+line,exit_frames=5,vision.ball_sigma=0.002");
  EXPECT_EQ(shadow.rules, "paper");
  EXPECT_TRUE(shadow.touch->accel && shadow.touch->line && !shadow.touch->backtrack);
  EXPECT_EQ(shadow.exit_frames, 5);
  EXPECT_EQ(shadow.realism.at("vision.ball_sigma"), 0.002);
  EXPECT_EQ(sweeps().size(), 14u);
}

TEST(ParseShadow, SaysWhatIsWrong) {
  for (const char* bad : {"", "ours", "paper", "rules=fifa", "touch=feel", "exit_frames=0",
                          "vision.ball_sigma=much", "vision.ball_sigma=7", "vision.cameras=8", "physics=1"}) {
    EXPECT_THROW(parse_shadow(bad), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace judge
