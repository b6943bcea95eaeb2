#include "teams/kit/run.h"
#include "teams/rough/rough_team.h"

int main(int argc, char** argv) {
  reference::Parameters parameters;
  rough::Rudeness rudeness;
  kit::Info info{"team-rough", "0.1.0", "The reference team with bad manners: work for the referee.", {}};
  rough::declare(info.flags, rudeness);
  reference::declare(info.flags, parameters);
  return kit::run(argc, argv, std::move(info), [&](const kit::Setup& setup, bool notes) {
    return rough::make_team(setup, parameters, rudeness, notes);
  });
}
