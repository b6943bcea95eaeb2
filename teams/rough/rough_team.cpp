#include "teams/rough/rough_team.h"

#include "teams/rough/habits.h"

namespace rough {

std::unique_ptr<kit::Team> make_team(const kit::Setup& setup, const reference::Parameters& parameters,
                                     const Rudeness& rudeness, bool notes) {
  auto team = std::make_unique<reference::ReferenceTeam>(setup, parameters, notes);
  team->revise_orders([habits = Habits(rudeness, setup.seed)](
                          const kit::View& view, const kit::Robot& robot, const reference::Roles& roles,
                          skills::Order& order) mutable { habits.revise(view, robot, roles, order); });
  return team;
}

}  // namespace rough
