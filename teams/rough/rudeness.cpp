#include "teams/rough/rudeness.h"

namespace rough {

void declare(kit::Flags& flags, Rudeness& r) {
  const auto rate = [&flags](const char* name, double& value, const char* help) {
    flags.add(name, value, 0.0, 1.0, std::string("chance per opportunity: ") + help);
  };
  rate("fast-kicks", r.fast_kicks, "a kick at 8 to 10 m/s");
  rate("long-dribbles", r.long_dribbles, "carry the ball 1.6 m");
  rate("area-entries", r.area_entries, "a field robot takes a slow ball in or beside its own defense area");
  rate("area-attacks", r.area_attacks, "take a slow ball in or beside the opponents' defense area");
  rate("ramming", r.ramming, "drive into an opponent that comes near");
  rate("encroachment", r.encroachment, "stand 0.2 m from a ball that is dead or theirs");
  rate("stop-speeding", r.stop_speeding, "drive at full speed during STOP");
  rate("area-waiting", r.area_waiting, "wait at the edge of their area before a kick of ours");
  rate("wrong-half", r.wrong_half, "step over the halfway line before a kickoff");
  rate("double-touches", r.double_touches, "the kicker of a free kick goes on with the ball");
  rate("chips-at-goal", r.chips_at_goal, "a shot from 1 to 4 m is a high chip");
  rate("chips-at-lines", r.chips_at_lines, "a kick near a line is a chip along it");
  rate("keeper-holding", r.keeper_holding, "the goalie keeps the ball for 17 s");
  rate("keeper-neglect", r.keeper_neglect, "the goalie lets the ball be, also in its area");
  rate("slow-restarts", r.slow_restarts, "a free kick of ours is not taken");
  rate("goalie-feeding", r.goalie_feeding, "who gets the ball kicks it slowly to the nearer goalie");
  rate("clearances", r.clearances, "a ball in the own half is kicked over the opponents' goal line");
  rate("shots", r.shots, "who gets the ball within 3 m of their goal shoots at once");
  rate("goalie-visits", r.goalie_visits, "drive up to the opponents' goalie and lean on it");
  rate("run-offs", r.run_offs, "wait outside the field, beyond the run-off");
  rate("idleness", r.idleness, "no field player goes for the ball");
  flags.add("restraint", r.restraint, 0.0, 1.0,
            "chance that a robot that gives way to a habit stops just short of the limit");
}

}  // namespace rough
