#include "sim/engine/radio.h"

#include <string>

namespace engine {
namespace {

std::string stream_name(world::RobotId id) {
  return std::string("radio ") + name(id.team) + " " + std::to_string(id.number);
}

}  // namespace

RobotRadio::RobotRadio(world::RobotId id, const RadioParams& params, std::uint64_t match_seed)
    : params_(params), stream_(match_seed, stream_name(id)) {
  stop_.number = id.number;
  last_ = stop_;
  command_ = stop_;
}

void RobotRadio::begin_tick() {
  lost_ = stream_.uniform() < params_.loss;
  ++silent_;
  command_ = stop_;
}

void RobotRadio::send(const world::RobotCommand& command) {
  if (!lost_) {
    last_ = command;
    command_ = command;
    silent_ = 0;
  } else if (silent_ <= params_.timeout) {
    command_ = last_;
    command_.kick_speed = 0;
  }
}

}  // namespace engine
