#include "experiments/host/match.h"

#include <algorithm>
#include <utility>

#include "experiments/host/cell.h"
#include "experiments/record/waited_for.h"
#include "sim/wire/team_limits.h"
#include "sim/world/rules/rule_set.h"

namespace host {
namespace {

using record::Termination;

// A game of two halves of 10 minutes takes 20 to 25 simulated minutes; beyond this the
// referee is stuck (DESIGN).
constexpr world::Duration longest_game = std::chrono::minutes{40};
// Extra time adds half as much; a shoot-out of twenty kicks takes ten minutes.
constexpr world::Duration longest_game_with_winner = std::chrono::minutes{80};

// A look at the teams' memory takes 0.1 ms; a program can take a few hundred MB between two (ours).
constexpr std::chrono::milliseconds limits_interval{100};

// Ours: teams answer within 0.1 ms; a later answer is worth a system call more.
constexpr std::chrono::milliseconds late{1};

/// The robot the team names, else its lowest number; -1 when it names none that can be.
int keeper_of(const wire::proto::TeamHello& hello, const record::TeamConfig& team) {
  if (hello.has_keeper())
    return hello.keeper() <= world::max_robot_number ? static_cast<int>(hello.keeper()) : -1;
  return *std::min_element(team.robots.begin(), team.robots.end());
}

}  // namespace

Match::Match(const record::MatchConfig& config, const Options& options)
    : config_(config),
      options_(options),
      engine_(model_of(config)),
      idle_([this] { look_around(); }),
      statistics_(engine_.model().geometry) {
  for (const world::Team team : world::both_teams) {
    teams_[team] = std::make_unique<TeamProcess>(team, config_.teams[team]);
  }
  teams_.yellow->meets(*teams_.blue);
  teams_.blue->meets(*teams_.yellow);
}

record::MatchRecord Match::run() {
  record::MatchRecord record;
  try {
    if (config_.continuation) {
      recorded_ = std::make_unique<RecordedTeams>(config_.continuation->recording, config_);
    }
    if (recorded_ && !config_.continuation->tick) {
      for (const world::Team team : world::both_teams) hellos_[team] = recorded_->hello(team);
    } else {
      start_teams();
      if (!anyone_at_fault()) greet_teams();
    }
    if (!anyone_at_fault()) {
      create_referee();
      play_ticks();
      refuse_visitors();
    }
    record.termination = Termination::Finished;
    record.at_fault = record::Party::Nobody;
    if (options_.must_be_plausible && !anyone_at_fault()) judge(vitals_.complaint(), record);
  } catch (const Interrupted&) {
    record.termination = Termination::Interrupted;
    record.reason = "the game was interrupted";
  } catch (const RecordingEnded&) {
    record.termination = Termination::Interrupted;
    record.reason = recorded_->cut() ? "the recording is cut off here" : "the recording ends here";
  } catch (const LastTick&) {
    record.termination = Termination::Interrupted;
    record.reason = "the game was broken off after tick " + std::to_string(*options_.last_tick);
  } catch (const RecordingDiffers& differs) {
    record.termination = Termination::HarnessFault;
    record.at_fault = record::Party::Harness;
    record.reason = differs.sentence;
  } catch (const MachineTooSlow& slow) {
    record.termination = Termination::HarnessFault;
    record.at_fault = record::Party::Harness;
    record.reason = slow.sentence;
    record.costs[record::waited_for(slow.team)] = 1;
  } catch (const NobodysFault& fault) {
    record.termination = Termination::HarnessFault;
    record.at_fault = record::Party::Harness;
    record.reason = fault.sentence;
  } catch (const Overlong&) {
    record.termination = Termination::Overlong;
    record.reason =
        std::string("the game was not over after ") + (config_.winner ? "80" : "40") + " simulated minutes";
  }
  end(record);
  return record;
}

void Match::start_teams() {
  for (const world::Team team : world::both_teams) {
    if (!config_.directory.empty()) std::filesystem::create_directories(log_folder(team, config_));
  }
  // Both are tried, so that both are to blame when neither starts.
  for (const world::Team team : world::both_teams)
    teams_[team]->start({config_.directory, log_folder(team, config_), options_.kept_output,
                         cell_of(team, config_, options_), options_.disk_wait});
}

void Match::greet_teams() {
  allow(options_.connect_deadline);
  for (const world::Team team : world::both_teams) teams_[team]->accept(idle_);
  allow(options_.connect_deadline);  // anew: one must not suffer from the other's slow start
  for (const world::Team team : world::both_teams) {
    teams_[team]->send(hello_frame(team, config_, engine_.model()));
  }
  for (const world::Team team : world::both_teams) {
    TeamProcess& process = *teams_[team];
    if (!process.receive(idle_)) continue;
    const wire::proto::TeamMessage* message = process.message();
    if (message == nullptr) continue;
    if (!message->has_hello()) {
      process.blame(Termination::Nonsense, "did not answer the hello with a hello");
      continue;
    }
    welcome(team, message->hello());
  }
}

void Match::allow(std::chrono::milliseconds span) {
  const Patience::Clock::time_point now = Patience::Clock::now();
  for (const world::Team team : world::both_teams) teams_[team]->allow(span, now);
}

void Match::welcome(world::Team team, const wire::proto::TeamHello& hello) {
  TeamProcess& process = *teams_[team];
  if (hello.protocol_version() != wire::match_protocol_version) {
    process.blame(Termination::Nonsense, "speaks protocol version " +
                                             std::to_string(hello.protocol_version()) + ", the host speaks " +
                                             std::to_string(wire::match_protocol_version));
    return;
  }
  const auto& robots = config_.teams[team].robots;
  if (std::find(robots.begin(), robots.end(), keeper_of(hello, config_.teams[team])) == robots.end()) {
    process.blame(Termination::Nonsense, "wants robot " + std::to_string(hello.keeper()) +
                                             " as its keeper, which is not on the field");
  }
  const std::string excess = wire::excess(hello);
  if (!excess.empty()) return process.blame(Termination::Nonsense, excess);
  hellos_[team] = hello;
  hellos_[team].DiscardUnknownFields();
}

void Match::create_referee() {
  referee::Setup setup;
  setup.rules = rules_of(config_);
  setup.explain = options_.explain;
  setup.geometry = engine_.model().geometry;
  setup.blue_on_positive_half = config_.blue_on_positive_half;
  setup.first_kickoff = config_.first_kickoff;
  for (const world::Team team : world::both_teams) {
    const wire::proto::TeamHello& hello = recorded_ ? recorded_->hello(team) : hellos_[team];
    setup.keeper[team] = keeper_of(hello, config_.teams[team]);
    setup.names[team] = config_.teams[team].name;
    setup.robots[team] = static_cast<int>(config_.teams[team].robots.size());
  }
  referee_ = std::make_unique<referee::Referee>(setup);

  if (config_.log) {
    wire::proto::Referee first;
    wire::encode(referee_->message(), wire::Epoch{}, first);
    first.set_source_identifier("matchday");
    first.set_status_message(referee::setup_text(setup));
    if (config_.log->has_parent_path()) std::filesystem::create_directories(config_.log->parent_path());
    log_ = std::make_unique<LeagueLog>(*config_.log, setup.geometry, first);
  }
  if (config_.recording) {
    if (config_.recording->has_parent_path()) {
      std::filesystem::create_directories(config_.recording->parent_path());
    }
    const world::PerTeam<wire::proto::TeamHello> recorded =
        recorded_ ? world::PerTeam<wire::proto::TeamHello>{recorded_->hello(world::Team::Yellow),
                                                           recorded_->hello(world::Team::Blue)}
                  : hellos_;
    recorder_ = std::make_unique<Recorder>(*config_.recording, config_, recorded);
  }
}

void Match::play_ticks() {
  if (options_.stopwatch != nullptr) engine_.measure(&timing_);
  if (options_.on_start) options_.on_start(engine_);
  const auto begin = Patience::Clock::now();
  for (const world::Team team : world::both_teams) {
    if (!config_.continuation) teams_[team]->begin_budget(options_.budget, begin);
  }
  while (tick()) {
    if (engine_.tick() % world::ticks_per_second == 0) {
      vitals_.add(engine_.truth(), referee_->message(), referee_->state());
      look_around();
      refuse_visitors();
      begin_second();
      if (options_.on_second) options_.on_second(engine_.time(), referee_->state().score);
      const world::Duration longest = config_.winner ? longest_game_with_winner : longest_game;
      if (engine_.time().time_since_epoch() > longest) throw Overlong{};
    }
  }
  if (log_) log_->close();
  if (recorder_) recorder_->close();
  if (options_.stopwatch != nullptr) {
    options_.stopwatch->loop_seconds = std::chrono::duration<double>(Patience::Clock::now() - begin).count();
    options_.stopwatch->bytes_in = teams_.yellow->bytes_in() + teams_.blue->bytes_in();
    options_.stopwatch->channel_calls = teams_.yellow->channel_calls() + teams_.blue->channel_calls();
  }
}

bool Match::tick() {
  if (options_.stopwatch != nullptr) options_.stopwatch->begin_tick();
  engine_.step(commands_);
  if (options_.stopwatch != nullptr) {
    options_.stopwatch->part_of_lap(Part::Vision, std::exchange(timing_.vision, {}));
  }
  lap(Part::Physics);

  const referee::Output output = referee_->update(engine_.detections(), engine_.time());
  lap(Part::Referee);

  hash_.add(engine_.truth(), commands_, referee_->message(), output.ball_reset);
  report(tally_.add(output, *referee_));
  statistics_.update(engine_.truth(), referee_->state());
  vitals_.note(commands_, referee_->state());
  if (options_.on_tick) options_.on_tick(engine_, *referee_);
  act_on_wishes(output);
  lap(Part::Bookkeeping);

  messages_.encode(engine_, referee_->message(), output.message_changed);
  lap(Part::Messages);
  if (log_) {
    log_->add(engine_.time(), messages_.packets(), messages_.fresh_referee());
    lap(Part::Log);
  }
  if (output.finished) return false;
  if (options_.last_tick && engine_.tick() >= *options_.last_tick) throw LastTick{};

  if (live()) {
    if (recorded_) {
      recorded_.reset();
      new_teams();
    }
    exchange();
  } else if (!replay_replies()) {
    throw RecordingEnded{};
  }
  if (recorder_) {
    const bool whole_second = engine_.tick() % world::ticks_per_second == 0;
    recorder_->end_tick(engine_.tick(), whole_second ? hash_.digits() : "");
  }
  return !anyone_at_fault();
}

bool Match::live() const {
  return !recorded_ || (config_.continuation->tick && engine_.tick() >= *config_.continuation->tick);
}

bool Match::replay_replies() {
  const wire::proto::Tick* tick = recorded_->replies(engine_.tick());
  if (tick == nullptr) return false;
  if (tick->has_hash() && tick->hash() != hash_.digits()) {
    throw RecordingDiffers{
        config_.continuation->recording.string() + ": the game goes differently at tick " +
        std::to_string(engine_.tick()) +
        ": it was recorded by another build of matchday, on another kind of processor, or is damaged"};
  }
  if (tick->has_new_yellow()) hellos_.yellow = tick->new_yellow();
  if (tick->has_new_blue()) hellos_.blue = tick->new_blue();
  if (tick->has_new_yellow() || tick->has_new_blue()) new_teams();
  take_reply(world::Team::Yellow, tick->yellow());
  take_reply(world::Team::Blue, tick->blue());
  return true;
}

// Teams start anew in the middle of the game: who keeps the goal is what they say now.
void Match::new_teams() {
  for (const world::Team team : world::both_teams) {
    referee_->set_keeper(team, keeper_of(hellos_[team], config_.teams[team]));
  }
  if (recorder_) recorder_->new_teams(hellos_);
}

void Match::begin_second() {
  const auto now = Budget::Clock::now();
  const std::int64_t number = engine_.tick() / world::ticks_per_second + 1;
  for (const world::Team team : world::both_teams) teams_[team]->begin_second(number, now);
}

void Match::exchange() {
  world::PerTeam<std::string_view> frames;
  for (const world::Team team : world::both_teams) frames[team] = messages_.frame(team, engine_);
  lap(Part::Messages);

  // Both are written before either is read: the teams think at the same time, or at least
  // neither waits for the other, nor for one that does not read.
  for (const world::Team team : world::both_teams) teams_[team]->check_nothing_is_ahead(engine_.tick());
  const Budget::Clock::time_point begin = Budget::Clock::now();
  for (const world::Team team : world::both_teams) {
    teams_[team]->allow(options_.reply_deadline, begin);
    teams_[team]->begin_tick(begin);
  }
  for (const world::Team team : world::both_teams) teams_[team]->send(frames[team]);
  if (slow_) see_who_answers({teams_.yellow.get(), teams_.blue.get()});
  // First the one that was written to last: by then the other has answered, which wakes nobody.
  world::PerTeam<bool> came;
  came.blue = teams_.blue->receive(idle_);
  if (!slow_) teams_.yellow->wait_only_from(teams_.blue->answered());
  came.yellow = teams_.yellow->receive(idle_);
  slow_ = std::max(teams_.blue->answered(), teams_.yellow->answered()) - begin > late;
  lap(Part::Channel);

  for (const world::Team team : world::both_teams) {
    if (came[team]) take_reply(team);
  }
  lap(Part::Messages);
  if (options_.stopwatch != nullptr) {
    options_.stopwatch->messages += 4;
    options_.stopwatch->bytes_out += static_cast<std::int64_t>(frames.yellow.size() + frames.blue.size());
  }
}

void Match::take_reply(world::Team team) {
  TeamProcess& process = *teams_[team];
  const wire::proto::TeamMessage* message = process.message();
  if (message == nullptr) return;
  if (!message->has_reply()) {
    process.blame(Termination::Nonsense,
                  "did not answer tick " + std::to_string(engine_.tick()) + " with a reply");
    return;
  }
  const wire::proto::MatchReply& reply = message->reply();
  if (reply.tick() != engine_.tick()) {
    process.blame(Termination::Nonsense, "answered tick " + std::to_string(reply.tick()) + " when tick " +
                                             std::to_string(engine_.tick()) + " was sent");
    return;
  }
  const std::string excess = wire::excess(reply);
  if (!excess.empty()) return process.blame(Termination::Nonsense, excess);
  take_reply(team, reply);
}

void Match::take_reply(world::Team team, const wire::proto::MatchReply& reply) {
  wire::decode(reply.control(), commands_[team], bad_commands_[team]);
  if (reply.has_request()) grant(team, reply.request());
  if (recorder_) wire::copy_what_counts(reply, recorder_->reply(team));
}

void Match::grant(world::Team team, const wire::proto::Request& request) {
  const auto is_ours = [&](std::uint32_t number) {
    const auto& robots = config_.teams[team].robots;
    return number <= world::max_robot_number &&
           std::find(robots.begin(), robots.end(), static_cast<int>(number)) != robots.end();
  };
  if (request.timeout_start()) {
    referee_->request_timeout(team);
  } else if (request.timeout_end()) {
    referee_->end_timeout(team);
  } else if (request.has_keeper() && is_ours(request.keeper())) {
    referee_->set_keeper(team, static_cast<int>(request.keeper()));
  } else if (request.has_robot_to_leave() && is_ours(request.robot_to_leave())) {
    robot_count_.prefer({team, static_cast<std::uint8_t>(request.robot_to_leave())});
  } else {
    messages_.refuse(team, "REQUEST_REFUSED", "the request names no robot of the team, or nothing");
  }
}

void Match::act_on_wishes(const referee::Output& output) {
  ball_reset_.update(output.ball_reset, referee_->state(), engine_);
  robot_count_.update(referee_->message(), referee_->state(), engine_);
}

void Match::look_around() {
  const Patience::Clock::time_point now = Patience::Clock::now();
  for (const world::Team team : world::both_teams) {
    teams_[team]->drain();
    teams_[team]->count_time(now);
  }
  if (options_.interrupted && options_.interrupted()) throw Interrupted{};
  check_limits(now);
}

void Match::refuse_visitors() {
  for (const world::Team team : world::both_teams) teams_[team]->refuse_visitors();
}

void Match::check_limits(Patience::Clock::time_point now) {
  if (now - limits_checked_ < limits_interval) return;
  limits_checked_ = now;
  for (const world::Team team : world::both_teams) {
    teams_[team]->check_threads(options_.thread_limit);
    teams_[team]->check_limits(options_.memory_limit, options_.output_limit);
  }
}

void Match::report(std::span<const record::CallEntry> entries) {
  if (!options_.on_call) return;
  for (const record::CallEntry& entry : entries) options_.on_call(entry, referee_->state().score);
}

void Match::lap(Part part) {
  if (options_.stopwatch != nullptr) options_.stopwatch->lap(part);
}

}  // namespace host
