#include "experiments/runner/job_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "experiments/process/whole_file.h"
#include "sim/files/regular_file.h"

namespace runner {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest = std::size_t{256}
                                << 20;  // [bytes] ours: the record of a long game has some MiB

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream << text << '\n';
  stream.close();
  if (!stream) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace

fs::path progress_file(const fs::path& result) { return result.parent_path() / "progress"; }

ProgressWriter::ProgressWriter(const fs::path& file)
    : file_(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {
  if (file_ < 0) {
    throw std::runtime_error(file.string() +
                             ": cannot be written: " + std::generic_category().message(errno));
  }
}
ProgressWriter::~ProgressWriter() { ::close(file_); }

void ProgressWriter::write(double seconds) {
  std::array<char, 32> line{};
  const int length = std::snprintf(line.data(), line.size(), "%20.3f\n", seconds);
  // A missed sign of life is followed by another one.
  [[maybe_unused]] const ssize_t ignored = ::pwrite(file_, line.data(), static_cast<std::size_t>(length), 0);
}

std::optional<double> read_progress(const fs::path& file) {
  if (!files::not_regular(file).empty()) return std::nullopt;
  std::ifstream stream(file);
  double seconds = 0;
  if (stream >> seconds) return seconds;
  return std::nullopt;
}

void write_job(const fs::path& file, const record::MatchConfig& config) {
  process::write_whole(file, record::to_json(config) + '\n');
}

void serve_job(const fs::path& job, const fs::path& result,
               const std::function<record::MatchRecord(const record::MatchConfig&)>& play) {
  const record::MatchRecord record = play(record::match_config_from_json(files::text_of(job, longest)));
  fs::path unfinished = result;
  unfinished += ".part";
  write_text(unfinished, record::to_json(record));
  fs::rename(unfinished, result);
}

record::MatchRecord read_result(const fs::path& file) {
  return record::match_record_from_json(files::text_of(file, longest));
}

}  // namespace runner
