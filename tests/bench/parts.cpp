#include "tests/bench/parts.h"

#include <sys/socket.h>

#include <array>
#include <optional>
#include <stdexcept>

#include "autoref/automaton/automaton.h"
#include "autoref/touch/touch_detector.h"
#include "autoref/tracker/tracker.h"
#include "experiments/host/match.h"
#include "sim/vision/cameras.h"
#include "teams/kit/looker.h"
#include "teams/reference/reference_team.h"

namespace hot {
namespace {

world::RuleSet rules_of(const Recording& recording) {
  world::RuleSet rules = recording.setup.rules;
  rules.field = recording.setup.geometry.field;
  return rules;
}

// Physics, cameras, radio.
class EngineStep final : public Runner {
 public:
  explicit EngineStep(const Recording& recording) : engine_(host::model_of(recording.config)) {}
  void run(const Tick& tick) override { engine_.step(tick.commands); }

 private:
  engine::Engine engine_;
};

// The cameras over true poses.
class Vision final : public Runner {
 public:
  explicit Vision(const Recording& recording)
      : model_(host::model_of(recording.config)),
        cameras_(model_.geometry, model_.realism.vision, model_.seed, model_.realism.robots) {}
  void run(const Tick& tick) override {
    cameras_.begin_tick();
    for (int substep = 1; substep <= world::substeps_per_tick; ++substep) {
      cameras_.capture(substep, world::tick_time(tick.truth.tick - 1, substep), tick.truth.ball,
                       tick.truth.robots);
    }
  }

 private:
  engine::Model model_;
  vision::Cameras cameras_;
};

class TrackerUpdate final : public Runner {
 public:
  explicit TrackerUpdate(const Recording& recording) : tracker_(recording.setup.geometry) {}
  void run(const Tick& tick) override { tracker_.update(tick.detections); }

 private:
  tracker::Tracker tracker_;
};

// Who touched the ball: the likelihood test and the others of the rule set.
class Touch final : public Runner {
 public:
  explicit Touch(const Recording& recording)
      : touches_(recording.setup.geometry, recording.setup.rules.touch) {}
  void prepare(const Tick& tick) override {
    is_new_ = tick.frame.time > std::exchange(last_, tick.frame.time);
  }
  void run(const Tick& tick) override {
    if (is_new_) touches_.update(tick.frame, tick.detections, found_);
  }

 private:
  touch::TouchDetector touches_;
  std::vector<world::Touch> found_;
  world::Time last_;
  bool is_new_ = false;
};

// Detectors and transitions.
class AutomatonUpdate final : public Runner {
 public:
  explicit AutomatonUpdate(const Recording& recording)
      : automaton_(rules_of(recording), {recording.setup.first_kickoff, recording.setup.blue_on_positive_half,
                                         recording.setup.keeper}) {}
  void prepare(const Tick& tick) override {
    is_new_ = tick.frame.time > std::exchange(last_, tick.frame.time);
  }
  void run(const Tick& tick) override {
    if (is_new_) automaton_.update(tick.frame);
  }

 private:
  automaton::Automaton automaton_;
  world::Time last_;
  bool is_new_ = false;
};

class RefereeUpdate final : public Runner {
 public:
  explicit RefereeUpdate(const Recording& recording) : referee_(recording.setup) {}
  void run(const Tick& tick) override { referee_.update(tick.detections, tick.truth.time); }

 private:
  referee::Referee referee_;
};

// The messages to both teams, as bytes.
class Encode final : public Runner {
 public:
  explicit Encode(const Recording& recording) : engine_(host::model_of(recording.config)) {}
  void prepare(const Tick& tick) override { engine_.step(tick.commands); }
  void run(const Tick& tick) override {
    messages_.encode(engine_, tick.message, tick.message_changed);
    for (const world::Team team : world::both_teams) bytes_ += messages_.frame(team, engine_).size();
  }

