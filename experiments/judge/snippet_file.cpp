#include <sstream>
#include <stdexcept>

#include "experiments/judge/json_values.h"
#include "experiments/judge/snippet.h"
#include "experiments/judge/state_text.h"
#include "sim/files/regular_file.h"

namespace judge {

constexpr std::size_t longest = std::size_t{64}
                                << 20;  // [bytes] ours: a passage of some seconds has some KiB

std::string to_json(const Snippet& snippet) {
  // One line per event and state, so that the file can be read and trimmed by hand.
  const auto list = [](const std::vector<std::string>& lines) {
    std::string text = "[";
    for (std::size_t n = 0; n < lines.size(); ++n) text += (n > 0 ? ",\n    " : "\n    ") + lines[n];
    return text + "]";
  };
  std::vector<std::string> truth, states, events;
  for (const TrueEvent& one : snippet.truth) {
    Json json;
    json["event"] = name(one.event);
    json.update(json_of(one));
    truth.push_back(json.dump());
  }
  for (const Snippet::State& one : snippet.states) {
    states.push_back("{\"until\": " + std::to_string(ns(one.until)) +
                     ", \"state\": " + state_text(one.state) + "}");
  }
  for (const Event event : snippet.events) events.push_back(Json(name(event)).dump());
  Json by_hand = Json::array();
  for (const world::Time time : snippet.by_hand) by_hand.push_back(ns(time));
  std::ostringstream text;
  text << "{\n  \"game\": " << Json(snippet.game).dump() << ",\n  \"rules\": " << Json(snippet.rules).dump()
       << ",\n  \"from\": " << ns(snippet.from) << ",\n  \"to\": " << ns(snippet.to)
       << ",\n  \"events\": " << list(events) << ",\n  \"truth\": " << list(truth)
       << ",\n  \"by_hand\": " << by_hand.dump() << ",\n  \"states\": " << list(states) << "\n}\n";
  return text.str();
}

Snippet read_snippet(const std::filesystem::path& file) {
  const std::filesystem::path path = expectation_of(file);
  std::string text;
  try {
    text = files::text_of(path, longest);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
  Snippet snippet;
  try {
    const Json json = Json::parse(text);
    const auto event_in = [](const Json& its) {
      const auto event = event_named(its.get<std::string>());
      if (!event) throw std::invalid_argument("no event is called " + its.dump().substr(0, 60));
      return *event;
    };
    snippet.game = json.at("game").get<std::string>();
    snippet.rules = json.at("rules").get<std::string>();
    world::rule_set(snippet.rules);  // says which there are
    snippet.from = time_in(json.at("from"));
    snippet.to = time_in(json.at("to"));
    for (const Json& one : json.at("events")) snippet.events.push_back(event_in(one));
    for (const Json& one : json.at("truth"))
      snippet.truth.push_back(truth_in(one, event_in(one.at("event"))));
    for (const Json& one : json.at("by_hand")) snippet.by_hand.push_back(time_in(one));
    for (const Json& one : json.at("states")) {
      snippet.states.push_back({time_in(one.at("until")), state_in(one.at("state").dump())});
    }
    if (snippet.states.empty()) throw std::invalid_argument("'states' is empty");
  } catch (const std::exception& error) {  // nlohmann's and ours
    throw std::invalid_argument(path.string() + ": " + error.what() +
                                "; write it again with matchday judge DESIGN --show ... --save FILE");
  }
  return snippet;
}

}  // namespace judge
