#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/record/ledger.h"
#include "experiments/runner/manifest.h"
#include "sim/files/regular_file.h"

namespace runner {
namespace {

constexpr std::size_t longest = std::size_t{64} << 20;  // [bytes] ours: a design has at most 1 MiB

/// The design as it was hashed: a line of its own.
std::string design_line(const std::string& text) {
  const std::string key = "\n  \"design\": ";
  const std::size_t begin = text.find(key);
  if (begin == std::string::npos) return {};
  const std::size_t end = text.find('\n', begin + 1);
  std::string line = text.substr(begin + key.size(), end - begin - key.size());
  if (!line.empty() && line.back() == ',') line.pop_back();
  return line;
}

}  // namespace

std::string level_of(const std::string& isolation) {
  const std::string key = "isolation ";
  if (!isolation.starts_with(key)) return {};
  return isolation.substr(key.size(), isolation.find(',') - key.size());
}

Origin read_manifest(const std::filesystem::path& file) {
  std::string text;
  try {
    text = files::text_of(file, longest);
  } catch (const std::runtime_error& error) {
    throw record::StorageError(error.what());
  }
  Origin origin;
  try {
    const auto json = nlohmann::json::parse(text, [](int depth, auto, auto&) {
      if (depth > 64) throw std::invalid_argument("nested too deep");
      return true;
    });
    json.at("experiment_hash").get_to(origin.experiment_hash);
    json.at("matchday").get_to(origin.matchday);
    json.at("commit").get_to(origin.commit);
    json.at("protocol").get_to(origin.protocol);
    if (json.contains("ledger_schema")) json.at("ledger_schema").get_to(origin.ledger_schema);
    if (json.contains("isolation")) json.at("isolation").get_to(origin.isolation);
    for (const auto& one : json.at("files")) {
      origin.files.push_back({one.at("path").get<std::string>(), one.at("xxh3_128").get<std::string>()});
    }
  } catch (const std::exception& error) {
    throw record::StorageError(file.string() + ": is damaged: " + error.what());
  }
  origin.design = design_line(text);
  origin.identity = experiment_hash(origin.design, origin.files, origin.protocol);
  return origin;
}

void take_commits(const Origin& origin, schedule::Design& design) {
  const auto json = nlohmann::json::parse(origin.design, nullptr, false);
  const auto take = [&](std::size_t index, const char* team, std::optional<schedule::Source>& source) {
    if (!source) return;
    try {
      json.at("conditions").at(index).at(team).at("revision").get_to(source->commit);
    } catch (const nlohmann::json::exception&) {  // it has another design, which the comparison will tell
    }
  };
  for (std::size_t i = 0; i < design.conditions.size(); ++i) {
    take(i, "a", design.conditions[i].a_source);
    take(i, "b", design.conditions[i].b_source);
  }
}

}  // namespace runner
