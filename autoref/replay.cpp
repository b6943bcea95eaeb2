#include "autoref/replay.h"

#include <fmt/format.h>

#include <map>
#include <ostream>
#include <set>
#include <stdexcept>
#include <vector>

#include "autoref/log.h"
#include "autoref/referee/explain.h"
#include "autoref/referee/referee.h"
#include "autoref/watcher.h"
#include "sim/wire/log_file.h"
#include "sim/wire/referee.h"

namespace autoref {
namespace {

using world::CommandKind;
using world::Team;

constexpr std::size_t most_waiting = 1000;  // messages between two images; ours: ten seconds of them

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      result += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

// What is found, counted and printed as text or as one JSON object per line.
class Findings {
 public:
  Findings(std::ostream& out, bool json) : out_(out), json_(json) {}

  void add(const referee::Call& call) {
    ++by_kind_[call.row];
    if (!json_) {
      out_ << referee::format_call(call) << '\n';
      return;
    }
    out_ << fmt::format("{{\"time\": {:.6f}, \"row\": {}, ", world::seconds(call.time), in_quotes(call.row));
    if (call.command) {
      out_ << fmt::format("\"command\": {}, ", in_quotes(world::name(call.command->kind)));
      if (world::has_team(call.command->kind)) {
        out_ << fmt::format("\"team\": {}, ", in_quotes(world::name(call.command->team)));
      }
    }
    if (!call.restart.empty()) out_ << fmt::format("\"restart\": {}, ", in_quotes(call.restart));
    if (call.position) {
      out_ << fmt::format("\"position\": [{:.6f}, {:.6f}], ", call.position->x(), call.position->y());
    }
    out_ << fmt::format("\"score\": [{}, {}], \"sentence\": {}}}\n", call.score.yellow, call.score.blue,
                        in_quotes(call.sentence));
  }

  void add(const Sighting& sighting) {
    const std::string kind = referee::kind_of(sighting.event);
    ++by_kind_[kind];
    const std::string sentence = referee::describe(sighting.event);
    if (json_) {
      out_ << fmt::format("{{\"time\": {:.6f}, \"event\": {}, \"sentence\": {}}}\n",
                          world::seconds(sighting.event.time), in_quotes(kind), in_quotes(sentence));
    } else {
      out_ << fmt::format("{:>10.3f} s  {:<18} {}\n", world::seconds(sighting.event.time), kind, sentence);
    }
  }

  void see(const world::TrackedFrame& frame) {
    for (const world::TrackedRobot& robot : frame.robots) robots_.insert(robot.id);
  }

  void summarise(const LogCount& count) const;

