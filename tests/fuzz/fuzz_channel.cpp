#include "experiments/host/messages.h"
#include "sim/wire/delimited.h"
#include "sim/wire/robot_control.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::channel(std::string_view bytes) {
  constexpr std::size_t piece = 1000;  // as bytes arrive, not as frames end
  wire::FrameReader reader;
  host::MessageParser parser;
  int bad_commands = 0;
  bool understood = false;
  try {
    for (std::size_t begin = 0; begin < bytes.size(); begin += piece) {
      reader.append(std::as_bytes(std::span(bytes.substr(begin, piece))));
      while (const auto payload = reader.next()) {
        const wire::proto::TeamMessage* message = parser.parse(*payload);
        if (message == nullptr) return understood;
        understood = true;
        world::TeamCommands commands;
        wire::decode(message->reply().control(), commands, bad_commands);
        if (commands.size() > world::max_robot_number + 1) finding("commands for more robots than there are");
      }
    }
  } catch (const wire::FrameError& error) {
    check_sentence(error.what());
  }
  return understood;
}
