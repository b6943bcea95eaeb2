#pragma once

#include <memory>

#include "experiments/host/ball_reset.h"
#include "experiments/host/game_hash.h"
#include "experiments/host/league_log.h"
#include "experiments/host/messages.h"
#include "experiments/host/play.h"
#include "experiments/host/recorded_teams.h"
#include "experiments/host/robot_count.h"
#include "experiments/host/tally.h"
#include "experiments/host/team_process.h"
#include "experiments/host/vitals.h"
#include "experiments/statistics/observer.h"

namespace host {

/// What the simulator is given for a game of this configuration.
/// @throws std::invalid_argument naming team, field and value
engine::Model model_of(const record::MatchConfig& config);

/// The preset with its changes.
/// @throws std::invalid_argument naming preset, key or value
engine::Realism realism_of(const record::RealismConfig& config);

/// The rules of a game of this configuration.
/// @throws std::invalid_argument naming the field and the value
world::RuleSet rules_of(const record::MatchConfig& config);

/// One game while it is played; see DESIGN, "One tick of a game".
class Match {
 public:
  Match(const record::MatchConfig& config, const Options& options);

  /// Start, ticks, end. The record lacks only wall time and costs.
  record::MatchRecord run();

  /// What the teams' processes have used, after run().
  const process::Usage& usage(world::Team team) const { return teams_[team]->usage(); }
  double own_seconds(world::Team team) const { return teams_[team]->own_seconds(); }  ///< see Budget

 private:
  struct Interrupted {};
  struct Overlong {};
  struct RecordingEnded {};
  struct LastTick {};
  struct RecordingDiffers {
    std::string sentence;
  };

  void start_teams();
  void greet_teams();
  void allow(std::chrono::milliseconds span);  // both teams, from now on
  void welcome(world::Team team, const wire::proto::TeamHello& hello);
  void create_referee();
  void play_ticks();
  bool tick();  // false when the game is over
  void begin_second();
  void exchange();
  void take_reply(world::Team team);
  void take_reply(world::Team team, const wire::proto::MatchReply& reply);
  bool replay_replies();  // false when the recording is over
  void new_teams();
  bool live() const;  // teams answer the present tick
  void grant(world::Team team, const wire::proto::Request& request);
  void act_on_wishes(const referee::Output& output);
  void look_around();      // now and then, and while waiting
  void refuse_visitors();  // of both sockets
  void check_limits(Patience::Clock::time_point now);
  void report(std::span<const record::CallEntry> entries);
  void lap(Part part);
  bool anyone_at_fault() const { return teams_.yellow->fault() || teams_.blue->fault(); }
  void judge(const Vitals::Complaint& complaint, record::MatchRecord& record);
  void end(record::MatchRecord& record);

  record::MatchConfig config_;
  const Options& options_;
  engine::Engine engine_;
  world::PerTeam<std::unique_ptr<TeamProcess>> teams_;
  TeamProcess::Idle idle_;
  world::PerTeam<wire::proto::TeamHello> hellos_;

  std::unique_ptr<referee::Referee> referee_;
  std::unique_ptr<LeagueLog> log_;
  std::unique_ptr<RecordedTeams> recorded_;  // the beginning of the game, when it is a continuation
  std::unique_ptr<Recorder> recorder_;
  BallReset ball_reset_;
  RobotCount robot_count_;
  TickMessages messages_;
  GameHash hash_;
  Tally tally_;
  Vitals vitals_;
  Patience::Clock::time_point limits_checked_{};
  bool slow_ = false;  // the last tick was answered late
  statistics::Observer statistics_;
  world::PerTeam<world::TeamCommands> commands_;
  world::PerTeam<int> bad_commands_{};
  engine::Timing timing_;  // only while measuring
};

}  // namespace host
