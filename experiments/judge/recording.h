#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "sim/truth/truth.h"
#include "sim/world/detection.h"
#include "sim/world/game_state.h"

namespace judge {

/// One tick of a judged game: all that a referee is shown, and what really happened.
struct RecordedTick {
  truth::Frame truth;
  std::vector<world::Detection> images;  ///< delivered in this tick; without pixels, areas and confidences
  world::GameState state;                ///< of the acting referee after the tick; without its running clocks
};

/// Writes a judged game so that it can be judged again without playing it: about 80 MB for a full game.
///
/// Plain bytes in the order of this machine, numbers as they are in memory; what passed through the wire's
/// floats is kept as these. After the beginning, every tick and the end stands a check of all before it (XXH3
/// of the part, seeded with the check before). The file gets its name when it is whole.
class RecordingWriter {
 public:
  /// @throws std::runtime_error naming the file
  RecordingWriter(std::filesystem::path file, const std::string& job);
  void add(const truth::Frame& truth, std::span<const world::Detection> images,
           const world::GameState& state);
  /// @throws std::runtime_error naming the file
  void close(std::int64_t ticks, const std::string& hash);

 private:
  std::filesystem::path file_;
  std::vector<char> buffer_;
  std::ofstream stream_;
  std::string bytes_;  // of a tick
  std::string state_;  // the last one, as text
  std::uint64_t check_ = 0;

  void write_checked();
};

/// Reads it back, tick by tick. Every number is checked: a reader of a tick may use them as they are. Files
/// of the first version have no checks and are read without.
class RecordingReader {
 public:
  /// @throws std::invalid_argument naming the file, when it is none
  explicit RecordingReader(std::filesystem::path file);
  const std::string& job() const { return job_; }
  /// The next tick; null after the last one. Valid until the next call.
  /// @throws std::invalid_argument naming the file and the place, when it is damaged
  const RecordedTick* next();
  /// After the last tick.
  std::int64_t ticks() const { return ticks_; }
  const std::string& hash() const { return hash_; }

 private:
  bool read(char* bytes, std::size_t size);
  void take_check();
  template <class Value>
  Value take();
  std::string take_text();
  double take_number(double largest);
  template <class Vector>
  void take_all(Vector& vector, double largest);
  world::Vector2d take_on_wire();
  std::size_t take_count(std::size_t most);
  world::Time take_time();
  world::Team take_team();
  world::RobotId take_robot();
  void take_truth(truth::Frame& truth);
  void take_image(world::Detection& image);
  [[noreturn]] void damaged(const std::string& what);

  std::filesystem::path file_;
  std::vector<char> buffer_;
  std::ifstream stream_;
  std::string job_, hash_;
  std::int64_t ticks_ = 0;
  RecordedTick tick_;
  bool begun_ = false;    // a tick was read
  bool checked_ = false;  // the file has checks
  std::string part_;      // what was read since the last check
  std::uint64_t check_ = 0;
};

}  // namespace judge
