#pragma once

#include <array>
#include <optional>

#include "teams/reference/choose_kick.h"
#include "teams/skills/order.h"

namespace reference {

/// The robot at the ball: fetches it, decides what to do with it, does it.
/// Remembers its choice and its dribble.
class Winner {
 public:
  skills::Order play(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                     const KickRules& rules, const Parameters& parameters);

  /// The team-mate a pass is on its way to, as long as it may arrive.
  std::optional<int> receiver(const kit::View& view);

  /// What it is about to do: the one touch under way, else the choice.
  const std::optional<Kick>& choice() const { return redirect_ ? redirect_ : choice_; }
  void forget() { choice_.reset(), pass_.reset(), holds_.fill({}), redirect_.reset(), robot_ = -1; }

 private:
  void choose(const kit::View& view, const Situation& situation, const kit::Robot& robot,
              const KickRules& rules, const Parameters& parameters);
  void watch_the_holds(const kit::View& view);
  skills::Order free_kick(const kit::View& view, const kit::Robot& robot) const;
  skills::Order with_ball(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                          const Parameters& parameters);
  skills::Order fetch(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                      const KickRules& rules, const Parameters& parameters);
  skills::Order let_come(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                         const KickRules& rules, const Parameters& parameters);

  std::optional<Kick> pass_on(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                              const skills::Meeting& meeting, const Parameters& parameters) const;

  struct PassUnderWay {
    int receiver = -1;
    Vector2d direction = Vector2d::UnitX();
    double armed_at = 0;
    double until = 0;  // [s] match time
    bool kicked = false;
  };

  int robot_ = -1;
  std::optional<Kick> choice_;
  double chosen_at_ = -1;  // [s] match time
  // What the laws may call one dribble. Where it began others may see otherwise, so all of its way is kept.
  struct HoldWatch {
    bool now = false;
    std::array<Vector2d, 12> way{};  // [m] the ball's places, a tenth of a metre apart
    std::size_t places = 0;          // of them known; 0: out of touch
    int ticks_apart = 0;             // in a row
    double last_contact = -1;        // [s] match time, as all below
    double since = -1;

    Vector2d farthest_from(const Vector2d& ball) const;  // of the way; the ball itself when out of touch
    void go_on(const Vector2d& ball);
  };
  std::array<HoldWatch, world::max_robot_number + 1> holds_{};
  double released_at_ = -9;
  std::optional<Kick> redirect_;  // the one touch under way
  double redirect_chosen_at_ = -1;
  std::optional<PassUnderWay> pass_;
};

/// The shot with one touch at that meeting, when the opening promises a goal and the ball is not to be turned
/// too far; nothing: stop it.
///
/// @param before  the one chosen before: kept with a little less
std::optional<Kick> choose_one_touch(const kit::View& view, const kit::Robot& robot,
                                     const skills::Meeting& meeting, const Parameters& parameters,
                                     const std::optional<Kick>& before);

}  // namespace reference
