#include "experiments/judge/game_file.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "experiments/judge/json_values.h"
#include "experiments/process/whole_file.h"

namespace judge {
namespace {

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
  if (!event) throw std::invalid_argument("no event: " + json.at("event").get<std::string>());
  one.event = *event;
  const std::string result = json.at("result").get<std::string>();
  one.result = result == name(Result::Found)    ? Result::Found
               : result == name(Result::Missed) ? Result::Missed
                                                : Result::Extra;
  one.chip = json.value("chip", false);
  one.remark = json.value("remark", "");
  if (json.contains("truth")) one.truth = truth_in(json.at("truth"), one.event);
  if (json.contains("call")) one.call = call_in(json.at("call"), one.event);
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

std::string whole_file(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
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
    result.seed = head.at("seed").get<std::uint64_t>();
    result.ticks = head.at("ticks").get<std::int64_t>();
    result.hash = head.at("hash").get<std::string>();
    result.fault = head.at("fault").get<std::string>();
    result.shadows = head.at("shadows").get<std::vector<std::string>>();
    result.witnesses = head.at("witnesses").get<std::vector<std::string>>();
    result.happened = head.at("happened").get<std::array<int, event_count>>();
    result.close = head.at("close").get<std::array<int, event_count>>();
    result.near_misses = head.at("near_misses").get<std::array<int, event_count>>();
    for (const Json& count : head.at("touches")) {
      result.touches.push_back(
          {count.at("witness").get<std::string>(), count.at("window").get<double>(),
           count.at("found").get<std::array<int, kinds>>(), count.at("missed").get<std::array<int, kinds>>(),
           count.at("extra").get<int>(), count.at("own").get<int>(), count.at("again").get<int>()});
    }
    while (std::getline(stream, words)) {
      ++line;
      result.cases.push_back(case_in(Json::parse(words)));
    }
    if (result.cases.size() != head.at("cases").get<std::size_t>()) {
      throw std::invalid_argument(std::to_string(result.cases.size()) + " of " +
                                  std::to_string(head.at("cases").get<std::size_t>()) + " cases are there");
    }
  } catch (const std::exception& error) {  // nlohmann's, ours, and those of std::stoi
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
  return game_from_json(whole_file(file), file.string());
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
