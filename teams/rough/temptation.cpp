#include "teams/rough/temptation.h"

namespace rough {

bool Temptation::gives_way(int robot, bool opportunity, double rate, world::RandomStream& stream,
                           double restraint) {
  State& state = states_[static_cast<std::size_t>(robot)];
  if (!opportunity) {
    state = {};
  } else if (!state.open) {
    state.open = true;
    state.gave_way = stream.uniform() < rate;
    state.holds_back = state.gave_way && restraint > 0 && stream.uniform() < restraint;
  }
  return state.gave_way;
}

}  // namespace rough
