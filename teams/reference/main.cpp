#include "teams/kit/run.h"
#include "teams/reference/reference_team.h"

int main(int argc, char** argv) {
  reference::Parameters parameters;
  kit::Info info{"team-reference", "0.1.0", "The reference team: a sparring partner for other teams.", {}};
  reference::declare(info.flags, parameters);
  return kit::run(argc, argv, std::move(info), [&parameters](const kit::Setup& setup, bool notes) {
    return std::make_unique<reference::ReferenceTeam>(setup, parameters, notes);
  });
}
