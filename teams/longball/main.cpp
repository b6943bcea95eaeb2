#include "teams/kit/run.h"
#include "teams/longball/longball.h"

int main(int argc, char** argv) {
  reference::Parameters parameters;
  longball::Style style;
  kit::Info info{"team-longball", "0.1.0", "Long balls and chips to two high strikers.", {}};
  longball::declare(info.flags, style);
  reference::declare(info.flags, parameters);
  return kit::run(argc, argv, std::move(info), [&](const kit::Setup& setup, bool notes) {
    return longball::make_team(setup, parameters, style, notes);
  });
}
