#include "autoref/automaton/occurrence.h"

namespace automaton {
namespace {

using enum Severity;

/// One overload per event that is punished; the restart for fouls in play, a card in any location.
struct FoulOf {
  using Result = std::optional<Foul>;

  // Law 12, indirect free kicks.
  Result operator()(const world::BotKickedBallTooFast& e) const { return Foul{e.by, e.location, Minor}; }
  Result operator()(const world::BotDribbledBallTooFar& e) const { return Foul{e.by, e.end, Minor}; }
  Result operator()(const world::AimlessKick& e) const { return Foul{e.by, e.kick, Minor}; }
  Result operator()(const world::ChippedGoal& e) const { return Foul{e.by, e.kick, Minor}; }
  Result operator()(const world::AttackerTouchedKeeper& e) const { return Foul{e.by, e.location, Minor}; }
  Result operator()(const world::AttackerTouchedBallInDefenseArea& e) const {
    return Foul{e.by, e.ball, Minor};
  }
  Result operator()(const world::KeeperHeldBall& e) const { return Foul{e.by, e.location, Minor}; }

  // Law 12, direct free kicks, and the penalty kick for them in the own area. Law 5: advantage.
  Result operator()(const world::BotCrashUnique& e) const {
    if (e.advantage) return std::nullopt;
    return Foul{e.by, e.location, Serious};
  }

  // Law 12: wholly inside a penalty kick; partly caution 8, and indirect since play is stopped for it (I-9).
  Result operator()(const world::DefenderInDefenseArea& e) const {
    if (e.wholly) return Foul{e.by, e.location, Serious};
    return Foul{e.by, e.location, Minor, Card::Yellow};
  }

  // Law 13: the kick is taken again; cautions 3 and 5: who is near then too is shown a card.
  Result operator()(const world::KickTaken& e) const {
    if (!e.again || !e.opponent_near_ball || e.attacker_near_area) return std::nullopt;
    return Foul{*e.opponent_near_ball, e.location, Minor, Card::Yellow};
  }

  // Law 12, caution 9. The ball is out of play: no free kick.
  Result operator()(const world::BotTooFastInStop& e) const {
    return Foul{e.by, e.location, Minor, Card::Yellow};
  }

  template <class NoFoul>
  Result operator()(const NoFoul&) const {
    return std::nullopt;
  }
};

}  // namespace

std::optional<Foul> foul_of(const world::GameEvent& event) { return std::visit(FoulOf{}, event.what); }

Occurrence occurrence_of(const world::GameEvent& event) { return {event, foul_of(event), std::nullopt}; }

}  // namespace automaton
