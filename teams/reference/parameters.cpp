#include "teams/reference/parameters.h"

namespace reference {

void declare(kit::Flags& flags, Parameters& p) {
  flags.add("shot-speed", p.shot_speed, 1.0, 7.0, "speed of shots [m/s]");
  flags.add("shot-threshold", p.shot_threshold, 0.0, 1.0, "chance of a goal from which to shoot");
  flags.add("shot-bonus", p.shot_bonus, 0.0, 1.0, "value of a shot beyond its chance, against passes");
  flags.add("attack", p.attack, {"zones", "greedy"}, "how supporters choose their places (feature Z)");
  flags.add("pass-threshold", p.pass_threshold, 0.0, 1.0, "value of a pass from which to play it");
  flags.add("stop-speed", p.stop_speed, 0.1, 1.45, "speed during STOP [m/s]");
  flags.add("stop-distance", p.stop_distance, 0.5, 2.0,
            "distance to the ball during STOP and their kicks [m]");
  flags.add("dribble-distance", p.dribble_distance, 0.1, 0.95, "longest dribble [m]");
  flags.add("turn-dribble", p.turn_dribble,
            "turn with the ball at the dribbler (off: let go and go round it)");
  flags.add("turn-rate", p.turn_rate, 1.0, 9.0, "rate of turns with the ball [rad/s]");
  flags.add("kick-delay", p.kick_delay, 0.0, 5.0, "wait before a free kick [s]");
  flags.add("defenders", p.defenders, 0, 4, "defenders besides the goalkeeper while nobody has the ball");
}

}  // namespace reference
