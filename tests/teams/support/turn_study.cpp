// On which circle the ball stays at the dribbler while a robot turns by 180 degrees: for each rate, radius
// and phi the share of tries in which it did, and how long they took. The table of teams/skills/turn_dribble.
//
// turn_study [tries] [realism]

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "teams/skills/turn_dribble.h"
#include "tests/teams/support/turn_try.h"

int main(int argc, char** argv) {
  const int tries = argc > 1 ? std::atoi(argv[1]) : 10;
  const char* realism = argc > 2 ? argv[2] : "measured";
  for (const double radius : {0.0, 0.03, 0.045, 0.055, 0.07, 0.0945, 0.12}) {
    for (const int phi : {-90, -75, -60, -45, -30, -15, 0, 15, 30, 60, 90}) {
      if (radius == 0 && phi != -90) continue;
      std::printf("radius %.3f phi %3d:", radius, phi);
      for (const double rate : {4.0, 6.0, 8.0, 9.0, 10.0, 11.0, 12.0, 14.0}) {
        int kept = 0;
        double time = 0, moved = 0;
        for (int i = 0; i < tries; ++i) {
          const support::TurnTry result = support::try_turn(
              {rate, radius, phi * M_PI / 180}, i % 2 == 0 ? M_PI : -M_PI + 0.01, 100 + i, realism);
          kept += result.kept;
          time += result.time;
          moved = std::max(moved, result.ball_moved);
        }
        std::printf("  %g: %3d%% %.2fs %.2fm", rate, 100 * kept / tries, time / tries, moved);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
}
