#include "experiments/schedule/schedule.h"

#include <cassert>
#include <charconv>
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

std::optional<Game> game_of(const Design& design, const record::GameKey& key) {
  if (key.pair < 0 || key.pair >= design.pairs || key.leg < 0 || key.leg > 1) return std::nullopt;
  for (std::size_t i = 0; i < design.conditions.size(); ++i) {
    if (design.conditions[i].name != key.condition) continue;
    const std::size_t pairs = static_cast<std::size_t>(key.pair) * design.conditions.size() + i;
    return game(design, 2 * pairs + static_cast<std::size_t>(key.leg));
  }
  return std::nullopt;
}

Game find_game(const Design& design, const std::string& id) {
  for (const Condition& condition : design.conditions) {
    const std::string start = condition.name + "-";
    if (!id.starts_with(start) || id.size() < start.size() + 3) continue;
    record::GameKey key{condition.name, 0, id.back() - '0'};
    std::from_chars(id.data() + start.size(), id.data() + id.size(), key.pair);
    const auto found = game_of(design, key);
    if (found && record::game_id(found->key) == id) return *found;
  }
  throw std::invalid_argument("design '" + design.name + "' has no game '" + id +
                              "'; games are named like '" + record::game_id(game(design, 0).key) + "'");
}

}  // namespace schedule
