#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "experiments/judge/game.h"

namespace judge {

/// A game's result as JSON: one line for the game, then one for each case.
std::string to_json(const GameResult& result);
/// @throws std::invalid_argument saying what is wrong, beginning with `name`
GameResult game_from_json(const std::string& text, const std::string& name);

/// Writes it at once and whole, or not at all.
/// @throws std::runtime_error naming the file
void write_game(const std::filesystem::path& file, const GameResult& result);
/// Nothing when there is no such file.
/// @throws std::invalid_argument naming the file when it is damaged
std::optional<GameResult> read_game(const std::filesystem::path& file);

std::string to_json(const Job& job);
/// @throws std::invalid_argument saying what is wrong
Job job_from_json(const std::string& text);

}  // namespace judge
