#include "experiments/judge/net/reported.h"
#include "sim/proto/autoref.pb.h"
#include "sim/wire/delimited.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/target.h"

bool fuzz::reported(std::string_view bytes) {
  wire::FrameReader reader;
  reader.append(std::as_bytes(std::span(bytes)));
  bool understood = false;
  try {
    while (const auto frame = reader.next()) {
      matchday::referee::AutoRefToController message;
      if (!message.ParseFromArray(frame->data(), static_cast<int>(frame->size()))) return understood;
      if (const auto call = judge::call_of(message.game_event(), world::tick_time(600))) {
        understood = true;
        if (call->by && call->by->number > world::max_robot_number) finding("a robot without a pattern");
      }
    }
  } catch (const wire::FrameError& error) {
    check_sentence(error.what());
  }
  return understood;
}
