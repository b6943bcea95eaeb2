#include "experiments/host/team_process.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>

#include "experiments/process/family.h"
#include "experiments/process/held.h"
#include "experiments/process/tree.h"
#include "experiments/record/json_text.h"
#include "sim/wire/team_limits.h"

namespace host {
namespace {

using namespace std::chrono_literals;
using record::Termination;

// A process that closed its socket because it ends needs this long at most to be seen as ended (ours).
constexpr auto farewell = 500ms;
// Looking through a team's open files and log folder may take one part in so many of our time (ours): of
// processor time, since on a busy machine looks would be too rare by the clock.
constexpr int file_look_share = 50;

std::chrono::nanoseconds own_processor_time() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec};
}

// What bubblewrap says of a program with a missing interpreter, or for another kind of machine.
constexpr const char* cannot_execute = "bwrap: execvp ";

// All processes of the machine are looked at for those that left their parents: some ms (ours).
constexpr auto strays_interval = 5s;

/// The team's own words: nearly always the reason. In quotes, since they may read like ours.
std::string said(const process::Child& child) {
  const std::string line = child.output().last_line();
  return line.empty() ? "" : "; it said last: " + record::quoted(line);
}

}  // namespace

TeamProcess::TeamProcess(world::Team team, const record::TeamConfig& config)
    : team_(team), config_(config), listener_(directory_.path() / "socket") {}

Family TeamProcess::family() const { return {pid(), socket_variable + ("=" + listener_.path().string())}; }

void TeamProcess::blame(Termination termination, const std::string& what) {
  if (fault_) return;
  fault_ = Fault{termination, std::string(world::name(team_)) + " (" + config_.name + ") " + what};
}

void TeamProcess::start(const Start& how) {
  logs_ = how.logs;
  clock_ = TeamClock(how.disk_wait);
  process::Command command;
  command.arguments = config_.command;
  command.directory = config_.directory;
  command.environment = {{socket_variable, listener_.path().string()}};
  command.expendable = true;
  command.own_keys = true;
  command.output_limit = how.kept_output;
  if (!how.directory.empty()) command.output = how.directory / (std::string(world::name(team_)) + ".log");
  isolated_ = how.cell.level != process::Isolation::None;
  if (isolated_) {
    command.cell = how.cell;
    command.cell->visible.push_back(directory_.path());
    if (opponent_ != nullptr) command.cell->hidden.push_back(opponent_->directory_.path());
  }
  try {
    child_.emplace(command);
  } catch (const process::MachineError& error) {
    throw NobodysFault{std::string(world::name(team_)) + " (" + config_.name +
                       ") was not started: " + error.what()};
  } catch (const process::StartError& error) {
    blame(Termination::NotStarted, std::string("did not start: ") + error.what());
  }
}

void TeamProcess::count_time(Patience::Clock::time_point now) {
  if (!child_ || fault_) return;
  send_rest(Channel::Full::Return);
  if (budget_.waiting()) {
    // Who has answered waits for us, while we wait for the other team. What is there before its tick is not
    // the answer.
    const bool has_answered = channel_ && unsent_.empty() && channel_->has_input();
    if (has_answered) {
      budget_.answered(now);
    } else {
      budget_.count_wait(now);
    }
  }
  patience_.count(now, [&] { return time(now); });
  if (!budget_.wants_look(now)) return;
  budget_.look(now, time(now), process::own_delay());
  if (const std::string excess = budget_.excess(); !excess.empty()) blame(Termination::OverLimit, excess);
}

std::vector<pid_t> TeamProcess::processes() const {
  std::vector<pid_t> all = process::family_of(child_->pid());
  for (const pid_t stray : strays_) {
    if (std::find(all.begin(), all.end(), stray) == all.end()) all.push_back(stray);
  }
  return all;
}

TeamTime TeamProcess::time(Budget::Clock::time_point now) {
  if (now - strays_looked_for_ > strays_interval_) {
    strays_looked_for_ = now;
    strays_interval_ = std::min<Patience::Clock::duration>(2 * strays_interval_, strays_interval);
    strays_ = process::started_with(family().mark);
  }
  return clock_.read(now, process::activity_of(processes()));
}

void TeamProcess::begin_budget(Budget::Allowed allowed, Budget::Clock::time_point now) {
  if (child_ && !fault_) budget_.begin(allowed, now, time(now), process::own_delay());
}

void TeamProcess::settle_budget(Budget::Clock::time_point now) {
  if (child_ && !child_->has_ended()) budget_.look(now, time(now), process::own_delay());
}

bool TeamProcess::waited_enough(Termination termination, const std::string& what) {
  if (patience_.is_over()) {
    blame(termination, what + patience_.within());
    return true;
  }
  if (patience_.machine_is_too_slow()) {
    throw MachineTooSlow{team_, "the machine is too slow or overloaded: " + std::string(world::name(team_)) +
                                    " (" + config_.name + ") " + what + ", but " + patience_.starved()};
  }
  return false;
}

