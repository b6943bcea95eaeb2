#include <cmath>

#include "sim/engine/realism.h"
#include "sim/server/server.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::simulator(std::string_view bytes) {
  const auto server_now = [] {
    return server::Server(server::make_setup({}, engine::realism("none"), 1),
                          {.yellow = {0, 1}, .blue = {0, 1}}, 1, 10020, {});
  };
  // One server for many datagrams, as in the program, and a new one now and then so that a finding repeats.
  static server::Server server = server_now();
  static int datagrams = 0;
  if (++datagrams % 64 == 0) server = server_now();

  const std::string answer = server.handle_control(bytes);
  if (answer.size() > wire::max_datagram_size) finding("an answer longer than a datagram");
  for (const server::VisionPacket& packet : server.step()) {
    if (packet.bytes.size() > wire::max_datagram_size) finding("an image longer than a datagram");
  }
  const truth::Frame& truth = server.simulation().truth();
  if (!truth.ball.position.allFinite() || !truth.ball.velocity.allFinite()) finding("the ball is nowhere");
  for (const truth::Robot& robot : truth.robots) {
    if (!robot.position.allFinite() || !robot.velocity.allFinite() || !std::isfinite(robot.orientation)) {
      finding("a robot is nowhere");
    }
  }
  matchday::simulation::SimulatorResponse response;
  if (!response.ParseFromString(answer)) finding("an answer that cannot be read");
  return response.errors().empty();
}
