#include "sim/engine/realism.h"
#include "sim/server/server.h"
#include "sim/wire/robot_control.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::robot_control(std::string_view bytes) {
  wire::proto::RobotControl message;
  const bool understood = message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  if (understood) {
    const world::TeamCommands commands = wire::decode(message);
    if (commands.size() > world::max_robot_number + 1) finding("commands for more robots than there are");
    for (const world::RobotCommand& command : commands) {
      if (command.number > world::max_robot_number || !command.velocity_local.allFinite()) {
        finding("a command that no robot can follow");
      }
    }
  }
  // One server for all datagrams, as in the program.
  static server::Server server(server::make_setup({}, engine::realism("none"), 1),
                               {.yellow = {0, 1}, .blue = {0, 1}}, 1, 10020, {});
  const std::string answer = server.handle_robots(world::Team::Yellow, bytes);
  if (answer.size() > wire::max_datagram_size) finding("an answer longer than a datagram");
  server.step();
  return understood;
}
