#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// Robots of both teams that meet: collisions (Law 12, decisions 1 and 2), and attackers that touch the
/// goalie in its area.
///
/// Meeting    the hulls, as discs, are not more than 1 mm apart; it ends when they are 20 mm apart.
/// Collision  the speed at which they close in, along the line between them, in the tick before they met.
/// Margins    the speed beyond its limit; of the goalie how deep in its area the point of contact was, and
///            for how long they touched.
/// Near       a pass within two bands: at a speed that would have been a collision, or of the goalie.
class Contacts {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);

 private:
  struct Meeting {
    bool close = false;   // hulls within two bands
    bool met = false;     // hulls touched since
    double speed = 0;     // [m/s] greatest closing speed while close
    double least = 1;     // [m] between the hulls
    TrueEvent nearest{};  // collision
    std::optional<TrueEvent> keeper{};
    bool touched_keeper = false;
    world::Time last{};  // contact
  };
  void meet(const Moment& moment, const truth::Robot& yellow, const truth::Robot& blue, Meeting& meeting,
            std::vector<TrueEvent>& out);
  static void watch_keeper(const Moment& moment, const truth::Robot& yellow, const truth::Robot& blue,
                           double between, Meeting& meeting);
  void part(const Moment& moment, Meeting& meeting, std::vector<TrueEvent>& out);

  static constexpr std::size_t numbers = world::max_robot_number + 1;
  std::array<std::array<Meeting, numbers>, numbers> meetings_;  // yellow, blue
};

}  // namespace judge