 private:
  std::ostream& out_;
  bool json_;
  std::map<std::string, std::int64_t> by_kind_;
  std::set<world::RobotId> robots_;
};

std::string type_name(std::int32_t type) {
  switch (type) {
    case wire::Vision2010:
      return "vision 2010";
    case wire::Refbox2013:
      return "referee";
    case wire::Vision2014:
      return "vision";
    case wire::Tracker2020:
      return "tracker";
    case wire::Index2021:
      return "index";
    default:
      return "type " + std::to_string(type);
  }
}

double rate(const CameraCount& camera) {
  const double duration = world::seconds(camera.last - camera.first);
  return duration > 0 ? static_cast<double>(camera.images - 1) / duration : 0.0;
}

void Findings::summarise(const LogCount& count) const {
  std::string records;
  std::string cameras;
  std::string robots;
  std::string kinds;
  const auto add = [](std::string& list, const std::string& item) {
    list += (list.empty() ? "" : ", ") + item;
  };
  if (json_) {
    for (const auto& [type, number] : count.records)
      add(records, fmt::format("{}: {}", in_quotes(type_name(type)), number));
    if (count.records_of_other_types > 0) {
      add(records, fmt::format("\"other types\": {}", count.records_of_other_types));
    }
    for (const auto& [id, camera] : count.cameras) {
      add(cameras,
          fmt::format("{{\"id\": {}, \"images\": {}, \"rate\": {:.2f}}}", id, camera.images, rate(camera)));
    }
    for (const world::RobotId robot : robots_) add(robots, in_quotes(referee::text(robot)));
    for (const auto& [kind, number] : by_kind_) add(kinds, fmt::format("{}: {}", in_quotes(kind), number));
    out_ << fmt::format(
        "{{\"summary\": {{\"records\": {{{}}}, \"cameras\": [{}], \"robots\": [{}], \"found\": {{{}}}}}}}\n",
        records, cameras, robots, kinds);
    return;
  }
  for (const auto& [type, number] : count.records)
    add(records, fmt::format("{} {}", number, type_name(type)));
  if (count.records_of_other_types > 0) {
    add(records, fmt::format("{} of other types", count.records_of_other_types));
  }
  for (const auto& [id, camera] : count.cameras) {
    add(cameras, fmt::format("camera {} with {} images at {:.1f} Hz", id, camera.images, rate(camera)));
  }
  for (const world::RobotId robot : robots_) add(robots, referee::text(robot));
  for (const auto& [kind, number] : by_kind_) add(kinds, fmt::format("{} {}", number, kind));
  out_ << "records: " << records << "\ncameras: " << cameras
       << "\nrobots:  " << (robots.empty() ? "none" : robots)
       << "\nfound:   " << (kinds.empty() ? "nothing" : kinds) << '\n';
  if (count.referee_messages_unknown > 0) {
    out_ << "left out: " << count.referee_messages_unknown
         << " referee messages with unknown stage or command\n";
  }
}

// The referee of a log of ours, set up as it was in the game.
referee::Setup setup_of(const Survey& survey, const ReplayOptions& options) {
  const auto message =
      survey.first_referee ? wire::decode(*survey.first_referee, survey.epoch) : std::nullopt;
  referee::Setup setup;
  if (survey.ours() && message) {
    try {
      setup = referee::parse_setup(message->status);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(options.file.string() + ": the first referee message: " + error.what());
    }
  }
  if (!options.rules.empty()) {
    const world::RuleSet recorded = setup.rules;
    setup.rules = world::rule_set(options.rules);
    if (survey.ours()) {
      setup.rules.half_length = recorded.half_length;
      setup.rules.winner = recorded.winner;
      setup.rules.extra_half_length = recorded.extra_half_length;
    }
  }
  setup.geometry.field = setup.rules.field;
  if (survey.geometry) setup.geometry = *survey.geometry;
  if (message) {
    setup.blue_on_positive_half = message->blue_on_positive_half;
    for (const Team team : world::both_teams) {
      setup.names[team] = message->teams[team].name;
      setup.keeper[team] = message->teams[team].keeper;
    }
  }
  return setup;
}

// Teams' wishes are not in a log, but their effects are: a new keeper, a time-out begun or ended.
// The message of a tick is read before the tick's batch is complete, so they are heard in the tick in
// which they were granted.
void repeat_requests(const world::RefereeMessage& message, referee::Referee& referee) {
  for (const Team team : world::both_teams) referee.set_keeper(team, message.teams[team].keeper);
  const bool timeout = message.command.kind == CommandKind::Timeout;
  const auto running = referee.state().timeout_team;
  if (timeout && !running) referee.request_timeout(message.command.team);
  if (!timeout && running) referee.end_timeout(*running);
}

LogCount referee_again(const ReplayOptions& options, const Survey& survey, Findings& findings) {
  referee::Referee referee(setup_of(survey, options));
  Listener listener;
  if (survey.ours()) {
    listener.message = [&](const world::RefereeMessage& message) { repeat_requests(message, referee); };
  }
  listener.batch = [&](std::span<const world::Detection> batch) {
    const referee::Output output = referee.update(batch);
    for (const referee::Call& call : output.calls) findings.add(call);
    findings.see(referee.frame());
  };
  return read_log(options.file, survey, listener);
}

LogCount watch(const ReplayOptions& options, const Survey& survey, Findings& findings) {
  const world::RuleSet& rules = world::rule_set(options.rules.empty() ? "ssl-2015" : options.rules);
  world::Geometry geometry;
  geometry.field = rules.field;
  Watcher watcher(rules, survey.geometry.value_or(geometry));
  Listener listener;
  // A batch is complete only when its next image is read, so the messages in between were recorded after it.
  // A log without images has no batch to wait for: then a few are enough.
  std::vector<world::RefereeMessage> messages;
  const auto follow = [&] {
    for (const world::RefereeMessage& message : messages) watcher.follow(message);
    messages.clear();
  };
  listener.message = [&](const world::RefereeMessage& message) {
    if (messages.size() == most_waiting) follow();
    messages.push_back(message);
  };
  listener.batch = [&](std::span<const world::Detection> batch) {
    for (const Sighting& sighting : watcher.update(batch)) findings.add(sighting);
    follow();
    findings.see(watcher.frame());
  };
  return read_log(options.file, survey, listener);
}

}  // namespace

int replay(const ReplayOptions& options, std::ostream& out, std::ostream& errors) {
  const Survey survey = survey_log(options.file);
  Findings findings(out, options.json);
  const bool referee = options.mode == ReplayOptions::Mode::Referee ||
                       (options.mode == ReplayOptions::Mode::Auto && survey.ours());
  const LogCount count =
      referee ? referee_again(options, survey, findings) : watch(options, survey, findings);
  findings.summarise(count);
  out.flush();
  if (!count.defect.empty()) {
    errors << "ssl-autoref: " << count.defect << '\n';
    return 2;
  }
  if (!survey.has_vision) throw std::runtime_error(options.file.string() + ": holds no vision messages");
  return 0;
}

}  // namespace autoref
