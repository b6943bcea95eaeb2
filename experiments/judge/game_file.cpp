#include "experiments/judge/game_file.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "experiments/judge/json_values.h"
#include "experiments/process/whole_file.h"
#include "sim/files/regular_file.h"

namespace judge {
namespace {

constexpr std::size_t longest_shown = 60;  // of a value in a message
constexpr std::size_t longest_file = std::size_t{256}
                                     << 20;  // [bytes] ours: a game of many offences has some MiB
constexpr std::array all_results = {Result::Found, Result::Missed, Result::Extra};

template <std::size_t size>
std::array<int, size> counts_in(const Json& json) {
  if (!json.is_array() || json.size() != size) {
    throw std::invalid_argument("there must be " + std::to_string(size) + " counts");
  }
  std::array<int, size> counts{};
  for (std::size_t n = 0; n < size; ++n) counts[n] = count_in(json[n]);
  return counts;
}

/// Who looked on: tables look things up by these names.
std::vector<std::string> shadows_in(const Json& json) {
  const auto shadows = json.get<std::vector<std::string>>();
  for (const std::string& name : shadows) {
    if (name != acting_name) parse_shadow(name);
  }
  return shadows;
}

Json json_of(const Call& call) {
  Json json;
  json["time"] = ns(call.time);
  json["reported"] = ns(call.reported);
  if (call.by) json["by"] = text_of(*call.by);
  json["place"] = place_of(call.place);
  if (call.late) json["late"] = true;
  if (call.last) json["last"] = touch_of(call.last);
  if (!call.witnesses.empty()) {
    json["witnesses"] = Json::array();
    for (const auto& touch : call.witnesses) json["witnesses"].push_back(touch_of(touch));
  }
  return json;
}

Call call_in(const Json& json, Event event) {
  Call call;
  call.event = event;
  call.time = time_in(json.at("time"));
  call.reported = time_in(json.at("reported"));
  if (json.contains("by")) call.by = robot_in(json.at("by").get<std::string>());
  call.place = place_in(json.at("place"));
  call.late = json.value("late", false);
  if (json.contains("last")) call.last = touch_in(json.at("last"));
  if (json.contains("witnesses")) {
    for (const Json& touch : json.at("witnesses")) call.witnesses.push_back(touch_in(touch));
  }
  return call;
}

Json json_of(const Case& one) {
  Json json;
  json["shadow"] = one.shadow;
  json["event"] = name(one.event);
  json["result"] = name(one.result);
  if (one.chip) json["chip"] = true;
  if (!one.remark.empty()) json["remark"] = one.remark;
  if (one.truth) json["truth"] = json_of(*one.truth);
  if (one.call) json["call"] = json_of(*one.call);
  return json;
}

Case case_in(const Json& json) {
  Case one;
  one.shadow = json.at("shadow").get<std::string>();
  const auto event = event_named(json.at("event").get<std::string>());
  if (!event) throw std::invalid_argument("no event: " + json.at("event").dump().substr(0, longest_shown));
  one.event = *event;
  const std::string result = json.at("result").get<std::string>();
  const auto named = [&](Result its) { return result == name(its); };
  const auto found = std::ranges::find_if(all_results, named);
  if (found == all_results.end()) {
    throw std::invalid_argument("no result: '" + result.substr(0, longest_shown) + "'");
  }
  one.result = *found;
  one.chip = json.value("chip", false);
  one.remark = json.value("remark", "");
  if (json.contains("truth")) one.truth = truth_in(json.at("truth"), one.event);
  if (json.contains("call")) one.call = call_in(json.at("call"), one.event);
  if (one.event == Event::Exit && one.truth && !one.truth->last) {
    throw std::invalid_argument("an exit that nobody touched");
  }
  const bool whole = one.result == Result::Extra ? one.call && !one.truth
                                                 : one.truth && (one.call || one.result == Result::Missed);
  if (!whole) throw std::invalid_argument("a case of '" + result + "' lacks its truth or its call");
  return one;
}

Json json_of(const TouchCount& count) {
  return {{"witness", count.witness}, {"window", count.window}, {"found", count.found},
          {"missed", count.missed},   {"extra", count.extra},   {"own", count.own},
          {"again", count.again}};
}

}  // namespace

std::string to_json(const GameResult& result) {
  Json head;
  head["game"] = result.game;
  head["preset"] = result.preset;
  head["seed"] = result.seed;
  head["ticks"] = result.ticks;
  head["hash"] = result.hash;
  head["fault"] = result.fault;
  head["shadows"] = result.shadows;
  head["witnesses"] = result.witnesses;
  head["happened"] = result.happened;
  head["close"] = result.close;
  head["near_misses"] = result.near_misses;
  head["touches"] = Json::array();
  for (const TouchCount& count : result.touches) head["touches"].push_back(json_of(count));
  head["cases"] = result.cases.size();
  std::string text = head.dump() + "\n";
  for (const Case& one : result.cases) text += json_of(one).dump() + "\n";
  return text;
}

GameResult game_from_json(const std::string& text, const std::string& name) {
  GameResult result;
  int line = 0;
  try {
    std::istringstream stream(text);
    std::string words;
    ++line;
    std::getline(stream, words);
    const Json head = Json::parse(words);
    result.game = head.at("game").get<std::string>();
    result.preset = head.at("preset").get<std::string>();
    if (!head.at("seed").is_number_unsigned())
      throw std::invalid_argument("the seed is no whole number from 0 on");
    result.seed = head.at("seed").get<std::uint64_t>();
    result.ticks = count_in(head.at("ticks"));
    result.hash = head.at("hash").get<std::string>();
    result.fault = head.at("fault").get<std::string>();
    result.shadows = shadows_in(head.at("shadows"));
    result.witnesses = head.at("witnesses").get<std::vector<std::string>>();
    result.happened = counts_in<event_count>(head.at("happened"));
    result.close = counts_in<event_count>(head.at("close"));
    result.near_misses = counts_in<event_count>(head.at("near_misses"));
    for (const Json& count : head.at("touches")) {
      result.touches.push_back({count.at("witness").get<std::string>(), number_in(count.at("window")),
                                counts_in<kinds>(count.at("found")), counts_in<kinds>(count.at("missed")),
                                count_in(count.at("extra")), count_in(count.at("own")),
                                count_in(count.at("again"))});
    }
    while (std::getline(stream, words)) {
      ++line;
      result.cases.push_back(case_in(Json::parse(words)));
    }
    for (const Case& one : result.cases) {  // the tables look them up by the witnesses' places
      if (one.shadow != acting_name || one.event != Event::Exit || !one.call) continue;
      if (one.call->witnesses.size() == result.witnesses.size()) continue;
      throw std::invalid_argument("a call has " + std::to_string(one.call->witnesses.size()) + " of " +
                                  std::to_string(result.witnesses.size()) + " witnesses");
    }
    if (const int cases = count_in(head.at("cases"));
        result.cases.size() != static_cast<std::size_t>(cases)) {
      throw std::invalid_argument(std::to_string(result.cases.size()) + " of " + std::to_string(cases) +
                                  " cases are there");
    }
  } catch (const std::exception& error) {  // nlohmann's and ours
    throw std::invalid_argument(name + ":" + std::to_string(line) + ": " + error.what() +
                                "; remove the file and the game is judged again");
  }
  return result;
}

void write_game(const std::filesystem::path& file, const GameResult& result) {
  process::write_whole(file, to_json(result));
}

std::optional<GameResult> read_game(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  return game_from_json(files::text_of(file, longest_file), file.string());
}

std::string to_json(const Job& job) {
  Json json;
  json["game"] = job.game;
  json["config"] = record::to_json(job.config);
  json["shadows"] = Json::array();
  for (const ShadowConfig& shadow : job.shadows) json["shadows"].push_back(shadow.name);
  if (!job.keep.empty()) json["keep"] = job.keep.string();
  if (!job.again.empty()) json["again"] = job.again.string();
  return json.dump();
}

Job job_from_json(const std::string& text) {
  Job job;
  try {
    const Json json = Json::parse(text);
    job.game = json.at("game").get<std::string>();
    job.config = record::match_config_from_json(json.at("config").get<std::string>());
    for (const Json& shadow : json.at("shadows"))
      job.shadows.push_back(parse_shadow(shadow.get<std::string>()));
    job.keep = json.value("keep", "");
    job.again = json.value("again", "");
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("the judge's job: ") + error.what());
  }
  return job;
}

}  // namespace judge
