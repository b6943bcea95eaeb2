#include "experiments/record/match_record.h"

#include <array>
#include <stdexcept>
#include <utility>

namespace record {
namespace {

constexpr std::array<const char*, 13> termination_names = {
    "finished", "not-started", "not-connected", "crashed",    "closed",      "not-responding", "nonsense",
    "overlong", "interrupted", "harness-fault", "over-limit", "implausible", "stood-still"};
constexpr std::array<const char*, 5> party_names = {"nobody", "yellow", "blue", "both", "harness"};
constexpr std::array<const char*, 4> outcome_names = {"yellow-wins", "blue-wins", "draw", "void"};

template <class Enum, std::size_t count>
Enum from_name(const std::array<const char*, count>& names, std::string_view word, const char* what) {
  std::string known;
  for (std::size_t i = 0; i < count; ++i) {
    if (word == names[i]) return static_cast<Enum>(i);
    known += (known.empty() ? "" : ", ") + std::string(names[i]);
  }
  throw std::invalid_argument("unknown " + std::string(what) + " '" + std::string(word) +
                              "'; known are: " + known);
}

}  // namespace

const char* name(Termination termination) {
  return termination_names.at(static_cast<std::size_t>(termination));
}
const char* name(Party party) { return party_names.at(static_cast<std::size_t>(party)); }
const char* name(Outcome outcome) { return outcome_names.at(static_cast<std::size_t>(outcome)); }

Termination termination_from_name(std::string_view word) {
  return from_name<Termination>(termination_names, word, "termination");
}
Party party_from_name(std::string_view word) { return from_name<Party>(party_names, word, "party"); }
Outcome outcome_from_name(std::string_view word) {
  return from_name<Outcome>(outcome_names, word, "outcome");
}

Outcome outcome(const MatchRecord& record) {
  if (record.at_fault == Party::Yellow) return Outcome::BlueWins;
  if (record.at_fault == Party::Blue) return Outcome::YellowWins;
  if (record.at_fault != Party::Nobody || record.termination != Termination::Finished) return Outcome::Void;
  if (record.goals.yellow == record.goals.blue) return Outcome::Draw;
  return record.goals.yellow > record.goals.blue ? Outcome::YellowWins : Outcome::BlueWins;
}

world::PerTeam<int> counted_goals(const MatchRecord& record, int forfeit_goals) {
  if (record.at_fault == Party::Yellow) return {.yellow = 0, .blue = forfeit_goals};
  if (record.at_fault == Party::Blue) return {.yellow = forfeit_goals, .blue = 0};
  return record.goals;
}

}  // namespace record
