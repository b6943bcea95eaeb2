#include "sim/wire/log_file.h"
#include "sim/wire/log_messages.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::league_log_gz(std::string_view bytes) {
  const std::filesystem::path file = stored(bytes, "fuzzed.log.gz");
  try {
    wire::LogReader reader(file);
    wire::LogRecord record;
    matchday::vision::SSL_WrapperPacket packet;
    while (reader.next(record)) wire::read(record, packet);
    if (reader.truncated()) check_sentence(reader.truncation(), file);
    return reader.records() > 0;
  } catch (const std::runtime_error& error) {
    check_sentence(error.what(), file);
    return false;
  }
}
