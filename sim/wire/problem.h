#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "sim/proto/simulation.pb.h"

namespace wire {

/// Why a part of a message cannot be obeyed: a SimulatorError, as one clear sentence.
struct Problem {
  std::string_view code;  ///< one of `code`
  std::string message;    ///< what, where, which value, what to do
};

/// A value, or why there is none.
template <class T>
using Result = std::variant<T, Problem>;

/// The codes of SimulatorError. Stable: clients compare them. Where ER-Force's simulator has a word for the
/// same thing, it is that word.
namespace code {
inline constexpr std::string_view unreadable = "UNREADABLE";        ///< not the message this port expects
inline constexpr std::string_view too_long = "TOO_LONG";            ///< more bytes than a datagram may have
inline constexpr std::string_view robot_id = "ROBOT_ID";            ///< team or number missing or unknown
inline constexpr std::string_view robot_absent = "ROBOT_ABSENT";    ///< not on the field
inline constexpr std::string_view duplicate = "DUPLICATE_ROBOT";    ///< named twice in one message
inline constexpr std::string_view value = "INVALID_VALUE";          ///< missing, not finite or out of range
inline constexpr std::string_view no_place = "CREATE_NOPOS_ROBOT";  ///< a new robot needs x and y
inline constexpr std::string_view speed = "INVALID_SPEED";          ///< simulation_speed
inline constexpr std::string_view port = "INVALID_PORT";            ///< vision_port
inline constexpr std::string_view geometry = "INVALID_GEOMETRY";    ///< field, cameras, ball model
inline constexpr std::string_view spec = "INVALID_SPEC";            ///< robot_specs
inline constexpr std::string_view realism = "INVALID_REALISM";      ///< key, value or preset
inline constexpr std::string_view unsupported = "UNSUPPORTED";      ///< this simulator has no such thing
}  // namespace code

/// As it travels.
inline void encode(const Problem& problem, matchday::simulation::SimulatorError& out) {
  out.set_code(std::string(problem.code));
  out.set_message(problem.message);
}

}  // namespace wire