void TeamProcess::accept(const Idle& while_waiting) {
  while (!fault_ && !channel_) {
    if (const auto socket = listener_.accept()) {
      admit(*socket);
    } else if (child_->has_ended()) {
      note_gone();
    } else if (!waited_enough(Termination::NotConnected, "did not connect")) {
      pollfd watched{listener_.file(), POLLIN, 0};
      ::poll(&watched, 1, 10);
      while_waiting();
    }
  }
}

void TeamProcess::admit(int socket) {
  const Whose who = whose(peer_of(socket), family(), opponent_ != nullptr ? opponent_->family() : Family{});
  if (!channel_ && (who == Whose::Own || who == Whose::OwnBySaying)) {
    channel_.emplace(socket, wire::max_team_frame);
    let_in_by_saying_ = who == Whose::OwnBySaying;
    return;
  }
  ::close(socket);
  switch (who) {
    case Whose::Own:
      if (let_in_by_saying_) {
        throw NobodysFault{"a process that had left the others of " + std::string(world::name(team_)) + " (" +
                           config_.name +
                           ") plays, and one of them connected, too: isolation tells them apart"};
      }
      blame(Termination::Nonsense, "connected a second time to its socket");
      break;
    case Whose::Opponents:
      opponent_->blame(Termination::Nonsense, "connected to the socket of the other team");
      break;
    case Whose::OwnBySaying:
    case Whose::Strangers:
      ++strangers_;
      break;
  }
}

void TeamProcess::refuse_visitors() {
  while (const auto socket = listener_.accept()) admit(*socket);
}

void TeamProcess::note_gone() {
  if (!child_->wait(farewell)) {
    blame(Termination::Closed, "closed the channel before the game was over");
    return;
  }
  usage_ = child_->usage();
  const process::Exit exit = child_->stop(0ms);
  usage_.user_seconds = exit.user_seconds;
  usage_.system_seconds = exit.system_seconds;
  if (!exit.began) {
    const std::string problem = child_->output().last_line();
    if (!problem.starts_with(cannot_execute)) {
      throw NobodysFault{std::string(world::name(team_)) + " (" + config_.name +
                         ") could not be isolated: " + problem};
    }
    blame(Termination::NotStarted, "did not start: program '" + config_.command.front() +
                                       "' cannot be executed" + problem.substr(problem.rfind(": ")));
    return;
  }
  const char* when = channel_ ? " before the game was over" : " before it connected";
  blame(exit.clean() ? Termination::Closed : Termination::Crashed, exit.describe() + when + said(*child_));
}

void TeamProcess::check_nothing_is_ahead(std::int64_t tick) {
  if (fault_ || !channel_) return;
  // Once a second also what the system holds for us; every tick what came with the last answer.
  const bool whole_second = tick % world::ticks_per_second == 0;
  if (channel_->pending() == 0 && !(whole_second && channel_->has_bytes())) return;
  blame(Termination::Nonsense, "sent more than one answer: there were bytes of it before tick " +
                                   std::to_string(tick) + " was sent to it");
}

void TeamProcess::send(std::string_view frame) {
  if (fault_) return;
  switch (channel_->send(frame, Channel::Full::Return)) {
    case Channel::Status::Done:
      return;
    case Channel::Status::Waiting:
      unsent_ = frame;
      return;
    case Channel::Status::Closed:
      note_gone();
      return;
  }
}

void TeamProcess::send_rest(Channel::Full full) {
  if (fault_ || unsent_.empty()) return;
  std::string_view rest = unsent_;
  const Channel::Status status = channel_->send(rest, full);
  unsent_.erase(0, unsent_.size() - rest.size());
  if (status == Channel::Status::Closed) note_gone();
}

bool TeamProcess::receive(const Idle& while_waiting) {
  while (!fault_) {
    send_rest(Channel::Full::Wait);
    if (!unsent_.empty()) {
      if (!waited_enough(Termination::NotResponding, "did not read what it was sent")) while_waiting();
      continue;
    }
    Channel::Status status{};
    try {
      status = channel_->receive(payload_);
    } catch (const wire::FrameError& error) {
      blame(Termination::Nonsense, std::string("sent nonsense: ") + error.what());
      return false;
    }
    if (status == Channel::Status::Done) {
      patience_.end();
      if (budget_.waiting()) budget_.answered(Budget::Clock::now());
      return true;
    }
    if (status == Channel::Status::Closed || child_->has_ended()) {
      note_gone();
    } else if (!waited_enough(Termination::NotResponding, "did not answer")) {
      if (!budget_.waiting()) budget_.sent(Budget::Clock::now());  // a part of an answer was there
      while_waiting();
    }
  }
  return false;
}

