#include "sim/engine/realism.h"

#include <fmt/format.h>

#include <charconv>
#include <iostream>
#include <stdexcept>

#include "experiments/commands.h"
#include "experiments/exit_code.h"
#include "experiments/host/play.h"
#include "experiments/schedule/design.h"

namespace commands {
namespace {

void change(const std::string& word, record::RealismConfig& realism) {
  const std::size_t equals = word.find('=');
  double value = 0;
  const char* end = word.data() + word.size();
  const auto parsed = equals == std::string::npos ? std::from_chars_result{}
                                                  : std::from_chars(word.data() + equals + 1, end, value);
  if (equals == std::string::npos || parsed.ec != std::errc{} || parsed.ptr != end) {
    throw std::invalid_argument("--set " + word + ": must be a key and a number, as vision.ball_sigma=0.001");
  }
  realism.changes[word.substr(0, equals)] = value;
}

}  // namespace

record::RealismConfig realism_config(const RealismOptions& options) {
  record::RealismConfig realism;
  if (options.preset.ends_with(".toml")) {
    realism = schedule::read_realism(options.preset, host::check_realism);
  } else {
    realism.preset = options.preset;
  }
  for (const std::string& word : options.changes) change(word, realism);
  host::check_realism(realism);
  return realism;
}

int realism(const RealismOptions& options) {
  const record::RealismConfig config = realism_config(options);
  engine::Realism realism = engine::realism(config.preset);
  for (const auto& [key, value] : config.changes) engine::set(realism, key, value);

  std::cout << "# " << record::text(config) << "\n[realism]\npreset = \"" << config.preset << "\"\n";
  std::string group;
  for (const engine::RealismKey& key : engine::realism_keys()) {
    const std::size_t dot = key.name.find('.');
    if (key.name.substr(0, dot) != group) {
      group = key.name.substr(0, dot);
      std::cout << "\n[realism." << group << "]\n";
    }
    const std::string setting = fmt::format("{} = {}", key.name.substr(dot + 1), key.get(realism));
    const std::string unit = key.unit.empty() ? "" : fmt::format(" [{}]", key.unit);
    std::cout << fmt::format("{:<32} # {}{}, {} to {}\n", setting, key.meaning, unit, key.lowest,
                             key.highest);
  }
  return done;
}

}  // namespace commands
