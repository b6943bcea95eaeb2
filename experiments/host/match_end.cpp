// The last part of a game: what is to be said of it, and goodbye.

#include "experiments/host/match.h"

namespace host {

void Match::judge(const Vitals::Complaint& complaint, record::MatchRecord& record) {
  if (complaint.sentence.empty()) return;
  if (complaint.team) {
    teams_[*complaint.team]->blame(record::Termination::StoodStill, complaint.sentence);
    return;
  }
  record.termination = record::Termination::Implausible;
  record.at_fault = record::Party::Harness;
  record.reason = "this was no game: " + complaint.sentence;
}

void Match::end(record::MatchRecord& record) {
  const std::optional<Fault>& yellow = teams_.yellow->fault();
  const std::optional<Fault>& blue = teams_.blue->fault();
  if (yellow || blue) {
    const Fault& first = yellow ? *yellow : *blue;
    record.termination = first.termination;
    record.reason = first.reason;
    record.at_fault = yellow ? record::Party::Yellow : record::Party::Blue;
    if (yellow && blue) {
      record.at_fault = record::Party::Both;
      record.reason += "; " + blue->reason;
    }
  }
  if (referee_) {
    tally_.finish(*referee_, record);
    statistics_.finish();
    record.statistics = statistics_.result();
    for (const world::Team team : world::both_teams) {
      record.counters[std::string("bad_commands_") + world::name(team)] = bad_commands_[team];
    }
  }
  record.ticks = engine_.tick();
  record.hash = hash_.digits();
  for (const world::Team team : world::both_teams) {
    const wire::proto::TeamHello& hello = hellos_[team];
    record.versions[team] = hello.name() + (hello.version().empty() ? "" : " " + hello.version());
  }
  const std::string farewell = record.reason.empty() ? "the game is over" : record.reason;
  const Budget::Clock::time_point now = Budget::Clock::now();
  for (const world::Team team : world::both_teams) {
    teams_[team]->settle_budget(now);
    teams_[team]->end(farewell, options_.stop_grace);
    if (const int strangers = teams_[team]->strangers(); strangers > 0) {
      record.costs[std::string("refused_connections_") + world::name(team)] = strangers;
    }
  }
}

}  // namespace host
