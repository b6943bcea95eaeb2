#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"

namespace runner {

// Runner and worker talk through files in the game's folder. Two are one line of JSON: the configuration, and
// the record once the game is over. A worker is a program that is started with the names of these two, plays,
// and ends with code 0. Beside the result it writes `progress`, how far the game is in simulated time: its
// sign of life. Whatever it prints is its log.

void write_job(const std::filesystem::path& file, const record::MatchConfig& config);

/// The name of the sign of life that belongs to a result.
std::filesystem::path progress_file(const std::filesystem::path& result);

/// The worker's side of the sign of life: one line of fixed length, written over and over, which needs no
/// further room on a full disk.
class ProgressWriter {
 public:
  /// @throws std::runtime_error naming the file
  explicit ProgressWriter(const std::filesystem::path& file);
  ProgressWriter(const ProgressWriter&) = delete;
  ProgressWriter& operator=(const ProgressWriter&) = delete;
  ~ProgressWriter();

  /// @param seconds  simulated
  void write(double seconds);

 private:
  int file_ = -1;
};

/// Simulated seconds so far; nothing before the first.
std::optional<double> read_progress(const std::filesystem::path& file);

/// The worker's side: reads the job, plays it, writes the result under its name when it is whole.
///
/// @throws std::invalid_argument or std::runtime_error with one sentence
void serve_job(const std::filesystem::path& job, const std::filesystem::path& result,
               const std::function<record::MatchRecord(const record::MatchConfig&)>& play);

/// @throws std::runtime_error when there is no whole result
record::MatchRecord read_result(const std::filesystem::path& file);

}  // namespace runner
