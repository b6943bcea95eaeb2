#include "experiments/host/game_hash.h"

#define XXH_INLINE_ALL  // the library as a header; the value is the same as from the shared one
#include <xxhash.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace host {
namespace {

// Everything enters as 64-bit words, so that no padding and no type's size matters.
class Words {
 public:
  void clear() { words_.clear(); }
  void put(std::uint64_t value) { words_.push_back(value); }
  void put(double value) { words_.push_back(std::bit_cast<std::uint64_t>(value)); }
  template <int n>
  void put(const Eigen::Matrix<double, n, 1>& vector) {
    for (int i = 0; i < n; ++i) put(vector[i]);
  }
  const std::vector<std::uint64_t>& words() const { return words_; }

 private:
  std::vector<std::uint64_t> words_;
};

std::uint64_t word(std::int64_t value) { return static_cast<std::uint64_t>(value); }
std::uint64_t word(world::RobotId id) { return (static_cast<std::uint64_t>(id.team) << 8) | id.number; }
std::uint64_t word(const world::Command& command) {
  const std::uint64_t team = world::has_team(command.kind) ? static_cast<std::uint64_t>(command.team) + 1 : 0;
  return (static_cast<std::uint64_t>(command.kind) << 8) | team;
}

}  // namespace

struct GameHash::State {
  XXH3_state_t hash;
  Words words;
};

GameHash::GameHash() : state_(std::make_unique<State>()) {
  XXH3_INITSTATE(&state_->hash);
  XXH3_128bits_reset(&state_->hash);
}
GameHash::~GameHash() = default;

void GameHash::add(const truth::Frame& truth, const world::PerTeam<world::TeamCommands>& commands,
                   const world::RefereeMessage& message, const std::optional<world::Vector2d>& ball_reset) {
  Words& words = state_->words;
  words.clear();
  words.put(word(truth.tick));
  words.put(truth.ball.position);
  words.put(truth.ball.velocity);
  words.put(truth.ball.spin);
  words.put(truth.robots.size());
  for (const truth::Robot& robot : truth.robots) {
    words.put(word(robot.id));
    words.put(robot.position);
    words.put(robot.orientation);
    words.put(robot.velocity);
    words.put(robot.angular_velocity);
  }
  for (const world::Team team : world::both_teams) {
    words.put(commands[team].size());
    for (const world::RobotCommand& command : commands[team]) {
      words.put(word(std::int64_t{command.number}));
      words.put(command.velocity_local);
      words.put(command.angular_velocity);
      words.put(command.kick_speed);
      words.put(command.kick_angle);
      words.put(command.dribbler_speed);
    }
  }
  words.put(word(message.command));
  words.put(word(std::int64_t{message.command_counter}));
  words.put(word(static_cast<std::int64_t>(message.stage)));
  words.put(word(std::int64_t{message.teams.yellow.score}));
  words.put(word(std::int64_t{message.teams.blue.score}));
  words.put(word(std::int64_t{ball_reset.has_value()}));
  if (ball_reset) words.put(*ball_reset);
  XXH3_128bits_update(&state_->hash, words.words().data(), words.words().size() * sizeof(std::uint64_t));
}

std::string GameHash::digits() const {
  const XXH128_hash_t value = XXH3_128bits_digest(&state_->hash);
  constexpr std::string_view alphabet = "0123456789abcdef";
  std::string result;
  for (const std::uint64_t half : {value.high64, value.low64}) {
    for (int shift = 60; shift >= 0; shift -= 4) result += alphabet[(half >> shift) & 15];
  }
  return result;
}

}  // namespace host
