#include <stdexcept>
#include <utility>

#include "experiments/host/match.h"
#include "sim/engine/realism.h"
#include "sim/world/rules/rule_set.h"

// What a configuration means.
namespace host {

world::RuleSet rules_of(const record::MatchConfig& config) {
  world::RuleSet rules = world::rule_set(config.rules);
  if (config.half_length) {
    if (!(*config.half_length > 0 && *config.half_length <= 1200)) {  // also not a number
      throw std::invalid_argument("half_length " + std::to_string(*config.half_length) +
                                  ": more than 0 and at most 1200 seconds are possible");
    }
    rules.extra_half_length = world::from_seconds(
        *config.half_length * world::seconds(rules.extra_half_length) / world::seconds(rules.half_length));
    rules.half_length = world::from_seconds(*config.half_length);
  }
  rules.winner = config.winner;
  return rules;
}

engine::Realism realism_of(const record::RealismConfig& config) {
  engine::Realism realism = engine::realism(config.preset);
  for (const auto& [key, value] : config.changes) engine::set(realism, key, value);
  return realism;
}

engine::Model model_of(const record::MatchConfig& config) {
  const world::RuleSet rules = rules_of(config);
  engine::Model model;
  model.geometry.field = rules.field;
  model.blue_on_positive_half = config.blue_on_positive_half;
  model.realism = realism_of(config.realism);
  const vision::Params& vision = model.realism.vision;
  model.geometry.cameras = world::camera_grid(rules.field, vision.cameras, vision.camera_height);
  model.geometry.ball_slide_deceleration = model.realism.physics.ball.slide_deceleration;
  model.geometry.ball_roll_deceleration = model.realism.physics.ball.roll_deceleration;
  model.seed = config.seed;
  for (const world::Team team : world::both_teams) {
    const record::TeamConfig& its = config.teams[team];
    const std::string who = std::string(world::name(team)) + " (" + its.name + "): ";
    if (its.command.empty() || its.command.front().empty())
      throw std::invalid_argument(who + "command is empty");
    if (its.robots.empty() || static_cast<int>(its.robots.size()) > rules.robots_per_team) {
      throw std::invalid_argument(who + "robots lists " + std::to_string(its.robots.size()) +
                                  " robots, 1 to " + std::to_string(rules.robots_per_team) + " are possible");
    }
    try {
      model.robots[team] = engine::standard_robots(team, its.robots, its.speed_factor, model.realism.robots);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(who + error.what());
    }
  }
  engine::check(model);
  return model;
}

}  // namespace host
