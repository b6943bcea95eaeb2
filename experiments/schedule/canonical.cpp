#include "experiments/record/json_text.h"
#include "experiments/schedule/design.h"

namespace schedule {
namespace {

/// A team from git is what its commit and its build command make of it, wherever that was.
std::string team_text(record::TeamConfig team, const std::optional<Source>& source) {
  team.directory.clear();
  std::string text = record::to_json(team);
  if (!source) return text;
  text.back() = ',';
  return text + "\"revision\":" + record::quoted(source->commit.empty() ? source->revision : source->commit) +
         ",\"build\":" + record::quoted(source->build) + "}";
}

std::string stopping_text(const Stopping& stopping) {
  std::string text = "{\"minimum_pairs\":" + std::to_string(stopping.minimum_pairs) +
                     ",\"batch_pairs\":" + std::to_string(stopping.batch_pairs);
  if (stopping.rule == StopRule::Precision) {
    return text + ",\"standard_error\":" + record::number(stopping.standard_error) + "}";
  }
  text += std::string(",\"metric\":") +
          (stopping.metric == Metric::Points ? "\"points\"" : "\"goal-difference\"");
  text += ",\"h0\":" + record::number(stopping.h0) + ",\"h1\":" + record::number(stopping.h1);
  text += ",\"alpha\":" + record::number(stopping.alpha) + ",\"beta\":" + record::number(stopping.beta);
  if (stopping.clip) text += ",\"clip\":" + record::number(*stopping.clip);
  return text + "}";
}

}  // namespace

std::string canonical(const Design& design) {
  std::string text = "{\"name\":" + record::quoted(design.name);
  text += ",\"seed\":" + std::to_string(design.seed);
  text += ",\"pairs\":" + std::to_string(design.pairs);
  text += ",\"rules\":" + record::quoted(design.rules);
  text += ",\"half_length\":" + (design.half_length ? record::number(*design.half_length) : "null");
  if (design.winner) text += ",\"winner\":true";
  text += ",\"realism\":" + record::to_json(design.realism);
  text += ",\"forfeit_goals\":" + std::to_string(design.forfeit_goals);
  if (design.stopping.rule != StopRule::Fixed) text += ",\"stopping\":" + stopping_text(design.stopping);
  // The limits that decide games: a team above them is at fault.
  if (design.limits.team_memory != Limits{}.team_memory) {
    text += ",\"team_memory\":" + std::to_string(design.limits.team_memory);
  }
  const TeamTime& time = design.limits.team_time;
  if (time != usual_team_time(design.limits.silence, design.limits.game)) {
    text += ",\"team_time\":[" + record::number(time.reply) + "," + record::number(time.second) + "," +
            record::number(time.game) + "]";
  }
  text += ",\"conditions\":[";
  for (const Condition& condition : design.conditions) {
    if (&condition != &design.conditions.front()) text += ",";
    text += "{\"name\":" + record::quoted(condition.name) +
            ",\"a\":" + team_text(condition.a, condition.a_source) +
            ",\"b\":" + team_text(condition.b, condition.b_source);
    if (condition.realism != design.realism) text += ",\"realism\":" + record::to_json(condition.realism);
    if (!condition.sweep.empty()) text += ",\"sweep\":" + record::quoted(condition.sweep);
    if (condition.panel) text += ",\"panel\":" + record::quoted(condition.panel->base);
    text += "}";
  }
  return text + "]}";
}

}  // namespace schedule
