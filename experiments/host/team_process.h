#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/host/budget.h"
#include "experiments/host/channel.h"
#include "experiments/host/listener.h"
#include "experiments/host/messages.h"
#include "experiments/host/patience.h"
#include "experiments/host/peer.h"
#include "experiments/host/private_directory.h"
#include "experiments/process/child.h"
#include "experiments/process/held.h"
#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"

namespace host {

/// What a team did wrong: it ends the game.
struct Fault {
  record::Termination termination{};
  std::string reason;  ///< one sentence, naming the colour
};

/// A team was not heard for so long because the machine did not let it run: nobody's fault but ours.
struct MachineTooSlow {
  world::Team team{};  ///< who was waited for
  std::string sentence;
};

/// Something that no team did, or nobody can tell which.
struct NobodysFault {
  std::string sentence;
};

/// One team as the host sees it: a process, a socket, and what went wrong with it.
///
/// Every function that talks to the team does nothing once it has a fault. While it waits it calls
/// `while_waiting` every 10 ms at least, which may throw to leave.
class TeamProcess {
 public:
  using Idle = std::function<void()>;
  static constexpr const char* socket_variable = "MATCHDAY_SOCKET";  ///< where its socket is, for the team

  /// The team gets a socket in a directory of its own; the listening starts here.
  TeamProcess(world::Team team, const record::TeamConfig& config);

  /// Whom it plays: who must not come to its socket.
  void meets(TeamProcess& opponent) { opponent_ = &opponent; }

  /// How it is started.
  struct Start {
    std::filesystem::path directory;  ///< for a file with what it prints; empty: none
    std::filesystem::path logs;  ///< where it may write; empty: nowhere. Removed at the end when it is empty
    std::size_t kept_output;     ///< [bytes] of what it prints
    process::Cell cell;          ///< what it sees, apart from its socket
    std::chrono::milliseconds disk_wait;  ///< not its own time, see TeamClock
  };
  /// Starts the program; NotStarted when that fails.
  void start(const Start& how);

  /// From now on it has so long for what it is waited for; see Patience.
  void allow(std::chrono::milliseconds span, Patience::Clock::time_point now) { patience_.begin(span, now); }
  /// To be called by `while_waiting`, for both teams: whoever is waited for, the time of both goes on.
  /// OverLimit when the team has used more of its own time than `begin_budget` said.
  void count_time(Patience::Clock::time_point now);

  /// From now on it has so much time for a simulated second and for the game; see Budget.
  void begin_budget(Budget::Allowed allowed, Budget::Clock::time_point now);
  /// It is about to be sent the tick it is then waited for.
  void begin_tick(Budget::Clock::time_point now) { budget_.sent(now); }
  /// The other team was waited for first, until `time`.
  void wait_only_from(Budget::Clock::time_point time) { budget_.wait_only_from(time); }
  void begin_second(std::int64_t number, Budget::Clock::time_point now) { budget_.begin_second(number, now); }
  /// Its answer is seen to be there, though not read.
  void note_answer(Budget::Clock::time_point now) { budget_.answered(now); }
  bool owes_answer() const { return !fault_ && budget_.waiting() && unsent_.empty(); }
  int socket() const { return channel_->socket(); }  ///< while it owes an answer
  Budget::Clock::time_point answered() const { return budget_.mark(); }
  /// Counts what has passed since the last look, without judging it.
  void settle_budget(Budget::Clock::time_point now);
  double own_seconds() const { return budget_.own_seconds(); }  ///< of its time, in this game

  // The next functions wait, but no longer than allowed; a team that takes longer has a fault.
  // They throw MachineTooSlow when the team could not run, NobodysFault when its cell could not be made.

  /// Waits for its connection. Only a process of the team is let in.
  void accept(const Idle& while_waiting);
  /// Writes one frame, without waiting: a team that has not read what it was sent before gets the rest of it
  /// while it is waited for, in its own time.
  void send(std::string_view frame);
  /// Nonsense when it has sent something before it was asked: called before a tick is sent.
  void check_nothing_is_ahead(std::int64_t tick);
  /// Waits for the next frame; false when there is none, which is a fault.
  bool receive(const Idle& while_waiting);
  /// The frame that came, as a message, valid until the next one; null when it is none, which is a fault.
  const wire::proto::TeamMessage* message();

  /// Closes what else was connected to its socket, and blames the team whose process did it.
  ///
  /// @throws NobodysFault when it is the team's own, but who plays has only said to be
  void refuse_visitors();
  /// How many connections of others, neither its own nor the opponent's processes, were refused.
  int strangers() const { return strangers_; }

  /// Declares a fault; the first one counts.
  void blame(record::Termination termination, const std::string& what);
  const std::optional<Fault>& fault() const { return fault_; }

  /// Empties the pipe of its standard output.
  void drain();

  /// OverLimit when it has more processes and threads than that; 0: any number.
  void check_threads(std::size_t most);

  /// OverLimit when its processes hold more memory, or have printed and written more,
  /// than that [bytes]; 0: any amount.
  void check_limits(std::int64_t memory, std::int64_t output);

  /// Says goodbye, gives it `grace` to leave, and ends what is left of it.
  void end(const std::string& reason, std::chrono::milliseconds grace);

  /// What it has used so far, or had when it ended.
  const process::Usage& usage() const { return usage_; }
  std::int64_t bytes_in() const { return channel_ ? channel_->bytes_in() : 0; }
  std::int64_t channel_calls() const { return channel_ ? channel_->calls() : 0; }
  pid_t pid() const { return child_ ? child_->pid() : -1; }

 private:
  Family family() const;
  void send_rest(Channel::Full full);
  void admit(int socket);
  void look_at_files(std::int64_t output);
  std::vector<pid_t> processes() const;  // its family, and those known to have left it
  void note_gone();                      // it closed the channel or ended: why?
  bool waited_enough(record::Termination termination, const std::string& what);  // blames it when so
  TeamTime time(Budget::Clock::time_point now);

  world::Team team_;
  record::TeamConfig config_;
  PrivateDirectory directory_;
  Listener listener_;
  TeamProcess* opponent_ = nullptr;
  bool let_in_by_saying_ = false;  // who plays is of the team by its environment alone
  int strangers_ = 0;
  bool isolated_ = false;
  std::filesystem::path logs_;
  std::int64_t logged_ = 0;  // [bytes] of files in that folder
  process::Held held_;       // besides what is resident, and what has a name
  Patience::Clock::time_point next_file_look_{};
  std::optional<process::Child> child_;
  std::optional<Channel> channel_;
  std::string unsent_;                  // of the frame that is being written
  std::span<const std::byte> payload_;  // of the last frame, in the channel's memory
  MessageParser parser_;
  std::optional<Fault> fault_;
  Patience patience_;
  Budget budget_;
  TeamClock clock_{std::chrono::milliseconds{0}};
  std::vector<pid_t> strays_;  // of its processes that left their parents
  Budget::Clock::time_point strays_looked_for_{};
  // doubles: most leave at the start
  Patience::Clock::duration strays_interval_ = std::chrono::milliseconds{250};
  process::Usage usage_;
};

/// Waits until both have answered, a slice at most, and notes when each did: where both are slow, the one
/// that is read last must not be taken for as slow as the other.
void see_who_answers(const world::PerTeam<TeamProcess*>& teams);

}  // namespace host
