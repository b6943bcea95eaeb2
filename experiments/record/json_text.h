#pragma once

#include <string>
#include <string_view>

#include "experiments/record/match_config.h"

namespace record {

/// The text as a JSON string with its quotes; bytes that are not UTF-8 become U+FFFD.
std::string quoted(std::string_view text);

/// The shortest decimal that reads back as the same number; null for NaN and infinity.
std::string number(double value);

/// The realism as one line of JSON.
std::string to_json(const RealismConfig& realism);

/// The team as one line of JSON, keys in a fixed order.
std::string to_json(const TeamConfig& team);

}  // namespace record
