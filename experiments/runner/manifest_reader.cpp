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
  std::string protocol;
  try {
    const auto json = nlohmann::json::parse(text, [](int depth, auto, auto&) {
      if (depth > 64) throw std::invalid_argument("nested too deep");
      return true;
    });
    json.at("experiment_hash").get_to(origin.experiment_hash);
    json.at("matchday").get_to(origin.matchday);
    json.at("commit").get_to(origin.commit);
    json.at("protocol").get_to(protocol);
    if (json.contains("isolation")) json.at("isolation").get_to(origin.isolation);
    for (const auto& one : json.at("files")) {
      origin.files.push_back({one.at("path").get<std::string>(), one.at("xxh3_128").get<std::string>()});
    }
  } catch (const std::exception& error) {
    throw record::StorageError(file.string() + ": is damaged: " + error.what());
  }
  std::vector<std::string> hashes;
  for (const ProgramFile& one : origin.files) hashes.push_back(one.hash);
  std::sort(hashes.begin(), hashes.end());
  std::string all = design_line(text) + "\n" + protocol + "\n";
  for (const std::string& hash : hashes) all += hash + "\n";
  origin.identity = hash_of(all);
  return origin;
}

}  // namespace runner
