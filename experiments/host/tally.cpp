#include "experiments/host/tally.h"

#include <type_traits>
#include <utility>

namespace host {
namespace {

struct NameOf {
  std::string operator()(const world::BallLeftFieldTouchLine&) const { return "BallLeftFieldTouchLine"; }
  std::string operator()(const world::BallLeftFieldGoalLine&) const { return "BallLeftFieldGoalLine"; }
  std::string operator()(const world::PossibleGoal&) const { return "PossibleGoal"; }
  std::string operator()(const world::BotKickedBallTooFast&) const { return "BotKickedBallTooFast"; }
  std::string operator()(const world::BotDribbledBallTooFar&) const { return "BotDribbledBallTooFar"; }
  std::string operator()(const world::AttackerDoubleTouchedBall&) const {
    return "AttackerDoubleTouchedBall";
  }
  std::string operator()(const world::AimlessKick&) const { return "AimlessKick"; }
  std::string operator()(const world::ChippedGoal&) const { return "ChippedGoal"; }
  std::string operator()(const world::BotCrashUnique&) const { return "BotCrashUnique"; }
  std::string operator()(const world::BotCrashDrawn&) const { return "BotCrashDrawn"; }
  std::string operator()(const world::AttackerTouchedKeeper&) const { return "AttackerTouchedKeeper"; }
  std::string operator()(const world::DefenderInDefenseArea& event) const {
    return event.wholly ? "DefenderInDefenseArea" : "DefenderInDefenseAreaPartially";
  }
  std::string operator()(const world::AttackerTouchedBallInDefenseArea&) const {
    return "AttackerTouchedBallInDefenseArea";
  }
  std::string operator()(const world::KeeperHeldBall&) const { return "KeeperHeldBall"; }
  std::string operator()(const world::BotTooFastInStop&) const { return "BotTooFastInStop"; }
  std::string operator()(const world::BotTooNearInStop&) const { return "BotTooNearInStop"; }
  std::string operator()(const world::BotInterferedPlacement&) const { return "BotInterferedPlacement"; }
  std::string operator()(const world::BotLeftField&) const { return "BotLeftField"; }
  std::string operator()(const world::TooManyRobots&) const { return "TooManyRobots"; }
  std::string operator()(const world::NoProgressInGame&) const { return "NoProgressInGame"; }
  std::string operator()(const world::BallTouched&) const { return "BallTouched"; }
  std::string operator()(const world::KickTaken&) const { return "KickTaken"; }
  std::string operator()(const world::RobotsSettled&) const { return "RobotsSettled"; }
};

std::string command_text(const world::Command& command) {
  std::string text = world::name(command.kind);
  if (world::has_team(command.kind)) text += std::string(" ") + world::name(command.team);
  return text;
}

}  // namespace

std::string name(const world::GameEvent& event) { return std::visit(NameOf{}, event.what); }

void Tally::add(const referee::Call& call) {
  record::CallEntry entry;
  entry.time = call.time;
  entry.row = call.row;
  if (call.event) entry.event = name(*call.event);
  if (call.command) entry.command = command_text(*call.command);
  entry.restart = call.restart;
  entry.sentence = call.sentence;
  entry.evidence = call.evidence;

  if (call.stops_play) ++counted_.calls[entry.event.empty() ? "Time" : entry.event];
  const bool noted = call.row == "note";
  if (call.offender && !noted) {
    ++counted_.fouls[call.offender->team];
    ++counted_.fouls_by_kind[call.offender->team][entry.event.empty() ? "Time" : entry.event];
  }
  if (noted) ++counted_.counters["noted_" + entry.event];
  counted_.timeline.push_back(std::move(entry));
}

std::span<const record::CallEntry> Tally::add(const referee::Output& output,
                                              const referee::Referee& referee) {
  const world::Location before = std::exchange(location_, referee.state().location);
  if (before == world::Location::GameOn && location_ != world::Location::GameOn) ++counted_.stoppages;
  ++ticks_;
  if (location_ == world::Location::GameOn) ++ticks_in_play_;

  const std::size_t known = counted_.timeline.size();
  for (const referee::Call& call : output.calls) add(call);
  return std::span<const record::CallEntry>(counted_.timeline).subspan(known);
}

void Tally::finish(const referee::Referee& referee, record::MatchRecord& record) {
  record.goals = referee.state().score;
  record.calls = std::move(counted_.calls);
  record.fouls = counted_.fouls;
  record.fouls_by_kind = std::move(counted_.fouls_by_kind);
  record.stoppages = counted_.stoppages;
  record.timeline = std::move(counted_.timeline);
  record.counters.merge(counted_.counters);
  record.counters["simulated_seconds"] = static_cast<double>(ticks_) * world::tick_length;
  record.counters["ball_in_play_seconds"] = static_cast<double>(ticks_in_play_) * world::tick_length;
  record.counters["referee_loop_defects"] = referee.loop_defects();
}

}  // namespace host