 private:
  engine::Engine engine_;
  host::TickMessages messages_;
  std::size_t bytes_ = 0;
};

// Both teams' replies, as commands.
class Decode final : public Runner {
 public:
  explicit Decode(const Recording&) {}
  void run(const Tick& tick) override {
    for (const world::Team team : world::both_teams) {
      const wire::proto::TeamMessage* message = parser_.parse(payload_of(tick.replies[team]));
      wire::decode(message->reply().control(), commands_, bad_);
    }
  }

 private:
  host::MessageParser parser_;
  world::TeamCommands commands_;
  int bad_ = 0;
};

// To one team and back, without a switch between processes.
class Channel final : public Runner {
 public:
  explicit Channel(const Recording&) : Channel(ends()) {}
  void prepare(const Tick& tick) override {
    frame_.clear();
    wire::append_frame_header(frame_, tick.payloads.yellow.size());
    frame_ += tick.payloads.yellow;
  }
  void run(const Tick& tick) override {
    std::string_view rest = frame_;
    std::span<const std::byte> reply;
    host_.send(rest, host::Channel::Full::Return);
    team_.read();
    team_.write(tick.replies.yellow);
    if (host_.receive(reply) != host::Channel::Status::Done) throw std::runtime_error("no reply came");
  }

 private:
  explicit Channel(std::array<int, 2> ends) : host_(ends[0]), team_(ends[1]) {}
  static std::array<int, 2> ends() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) throw std::runtime_error("no socket pair");
    return ends;
  }

  host::Channel host_;
  kit::Channel team_;
  std::string frame_;
};

// What the kit does for a team: decoding, filter, view, encoding. The team itself is the plainest one.
class SessionTick final : public Runner {
 public:
  explicit SessionTick(const Recording& recording) : session_({"team", "0", {}, false}, plain_team()) {
    session_.answer(payload_of(recording.hellos.yellow));
  }
  void run(const Tick& tick) override { session_.answer(std::as_bytes(std::span(tick.payloads.yellow))); }

 private:
  kit::Session session_;
};

// The reference team's decisions on a view that is there.
class TeamDecision final : public Runner {
 public:
  explicit TeamDecision(const Recording& recording)
      : model_(host::model_of(recording.config)),
        setup_(setup_of(model_)),
        tracker_(model_.geometry),
        looker_(setup_),
        team_(setup_, {}) {}
  void prepare(const Tick& tick) override {
    tracker_.update(tick.detections);
    contacts_.clear();
    for (const truth::Robot& robot : tick.truth.robots) {
      if (robot.id.team == setup_.team && robot.ball_contact) contacts_.push_back(robot.id.number);
    }
    looker_.look(tick.truth.tick, tracker_.frame(), tick.message, contacts_);
    looker_.sent(tick.commands.yellow);
    commands_.clear();
  }
  void run(const Tick&) override {
    if (looker_.view().game.phase != kit::Phase::Halt) team_.play(looker_.view(), commands_);
  }

 private:
  static kit::Setup setup_of(const engine::Model& model) {
    kit::Setup setup;
    setup.team = world::Team::Yellow;
    setup.geometry = model.geometry;
    setup.robots = model.robots.yellow;
    setup.vision_delay = model.realism.vision.delay;
    setup.command_latency = model.realism.radio.latency;
    return setup;
  }

  engine::Model model_;
  kit::Setup setup_;
  tracker::Tracker tracker_;
  kit::Looker looker_;
  reference::ReferenceTeam team_;
  std::vector<std::uint8_t> contacts_;
  world::TeamCommands commands_;
};

template <class Kind>
std::unique_ptr<Runner> make(const Recording& recording) {
  return std::make_unique<Kind>(recording);
}

}  // namespace

const std::vector<PartOfTick>& parts() {
  static const std::vector<PartOfTick> all = {
      {"engine", make<EngineStep>},
      {"vision", make<Vision>},
      {"tracker", make<TrackerUpdate>},
      {"touch", make<Touch>},
      {"automaton", make<AutomatonUpdate>},
      {"referee", make<RefereeUpdate>},
      {"encode", make<Encode>},
      {"decode", make<Decode>},
      {"channel", make<Channel>},
      {"session", make<SessionTick>},
      {"team", make<TeamDecision>},
  };
  return all;
}

}  // namespace hot
