#include "autoref/referee/referee.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "autoref/automaton/automaton.h"
#include "autoref/automaton/interrupt.h"
#include "autoref/referee/evidence.h"
#include "autoref/referee/explain.h"
#include "autoref/referee/overrule.h"
#include "autoref/touch/touch_detector.h"
#include "autoref/tracker/tracker.h"

namespace referee {

using world::Location;
using world::Team;

namespace {

Setup with_field(Setup setup) {
  setup.rules.field = setup.geometry.field;
  return setup;
}

}  // namespace

struct Referee::Inside {
  explicit Inside(Setup given)
      : setup(with_field(std::move(given))),
        tracker(setup.geometry, {.ball_in_space = setup.rules.chip_model}),
        touches(setup.geometry, setup.rules.touch),
        automaton(setup.rules, {setup.first_kickoff, setup.blue_on_positive_half, setup.keeper}) {
    for (const Team team : world::both_teams) message.teams[team].name = setup.names[team];
    message.status = setup_text(setup);
    write_message();
  }

  Output tick();
  Output without_frame(std::optional<world::Time> clock);
  Output output_so_far();
  std::string overrule(const Override& wish);
  void halt_for_vision();
  void resume_for_vision(bool new_clock);
  void report(std::string row, std::string sentence, std::optional<world::Command> command);
  void remember(const automaton::Transition& transition, const Call& call);
  world::Vector2d ball() const;
  void hear_requests();
  void forget_answered_requests();
  std::optional<world::Vector2d> ball_reset();
  bool ball_in_place(const world::Vector2d& place) const;
  void write_message();

  Setup setup;
  tracker::Tracker tracker;
  touch::TouchDetector touches;
  automaton::Automaton automaton;

  Evidence evidence;  // fed only when it is asked for

  world::TrackedFrame frame;
  world::RefereeMessage message;
  bool message_changed = true;  // the first one is news
  std::optional<world::Time> last_tick;
  std::vector<Call> calls;
  std::vector<Call> early_calls;  // made between two ticks: reported with the next one
  std::vector<TransitionRecord> records;

  world::PerTeam<bool> timeout_wanted{};
  world::PerTeam<bool> timeout_end_wanted{};
  std::vector<automaton::Request> requests;

  bool halted_for_vision = false;
  std::optional<world::Time> blind_since;  // by the receiver's clock

  std::optional<Decision> decision;  // the last one, until play is restarted or it is reversed
  bool any_decision = false;
  bool status_is_special = false;

