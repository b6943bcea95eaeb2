#include "sim/world/rules/paper.h"

#include "sim/world/rules/ssl_2015.h"

namespace world {

RuleSet paper() {
  RuleSet rules = ssl_2015();
  rules.name = "paper";
  // 6.4: its ten events. A late kick and the end of a half are guards in the automaton; "double touch" is
  // Table 11, row 6.
  rules.detectors = {"ball touched",    "double touch", "ball too fast", "dribbled too far", "goal",
                     "ball left field", "no progress",  "kick taken",    "robots settled"};
  rules.chip_model = false;             // 6.6: the ball is projected onto the ground
  rules.retake_keeps_call = false;      // Table 18, third row
  rules.direct_from_goal_line = false;  // Algorithm 2 and Table 11
  rules.exit_frames_mouth = 3;          // Algorithm 2 knows one number of frames
  rules.exit_frames_jump = 3;
  rules.exit_frames_hidden = 0;
  rules.touch = {.accel = true, .line = true, .backtrack = true};  // 6.5.2; nothing of ours

  // Departures from the text, where it cannot run or contradicts itself (reference "requirements", 1.9):
  //   I-1, I-2   READY, not START, follows KICKOFF; the missing edge OFF -> ON exists.
  //   I-5        every stopping row sets call, kick-team and reset position, in metres.
  //   I-6, I-25  the exit knows where it runs, counts observed frames only, and means the whole ball.
  //   I-11       every kickoff is one, not only the first.
  //   I-13, I-19 half-time and time-outs: which row ends which (also I-36, I-37).
  //   I-14, I-41 detectors run once per frame and return occurrences; an occurrence is taken once.
  //   I-15, I-16 the wait for steady robots begins when play stops, and the ball must be in its place.
  //   I-17, I-18 the wait has an end (settle_limit), and a half without a stoppage too (half_overrun).
  //   I-26       a goal that does not count is an exit.
  //   I-29       touches come before exits, goals before exits.
  //   I-30       a ball is too fast in four frames, not one.
  //   I-33, I-34 the kicker's own kick is no double touch; the taker is the nearest robot of the team.
  //   I-38       a kickoff with a robot in the wrong half is a kickoff again.
  //   1.10       the numbers that the paper leaves open are those of ssl-2015.
  return rules;
}

}  // namespace world
