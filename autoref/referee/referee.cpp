#include "autoref/referee/referee.h"

#include <utility>
#include <vector>

#include "autoref/automaton/automaton.h"
#include "autoref/referee/explain.h"
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
        tracker(setup.geometry),
        touches(setup.rules.field, setup.rules.touch),
        automaton(setup.rules, {setup.first_kickoff, setup.blue_on_positive_half, setup.keeper}) {
    for (const Team team : world::both_teams) message.teams[team].name = setup.names[team];
    message.status = setup_text(setup);
    write_message();
  }

  Output tick();
  void hear_requests();
  void forget_answered_requests();
  std::optional<world::Vector2d> ball_reset();
  bool ball_in_place(const world::Vector2d& place) const;
  void write_message();

  Setup setup;
  tracker::Tracker tracker;
  touch::TouchDetector touches;
  automaton::Automaton automaton;

  world::TrackedFrame frame;
  world::RefereeMessage message;
  bool message_changed = true;  // the first one is news
  std::optional<world::Time> last_tick;
  std::vector<Call> calls;
  std::vector<TransitionRecord> records;

  world::PerTeam<bool> timeout_wanted{};
  world::PerTeam<bool> timeout_end_wanted{};
  std::vector<automaton::Request> requests;

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

Output Referee::Inside::tick() {
  calls.clear();
  records.clear();
  reset_is_due = false;
  if (last_tick && frame.time <= *last_tick) automaton.clock_restarted(frame.time);
  last_tick = frame.time;

  hear_requests();
  for (const automaton::Transition& transition : automaton.update(frame, requests)) {
    const automaton::Row& row = *transition.row;
    records.push_back({transition.after.time, row.name, row.from, row.to});
    if (row.from != row.to && row.to == Location::GameOff) reset_is_due = true;
    if (row.name != "T14") message_changed = true;  // T14 changes nothing that teams are told
    if (is_call(transition)) calls.push_back(explain(transition, setup.rules));
  }
  forget_answered_requests();
  write_message();

  Output output;
  output.message_changed = std::exchange(message_changed, false);
  output.ball_reset = ball_reset();
  output.calls = calls;
  output.finished = automaton.state().stage == world::Stage::Post;
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
    info.timeouts = state.timeout_num[team];
    info.timeout_time = state.timeout_time[team];
    info.keeper = state.keeper[team];
    info.max_robots =
        setup.robots[team] - state.red_cards[team] - static_cast<int>(state.yellow_times[team].size());
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

Output Referee::update(std::span<const world::Detection> detections) {
  const world::TrackedFrame* frame = inside_->tracker.update(detections);
  if (!frame) {
    inside_->calls.clear();
    inside_->records.clear();
    Output nothing_new;
    nothing_new.finished = inside_->automaton.state().stage == world::Stage::Post;
    return nothing_new;
  }
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
