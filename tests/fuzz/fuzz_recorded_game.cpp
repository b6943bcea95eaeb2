#include <stdexcept>

#include "experiments/host/play.h"
#include "experiments/host/recorded_teams.h"
#include "sim/wire/delimited.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

// Frames, each a record, are written as a recording with all that guards it, and then played:
// damage that looks whole.
bool fuzz::recorded_game(std::string_view bytes) {
  const std::filesystem::path file = scratch() / "fuzzed.replies";
  try {
    wire::FrameReader reader;
    wire::RecordingWriter writer(file);
    reader.append(std::as_bytes(std::span(bytes)));
    while (const auto payload = reader.next()) {
      wire::proto::Recorded record;
      if (!record.ParseFromArray(payload->data(), static_cast<int>(payload->size()))) break;
      writer.write(record);
    }
    writer.close();
  } catch (const wire::FrameError&) {
    return false;
  }
  try {
    record::MatchConfig config = host::recorded_config(file);
    config.continuation = record::Continuation{file, std::nullopt};
    config.recording.reset();
    config.log.reset();
    config.directory.clear();
    host::Options options;
    options.last_tick = 120;  // a tick takes a millisecond here
    const record::MatchRecord record = host::play(config, options);
    if (!record.reason.empty()) check_sentence(record.reason);
    if (record.reason.starts_with("internal error: ")) check_sentence(record.reason, file);
    return record.ticks > 0;
  } catch (const std::invalid_argument& error) {
    check_sentence(error.what());
  } catch (const std::runtime_error& error) {
    check_sentence(error.what(), file);
  }
  return false;
}
