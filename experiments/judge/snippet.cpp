#include "experiments/judge/snippet.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "experiments/host/league_log.h"
#include "experiments/judge/state_text.h"
#include "experiments/process/whole_file.h"
#include "sim/wire/referee.h"
#include "sim/wire/vision.h"

namespace judge {
namespace {

constexpr int message_interval = 6;  // [ticks] ten times a second, as in a league log
// [ticks] before the one in which it is delivered: the delay of harsh, and one
constexpr int oldest_image = 3;

std::string base_of(const std::filesystem::path& snippet) {
  const std::string name = snippet.string();
  for (const std::string_view ending : {".log.gz", ".json"}) {
    if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  }
  return name;
}

world::Time at_tick(std::int64_t tick) {
  return world::Time{world::from_seconds(static_cast<double>(tick) / world::ticks_per_second)};
}

}  // namespace

std::filesystem::path log_of(const std::filesystem::path& snippet) { return base_of(snippet) + ".log.gz"; }
std::filesystem::path expectation_of(const std::filesystem::path& snippet) {
  return base_of(snippet) + ".json";
}

Timeline Snippet::timeline() const {
  Timeline timeline;
  for (const State& one : states) timeline.add(one.until, one.state);
  return timeline;
}

std::vector<Case> Snippet::judge(const std::vector<Call>& calls) const {
  std::vector<Case> cases = pair("", truth, calls, world::rule_set(rules));
  std::erase_if(cases, [&](const Case& one) {
    const bool wanted = std::ranges::find(events, one.event) != events.end();
    return !wanted || one.time() < from || one.time() > to;
  });
  return cases;
}

struct SnippetWriter::Log {
  explicit Log(host::LeagueLog its) : log(std::move(its)) {}
  host::LeagueLog log;
  google::protobuf::RepeatedPtrField<wire::proto::SSL_WrapperPacket> packets;
  wire::proto::Referee message;
  std::uint32_t command_counter = 0;
};

SnippetWriter::SnippetWriter(std::filesystem::path file, std::string rules, std::int64_t first,
                             std::int64_t last)
    : file_(std::move(file)), first_(first), last_(last) {
  snippet_.rules = std::move(rules);
  snippet_.from = at_tick(first) + warm_up;
  snippet_.to = at_tick(last) - run_out;
  if (snippet_.to <= snippet_.from) {
    throw std::invalid_argument("--save " + file_.string() + ": a passage of " +
                                std::to_string(last - first) +
                                " ticks is too short; give at least 60, better 180");
  }
}
SnippetWriter::~SnippetWriter() = default;

void SnippetWriter::tick(const engine::Engine& engine, const referee::Referee& referee) {
  if (engine.tick() < first_ || engine.tick() > last_) return;
  const world::RefereeMessage& message = referee.message();
  if (!log_) {
    if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path());
    wire::proto::Referee first;
    wire::encode(message, wire::Epoch{}, first);
    first.set_source_identifier("matchday");
    first.set_status_message("rules=" + snippet_.rules);
    log_ = std::make_unique<Log>(host::LeagueLog(log_of(file_), engine.model().geometry, first));
  }
  log_->packets.Clear();
  for (const world::Detection& image : engine.detections()) {
    wire::encode(image, wire::Epoch{}, *log_->packets.Add()->mutable_detection());
  }
  const bool due = std::exchange(log_->command_counter, message.command_counter) != message.command_counter ||
                   engine.tick() % message_interval == 0;
  if (due) {
    wire::encode(message, wire::Epoch{}, log_->message);
    log_->message.set_source_identifier("matchday");
  }
  log_->log.add(engine.time(), log_->packets, due ? &log_->message : nullptr);
  complete_ = engine.tick() == last_;
}

void SnippetWriter::frame(world::Time time, const world::GameState& state, bool by_hand) {
  if (time < at_tick(first_ - oldest_image) || time > at_tick(last_)) return;
  if (by_hand) snippet_.by_hand.push_back(time);
  world::GameState kept = state;
  // In play a shadow has its own, but for the one with which it begins.
  const bool begun = time > at_tick(first_);
  if (begun && state.location == world::Location::GameOn) kept.last_touch.reset();
  std::string text = state_text(kept);
  if (text != state_) {
    snippet_.states.push_back({time, kept});
    state_ = std::move(text);
  }
  snippet_.states.back().until = time;
}

std::vector<Case> SnippetWriter::close(const std::string& game, const std::vector<TrueEvent>& truth,
                                       const std::vector<Call>& calls) {
  if (!complete_) {
    throw std::invalid_argument("--save " + file_.string() + ": the game was over before tick " +
                                std::to_string(last_));
  }
  log_->log.close();
  snippet_.game = game + ":" + std::to_string(first_) + "-" + std::to_string(last_);
  for (const TrueEvent& event : truth) {
    if (event.time >= at_tick(first_) && event.time <= at_tick(last_)) snippet_.truth.push_back(event);
  }
  const auto everything = all_events();
  snippet_.events.assign(everything.begin(), everything.end());
  std::vector<Case> cases = snippet_.judge(calls);
  std::erase_if(snippet_.events, [&](Event event) {
    return std::ranges::none_of(
        cases, [&](const Case& one) { return one.event == event && !one.close() && !one.ambiguous(); });
  });
  const std::filesystem::path file = expectation_of(file_);
  process::write_whole(file, to_json(snippet_));
  return cases;
}

}  // namespace judge
