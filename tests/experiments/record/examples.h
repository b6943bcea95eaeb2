#pragma once

#include "experiments/record/attempt.h"
#include "experiments/record/match_config.h"

namespace record {

/// A record with something in every field.
inline MatchRecord example_record() {
  MatchRecord record;
  record.goals = {.yellow = 2, .blue = 1};
  record.termination = Termination::Finished;
  record.at_fault = Party::Nobody;
  record.ticks = 72'345;
  record.hash = "0123456789abcdef0123456789abcdef";
  record.calls = {{"BallLeftFieldTouchLine", 40}, {"PossibleGoal", 3}};
  record.fouls = {.yellow = 4, .blue = 5};
  record.fouls_by_kind = {.yellow = {{"AimlessKick", 4}}, .blue = {{"BotCrashUnique", 5}}};
  record.stoppages = 61;
  record.statistics =
      MatchStatistics{.teams = {.yellow = {30, 9, 4, 2, 15, 10, 50, 12, 7, 300.5, 200.25, 1234.5},
                                .blue = {31, 8, 3, 1, 14, 11, 51, 13, 6, 310.5, 250.25, 1334.5}},
                      .time = 1230,
                      .in_play = 700,
                      .passages = 61,
                      .longest_passage = 44.5};
  record.counters = {{"shots", 12.5}};
  record.versions = {.yellow = "1.0", .blue = "2.0"};
  record.timeline = {
      {world::tick_time(601), "T11.7", "BallLeftFieldTouchLine", "STOP", "INDIRECT yellow", "out"}};
  record.wall_seconds = 15.25;
  record.costs = {{"host cpu", 9.5}};
  return record;
}

inline MatchConfig example_config() {
  MatchConfig config;
  config.teams.yellow = {"ours", {"team-a", "--flag", "two words"}, {0, 3, 15}, 0.5};
  config.teams.blue = {"theirs \"quoted\"", {"/bin/team b"}, {1}, 1};
  config.seed = 18'446'744'073'709'551'615ULL;
  config.rules = "paper";
  config.continuation = {"games/x.replies.gz", 3600};
  config.recording = "again.replies";
  config.realism = {"harsh", {{"vision.ball_sigma", 0.001}}};
  config.half_length = 12.5;
  config.winner = true;
  config.blue_on_positive_half = false;
  config.first_kickoff = world::Team::Blue;
  config.log = "games/x.log.gz";
  config.directory = "games/x";
  return config;
}

/// An attempt of that leg, by default finished 2:1 for yellow.
inline Attempt example_attempt(int pair, int leg, int attempt = 1) {
  Attempt example;
  example.key = {"equal", pair, leg};
  example.attempt = attempt;
  example.seed = 18'446'744'073'709'551'000ULL;
  example.a_colour = leg == 0 ? world::Team::Blue : world::Team::Yellow;
  example.blue_on_positive_half = false;
  example.first_kickoff = world::Team::Blue;
  example.record = example_record();
  example.started = "2026-11-20T21:00:00Z";
  example.worker = 1;
  return example;
}

/// The same, spoilt by the harness.
inline Attempt void_attempt(int pair, int leg, int attempt) {
  Attempt example = example_attempt(pair, leg, attempt);
  example.record.termination = Termination::HarnessFault;
  example.record.at_fault = Party::Harness;
  example.record.reason = "the worker was ended by signal 9";
  return example;
}

}  // namespace record
