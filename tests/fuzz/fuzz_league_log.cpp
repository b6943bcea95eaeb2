#include <sstream>

#include "autoref/calibrate_log.h"
#include "autoref/replay.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::league_log(std::string_view bytes) {
  const std::filesystem::path file = stored(bytes, "fuzzed.log");
  bool understood = false;
  const auto run = [&](const auto& command) {
    std::ostringstream out;
    std::ostringstream errors;
    try {
      understood |= command(out, errors) == 0;
      std::string sentence = errors.str();
      if (sentence.ends_with('\n')) sentence.pop_back();
      if (!sentence.empty()) check_sentence(sentence, file);
    } catch (const std::runtime_error& error) {
      check_sentence(error.what(), file);
    }
  };
  using autoref::ReplayOptions;
  for (const auto mode : {ReplayOptions::Mode::Referee, ReplayOptions::Mode::Watch}) {
    run([&](std::ostream& out, std::ostream& errors) {
      return autoref::replay({.file = file, .rules = "", .json = false, .mode = mode}, out, errors);
    });
  }
  run([&](std::ostream& out, std::ostream& errors) {
    autoref::CalibrateOptions options;
    options.file = file;
    return autoref::calibrate_log(options, out, errors);
  });
  return understood;
}
