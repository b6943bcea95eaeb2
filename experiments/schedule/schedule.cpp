#include "experiments/schedule/schedule.h"

#include <cassert>
#include <stdexcept>

#include "sim/world/random.h"

namespace schedule {

std::size_t game_count(const Design& design) {
  return design.conditions.size() * static_cast<std::size_t>(design.pairs) * 2;
}

Game game(const Design& design, std::size_t index) {
  assert(index < game_count(design));
  const std::size_t conditions = design.conditions.size();
  const int leg = static_cast<int>(index % 2);
  const Condition& condition = design.conditions[index / 2 % conditions];
  const int pair = static_cast<int>(index / 2 / conditions);

  Game game;
  game.key = {condition.name, pair, leg};
  game.a_colour = leg == 0 ? world::Team::Blue : world::Team::Yellow;
  game.config.teams[game.a_colour] = condition.a;
  game.config.teams[world::opponent(game.a_colour)] = condition.b;
  game.config.seed =
      world::derived_seed(design.seed, "pair " + std::to_string(pair) + " leg " + std::to_string(leg));
  game.config.rules = design.rules;
  game.config.realism = condition.realism;
  game.config.half_length = design.half_length;
  game.config.winner = design.winner;
  game.config.blue_on_positive_half = (pair & 1) == 0;
  game.config.first_kickoff = (pair & 2) == 0 ? world::Team::Yellow : world::Team::Blue;
  return game;
}

Game find_game(const Design& design, const std::string& id) {
  for (std::size_t index = 0; index < game_count(design); ++index) {
    Game candidate = game(design, index);
    if (record::game_id(candidate.key) == id) return candidate;
  }
  throw std::invalid_argument("design '" + design.name + "' has no game '" + id +
                              "'; games are named like '" + record::game_id(game(design, 0).key) + "'");
}

}  // namespace schedule