const wire::proto::TeamMessage* TeamProcess::message() {
  if (const wire::proto::TeamMessage* message = parser_.parse(payload_)) return message;
  blame(Termination::Nonsense,
        "sent " + std::to_string(payload_.size()) + " bytes that are not a TeamMessage");
  return nullptr;
}

void TeamProcess::drain() {
  if (child_) child_->drain();
}

void TeamProcess::check_threads(std::size_t most) {
  if (!child_ || fault_ || most == 0) return;
  const std::size_t count = process::thread_count(processes());
  if (count <= most) return;
  blame(Termination::OverLimit,
        "has " + std::to_string(count) + " processes and threads, " + std::to_string(most) + " are allowed");
}

void TeamProcess::check_limits(std::int64_t memory, std::int64_t output) {
  if (!child_ || fault_) return;
  const auto mebibytes = [](std::int64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; };
  if (memory > 0 || output > 0) look_at_files(output);
  const auto printed = static_cast<std::int64_t>(child_->output().written() + child_->output().discarded());
  if (const std::int64_t files = logged_ + held_.disk; output > 0 && printed + files > output) {
    blame(Termination::OverLimit,
          (files > 0 ? "printed and wrote more than " : "printed more than ") + mebibytes(output));
  }
  if (isolated_) child_->usage();  // what it has used is not known when it has ended
  if (memory == 0) return;
  const std::int64_t held = process::family_memory(child_->pid()) + held_.memory;
  if (held > memory) {
    blame(Termination::OverLimit,
          "held " + mebibytes(held) + " of memory, " + mebibytes(memory) + " are allowed");
  }
}

// Open files before those with a name: one that loses its name in between must not count twice.
void TeamProcess::look_at_files(std::int64_t output) {
  if (Patience::Clock::now() < next_file_look_) return;
  const std::chrono::nanoseconds begin = own_processor_time();
  using process::OwnMounts;
  held_ = process::held_by(process::family_of(child_->pid()), logs_,
                           isolated_ ? OwnMounts::Counted : OwnMounts::Ignored);
  if (!held_.whole) {
    blame(Termination::OverLimit, "has more than " + std::to_string(process::most_held_entries) +
                                      " open files" + (isolated_ ? " and mounts" : ""));
  }
  if (output > 0 && !logs_.empty()) {
    const process::TreeSize size = process::tree_size(logs_);
    logged_ = size.bytes;
    if (!size.whole && logged_ <= output) {
      const process::TreeBounds bounds;
      blame(Termination::OverLimit, "left more than " + std::to_string(bounds.entries) +
                                        " files, or folders deeper than " + std::to_string(bounds.depth) +
                                        ", in its log folder");
    }
  }
  next_file_look_ = Patience::Clock::now() + file_look_share * (own_processor_time() - begin);
}

void see_who_answers(const world::PerTeam<TeamProcess*>& teams) {
  const Budget::Clock::time_point until = Budget::Clock::now() + Channel::slice;
  for (Budget::Clock::time_point now{}; now < until;) {
    std::array<pollfd, 2> sockets{};
    std::array<TeamProcess*, 2> owing{};
    nfds_t count = 0;
    for (const world::Team team : world::both_teams) {
      if (!teams[team]->owes_answer()) continue;
      owing[count] = teams[team];
      sockets[count++] = {teams[team]->socket(), POLLIN, 0};
    }
    if (count == 0 || ::poll(sockets.data(), count, static_cast<int>(Channel::slice.count())) <= 0) return;
    now = Budget::Clock::now();
    for (nfds_t i = 0; i < count; ++i) {
      if (sockets[i].revents != 0) owing[i]->note_answer(now);
    }
  }
}

void TeamProcess::end(const std::string& reason, std::chrono::milliseconds grace) {
  if (!child_) return;
  usage_ = child_->usage();  // before it may leave
  if (channel_) {
    wire::proto::HostMessage goodbye;
    goodbye.mutable_goodbye()->set_reason(reason);
    std::string frame;
    wire::append_frame(frame, goodbye);
    std::string_view rest = frame;
    channel_->send(rest, Channel::Full::Wait);  // whoever does not take it, does not
  }
  if (!fault_ && channel_) child_->wait(grace);  // it was told, and leaves by itself
  const process::Exit exit = child_->stop(grace);
  usage_.user_seconds = exit.user_seconds;
  usage_.system_seconds = exit.system_seconds;
  channel_.reset();
  // Also whoever has left its process group; each knows its directory from its environment.
  process::end_started_with(family().mark);
  std::error_code ignored;
  if (!logs_.empty()) std::filesystem::remove(logs_, ignored);  // only when it is empty
}

}  // namespace host
