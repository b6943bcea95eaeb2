#pragma once

#include <optional>

#include "teams/reference/choose_kick.h"
#include "teams/skills/order.h"

namespace reference {

/// The robot at the ball: fetches it, decides what to do with it, does it. Remembers its choice and its
/// dribble.
class Winner {
 public:
  skills::Order play(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                     const KickRules& rules, const Parameters& parameters);

  /// The team-mate a pass is on its way to, as long as it may arrive.
  std::optional<int> receiver(const kit::View& view);

  const std::optional<Kick>& choice() const { return choice_; }
  void forget() { choice_.reset(), pass_.reset(), dribble_start_.reset(), robot_ = -1; }

 private:
  void choose(const kit::View& view, const Situation& situation, const kit::Robot& robot,
              const KickRules& rules, const Parameters& parameters);
  skills::Order with_ball(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                          const Parameters& parameters);

  struct PassUnderWay {
    int receiver = -1;
    double until = 0;  // [s] match time
  };

  int robot_ = -1;
  std::optional<Kick> choice_;
  double chosen_at_ = -1;                  // [s] match time
  std::optional<Vector2d> dribble_start_;  // [m] ball
  double last_contact_ = -1;               // [s]
  double holding_since_ = -1;              // [s]
  std::optional<PassUnderWay> pass_;
};

}  // namespace reference
