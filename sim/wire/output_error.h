#pragma once

#include <stdexcept>

namespace wire {

/// A file that cannot be made or written, as "game.log: cannot be written: No space left on device".
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wire
