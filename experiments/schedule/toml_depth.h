#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace schedule {

/// Tables and lists inside each other. Ours: designs need five.
inline constexpr std::size_t deepest = 32;

/// The line [from 1] of a TOML text in which brackets or the parts of a dotted key go deeper than `deepest`;
/// nothing when none does. The parser has a limit for brackets, but a key of 40,000 parts makes as many
/// tables inside each other, whose destructors call each other.
std::optional<std::size_t> too_deep(std::string_view toml);

}  // namespace schedule
