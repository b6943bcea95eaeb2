#include "experiments/runner/job_files.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace runner {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read");
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream << text << '\n';
  stream.close();
  if (!stream) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace

void write_job(const fs::path& file, const record::MatchConfig& config) {
  write_text(file, record::to_json(config));
}

void serve_job(const fs::path& job, const fs::path& result,
               const std::function<record::MatchRecord(const record::MatchConfig&)>& play) {
  const record::MatchRecord record = play(record::match_config_from_json(read_text(job)));
  fs::path unfinished = result;
  unfinished += ".part";
  write_text(unfinished, record::to_json(record));
  fs::rename(unfinished, result);
}

record::MatchRecord read_result(const fs::path& file) {
  return record::match_record_from_json(read_text(file));
}

}  // namespace runner
