#include "teams/chaser/chaser.h"
#include "teams/kit/run.h"

int main(int argc, char** argv) {
  kit::Info info{"team-chaser", "0.1.0", "The smallest team that plays; the example to copy.", {}};
  return kit::run(argc, argv, std::move(info),
                  [](const kit::Setup&, bool) { return std::make_unique<chaser::Chaser>(); });
}
