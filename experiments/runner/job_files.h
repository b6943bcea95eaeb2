#pragma once

#include <filesystem>
#include <functional>

#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"

namespace runner {

// Runner and worker talk through two files in the game's folder, both one line of JSON: the configuration,
// and the record once the game is over. A worker is a program that is started with the two names, plays, and
// ends with code 0; whatever it prints meanwhile is its log and its sign of life.

void write_job(const std::filesystem::path& file, const record::MatchConfig& config);

/// The worker's side: reads the job, plays it, writes the result under its name when it is whole.
///
/// @throws std::invalid_argument or std::runtime_error with one sentence
void serve_job(const std::filesystem::path& job, const std::filesystem::path& result,
               const std::function<record::MatchRecord(const record::MatchConfig&)>& play);

/// @throws std::runtime_error when there is no whole result
record::MatchRecord read_result(const std::filesystem::path& file);

}  // namespace runner
