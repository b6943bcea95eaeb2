#pragma once

#include <string>

#include "teams/kit/flags.h"
#include "teams/kit/session.h"

namespace kit {

/// What a team program says of itself.
struct Info {
  std::string name;  ///< of the program and, to the host, of the team
  std::string version = "0.1.0";
  std::string description;  ///< one sentence for --help
  Flags flags;              ///< its own; the common ones are added
};

/// A whole team program: reads the flags, connects to the host, plays until its goodbye.
///
/// @return  the exit code: 0 after a goodbye, 2 for bad usage, 1 when the channel broke; errors are said on
///          standard error in one sentence
int run(int argc, char** argv, Info info, const MakeTeam& make_team);

}  // namespace kit
