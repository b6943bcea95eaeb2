#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/bench/figures.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

// What tells our files from others'.
constexpr const char* maker = "matchday bench";
constexpr int format_version = 1;

// Reads numbers out of one object of a file; whatever is wrong is a sentence with the file's name.
class Reader {
 public:
  Reader(const Json& object, std::string file, std::string path = {})
      : object_(object), file_(std::move(file)), path_(std::move(path)) {}

  double number(const char* key) const {
    const auto value = object_.find(key);
    if (value == object_.end()) fail(key, "is missing");
    if (!value->is_number()) fail(key, "is not a number but " + value->dump());
    return value->get<double>();
  }
  double positive(const char* key) const {
    const double value = number(key);
    if (!(value > 0)) fail(key, "is " + Json(value).dump() + ", it must be above 0");
    return value;
  }
  std::string text(const char* key) const {
    const auto value = object_.find(key);
    if (value == object_.end() || !value->is_string()) fail(key, "is missing or no text");
    return value->get<std::string>();
  }
  Reader object(const char* key) const {
    const auto value = object_.find(key);
    if (value == object_.end() || !value->is_object()) fail(key, "is missing or no object");
    return {*value, file_, path_ + key + "."};
  }
  const Json& json() const { return object_; }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    throw std::invalid_argument(file_ + ": " + path_ + key + " " + what +
                                "; make the file again with `matchday bench --json`");
  }
  const Json& object_;
  std::string file_, path_;
};

}  // namespace

std::string json(const Figures& figures) {
  Json out;
  out["made_by"] = maker;
  out["format"] = format_version;
  out["realism"] = figures.realism;
  out["hash"] = figures.hash;
  out["ticks"] = figures.ticks;
  out["loop_seconds"] = figures.loop_seconds;
  out["times_real_time"] = figures.times_real_time();
  out["times_real_time_cpu"] = figures.times_real_time_cpu();
  out["reference_tick_us"] = figures.reference_tick * 1e6;
  out["tick_us"] = figures.tick_wall() * 1e6;
  out["tick_of_reference"] = figures.tick_wall() / figures.reference_tick;
  for (const Row& row : figures.rows) {
    Json entry;
    entry["mean_us"] = row.mean * 1e6;
    if (row.median >= 0) entry["median_us"] = row.median * 1e6;
    if (row.ninety_nine >= 0) entry["p99_us"] = row.ninety_nine * 1e6;
    entry["of_reference"] = row.mean / figures.reference_tick;
    out["parts"][row.part] = entry;
  }
  out["host_cpu_seconds"] = figures.host_cpu;
  out["teams_cpu_seconds"] = figures.teams_cpu;
  out["peak_memory_bytes"] = {
      {"host", figures.memory_host}, {"yellow", figures.memory_yellow}, {"blue", figures.memory_blue}};
  out["messages_per_tick"] = figures.messages_per_tick;
  out["bytes_out_per_tick"] = figures.bytes_out_per_tick;
  out["bytes_in_per_tick"] = figures.bytes_in_per_tick;
  out["calls_per_tick"] = figures.calls_per_tick;
  out["switches_per_tick"] = figures.switches_per_tick;
  if (const auto& scaling = figures.scaling) {
    out["scaling"] = {{"workers", scaling->workers},
                      {"games_per_hour_alone", scaling->alone},
                      {"games_per_hour", scaling->together},
                      {"ratio", scaling->ratio()}};
  }
  return out.dump(2) + "\n";
}

Figures figures_from_json(const std::string& text, const std::string& file) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) {
    throw std::invalid_argument(file +
                                ": this is not JSON, or cut off; make it with `matchday bench --json`");
  }
  const Reader top(json, file);
  if (json.value("made_by", Json()) != maker) {
    throw std::invalid_argument(file + ": made_by is not \"" + maker +
                                "\": the file is another program's; make one with `matchday bench --json`");
  }
  if (json.value("format", Json()) != format_version) {
    throw std::invalid_argument(file + ": format is " + json.value("format", Json()).dump() +
                                ", this matchday reads " + std::to_string(format_version) +
                                "; make the file again with `matchday bench --json`");
  }
  Figures figures;
  figures.realism = top.text("realism");
  figures.hash = top.text("hash");
  figures.ticks = static_cast<std::int64_t>(top.positive("ticks"));
  figures.loop_seconds = top.positive("loop_seconds");
  figures.reference_tick = top.positive("reference_tick_us") * 1e-6;
  const Reader parts = top.object("parts");
  for (const auto& [part, entry] : parts.json().items()) {
    figures.rows.push_back({part, parts.object(part.c_str()).number("mean_us") * 1e-6});
    figures.sum += figures.rows.back().mean;
  }
  figures.host_cpu = top.positive("host_cpu_seconds");
  figures.teams_cpu = top.positive("teams_cpu_seconds");
  const Reader memory = top.object("peak_memory_bytes");
  figures.memory_host = static_cast<std::int64_t>(memory.positive("host"));
  figures.memory_yellow = static_cast<std::int64_t>(memory.positive("yellow"));
  figures.memory_blue = static_cast<std::int64_t>(memory.positive("blue"));
  figures.messages_per_tick = top.number("messages_per_tick");
  figures.bytes_out_per_tick = top.number("bytes_out_per_tick");
  figures.bytes_in_per_tick = top.number("bytes_in_per_tick");
  figures.calls_per_tick = top.number("calls_per_tick");
  figures.switches_per_tick = top.number("switches_per_tick");
  if (json.contains("scaling")) {
    const Reader scaling = top.object("scaling");
    figures.scaling = Scaling{static_cast<int>(scaling.positive("workers")),
                              scaling.positive("games_per_hour_alone"), scaling.positive("games_per_hour")};
  }
  return figures;
}

}  // namespace bench