  bool reset_is_due = false;  // a new wish arose in this tick
  std::optional<world::Time> last_reset_wish;
};

void Referee::Inside::hear_requests() {
  using Kind = automaton::Request::Kind;
  requests.clear();
  for (const Team team : world::both_teams) {
    if (timeout_wanted[team]) requests.push_back({Kind::BeginTimeout, team});
    if (timeout_end_wanted[team]) requests.push_back({Kind::EndTimeout, team});
    timeout_end_wanted[team] = false;
  }
}

void Referee::Inside::forget_answered_requests() {
  const world::GameState& state = automaton.state();
  for (const Team team : world::both_teams) {
    const bool none_left = state.timeout_num[team] <= 0 || state.timeout_time[team].count() <= 0;
    if (state.timeout_team == team || none_left) timeout_wanted[team] = false;
  }
}

bool Referee::Inside::ball_in_place(const world::Vector2d& place) const {
  if (!frame.ball) return false;
  return (frame.ball->position.head<2>() - place).norm() <= setup.rules.placement_tolerance;
}

std::optional<world::Vector2d> Referee::Inside::ball_reset() {
  const world::GameState& state = automaton.state();
  if (state.location != Location::GameOff || !state.reset_position) {
    last_reset_wish.reset();
    return std::nullopt;
  }
  const bool repeat = !last_reset_wish || (state.time - *last_reset_wish >= setup.rules.reset_retry &&
                                           !ball_in_place(*state.reset_position));
  if (!reset_is_due && !repeat) return std::nullopt;
  last_reset_wish = state.time;
  return state.reset_position;
}

world::Vector2d Referee::Inside::ball() const {
  if (frame.ball) return frame.ball->position.head<2>();
  return automaton.state().reset_position.value_or(world::Vector2d::Zero());
}

// A call that no row made.
void Referee::Inside::report(std::string row, std::string sentence, std::optional<world::Command> command) {
  const world::GameState& state = automaton.state();
  Call call;
  call.time = state.time;
  call.row = std::move(row);
  call.sentence = std::move(sentence);
  call.command = command;
  call.stage = state.stage;
  call.score = state.score;
  message.status = call.sentence;
  status_is_special = true;
  message_changed = true;
  early_calls.push_back(std::move(call));
}

void Referee::Inside::remember(const automaton::Transition& transition, const Call& call) {
  if (call.stops_play) {
    any_decision = true;
    decision = Decision{call.sentence, transition.before, transition.after, ball()};
  } else if (transition.row->to == Location::GameOn) {
    decision.reset();
  }
}

// Nothing was seen for so long that the game cannot be refereed. The halt is dated where the patience ended,
// so that a log, which shows the gap only when it is over, is refereed as the game was.
void Referee::Inside::halt_for_vision() {
  if (halted_for_vision || !automaton::can_halt(automaton.state())) return;
  automaton.run_clock_to(*last_tick + setup.rules.vision_timeout);
  automaton::halt(automaton, ball());
  halted_for_vision = true;
  report("vision",
         fmt::format("no camera image for {:.1f} s, so the game is halted",
                     world::seconds(setup.rules.vision_timeout)),
         automaton.state().command);
}

void Referee::Inside::resume_for_vision(bool new_clock) {
  halted_for_vision = false;
  if (!automaton.state().halted) return;  // the operator was faster
  automaton.run_clock_to(frame.time);
  automaton::resume(automaton);
  reset_is_due = true;
  const world::GameState& state = automaton.state();
  const std::string kick = state.restart == world::CommandKind::Start
                               ? "neutral start"
                               : kick_name(state.restart) + " for " + world::name(state.kick_team);
  const std::string when =
      new_clock ? "with a new clock" : fmt::format("after {:.1f} s", world::seconds(frame.time - *last_tick));
  report("vision", fmt::format("images are back {}, next is the {}", when, kick), state.command);
}

std::string Referee::Inside::overrule(const Override& wish) {
  const std::uint32_t commands = automaton.state().command_counter;
  const std::optional<world::Vector2d> place = automaton.state().reset_position;
  Overruled game{automaton, frame, ball(), decision, any_decision};
  const Verdict verdict = referee::overrule(wish, game);
  if (!verdict.refusal.empty()) return verdict.refusal;
  const world::GameState& state = automaton.state();
  if (state.location == Location::GameOn) decision.reset();
  if (!state.halted) halted_for_vision = false;
  if (state.command_counter != commands || state.reset_position != place) reset_is_due = true;
  std::optional<world::Command> command;
  if (state.command_counter != commands) command = state.command;
  report("override", wish.who + " " + verdict.deed + " (" + wish.why + ")", command);
  write_message();
  return {};
}

Output Referee::Inside::output_so_far() {
  Output output;
  output.message_changed = std::exchange(message_changed, false);
  output.calls = calls;
  output.finished = automaton.state().stage == world::Stage::Post;
  return output;
}

Output Referee::Inside::without_frame(std::optional<world::Time> clock) {
  records.clear();
  if (clock && last_tick) {
    if (!blind_since || *clock < *blind_since) blind_since = *clock;
    if (*clock - *blind_since >= setup.rules.vision_timeout) halt_for_vision();
  }
  calls = std::exchange(early_calls, {});
  if (!calls.empty()) write_message();
  return output_so_far();
}

Output Referee::Inside::tick() {
  records.clear();
  const bool new_clock = last_tick && frame.time <= *last_tick;
  if (new_clock) {
    automaton.clock_restarted(frame.time);
  } else if (last_tick && frame.time - *last_tick >= setup.rules.vision_timeout) {
    halt_for_vision();
  }
  if (halted_for_vision) resume_for_vision(new_clock);
  blind_since.reset();
  last_tick = frame.time;
  calls = std::exchange(early_calls, {});

  if (setup.explain) evidence.remember(frame);
  hear_requests();
  for (const automaton::Transition& transition : automaton.update(frame, requests)) {
    const automaton::Row& row = *transition.row;
    records.push_back({transition.after.time, row.name, row.from, row.to});
    if (row.from != row.to && row.to == Location::GameOff) reset_is_due = true;
    if (row.name != "T14") message_changed = true;  // T14 changes nothing that teams are told
    if (!is_call(transition)) {
      if (row.to == Location::GameOn) decision.reset();
      continue;
    }
    calls.push_back(explain(transition, setup.rules));
    if (setup.explain) {
      calls.back().evidence =
          evidence.record(calls.back(), setup.rules, transition.before, automaton.occurrences());
    }
    remember(transition, calls.back());
    if (std::exchange(status_is_special, false)) message.status = setup_text(setup);
  }
  for (const automaton::Occurrence& occurrence : automaton.occurrences()) {
    auto noted = note(occurrence, automaton.state());
    if (!noted) continue;
    if (setup.explain) {
      noted->evidence = evidence.record(*noted, setup.rules, automaton.state(), automaton.occurrences());
    }
    calls.push_back(std::move(*noted));
  }
  forget_answered_requests();
  write_message();

  Output output = output_so_far();
  output.ball_reset = ball_reset();
  reset_is_due = false;
  return output;
}

void Referee::Inside::write_message() {
  const world::GameState& state = automaton.state();
  message.time = state.time;
  message.stage = state.stage;
  message.stage_time_left.reset();
  if (state.stage_end) message.stage_time_left = *state.stage_end - state.time;
  message.command = state.command;
  message.command_counter = state.command_counter;
  message.command_time = state.command_time;
  for (const Team team : world::both_teams) {
    world::TeamInfo& info = message.teams[team];
    info.score = state.score[team];
    info.red_cards = state.red_cards[team];
    info.yellow_card_times = state.yellow_times[team];
    info.yellow_cards = state.yellow_cards[team];
    info.timeouts = state.timeout_num[team];
    info.timeout_time = state.timeout_time[team];
    info.keeper = state.keeper[team];
    const int cards = state.red_cards[team] + static_cast<int>(state.yellow_times[team].size());
    const bool shootout = state.stage == world::Stage::ShootoutBreak || state.stage == world::Stage::Shootout;
    const int most = shootout ? setup.rules.shootout_robots : setup.robots[team];
    info.max_robots = std::clamp(setup.robots[team] - cards, 0, most);
  }
  const bool before_kick = state.location == Location::GameOff || state.location == Location::Setup;
  message.designated_position = before_kick ? state.reset_position : std::nullopt;
  message.blue_on_positive_half = state.blue_on_positive_half;
  message.next_command.reset();
  if (state.location == Location::GameOff) message.next_command = world::Command{state.call, state.kick_team};
  message.action_time_left.reset();
  if (state.location == Location::Setup && state.kick_deadline) {
    message.action_time_left = *state.kick_deadline - state.time;
  }
}

Referee::Referee(Setup setup) : inside_(std::make_unique<Inside>(std::move(setup))) {}
Referee::~Referee() = default;
Referee::Referee(Referee&&) noexcept = default;
Referee& Referee::operator=(Referee&&) noexcept = default;

Output Referee::update(std::span<const world::Detection> detections, std::optional<world::Time> clock) {
  const world::TrackedFrame* frame = inside_->tracker.update(detections);
  if (!frame) return inside_->without_frame(clock);
  if (inside_->last_tick && frame->time <= *inside_->last_tick) inside_->touches.reset();
  inside_->frame = *frame;
  inside_->frame.touches.clear();
  inside_->touches.update(inside_->frame, detections, inside_->frame.touches);
  return inside_->tick();
}

Output Referee::update(const world::TrackedFrame& frame) {
  inside_->frame = frame;
  return inside_->tick();
}

std::string Referee::overrule(const Override& wish) { return inside_->overrule(wish); }

void Referee::request_timeout(Team team) { inside_->timeout_wanted[team] = true; }

void Referee::end_timeout(Team team) {
  inside_->timeout_wanted[team] = false;
  inside_->timeout_end_wanted[team] = true;
}

void Referee::set_keeper(Team team, int number) {
  if (inside_->automaton.state().keeper[team] == number) return;
  inside_->automaton.set_keeper(team, number);
  inside_->message.teams[team].keeper = number;
  inside_->message_changed = true;
}

const world::RefereeMessage& Referee::message() const { return inside_->message; }
const world::GameState& Referee::state() const { return inside_->automaton.state(); }
const world::TrackedFrame& Referee::frame() const { return inside_->frame; }
std::span<const TransitionRecord> Referee::transitions() const { return inside_->records; }
int Referee::loop_defects() const { return inside_->automaton.loop_defects(); }

}  // namespace referee
