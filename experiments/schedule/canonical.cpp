#include "experiments/record/json_text.h"
#include "experiments/schedule/design.h"

namespace schedule {

std::string canonical(const Design& design) {
  std::string text = "{\"name\":" + record::quoted(design.name);
  text += ",\"seed\":" + std::to_string(design.seed);
  text += ",\"pairs\":" + std::to_string(design.pairs);
  text += ",\"rules\":" + record::quoted(design.rules);
  text += ",\"half_length\":" + (design.half_length ? record::number(*design.half_length) : "null");
  if (design.winner) text += ",\"winner\":true";
  text += ",\"realism\":" + record::to_json(design.realism);
  text += ",\"forfeit_goals\":" + std::to_string(design.forfeit_goals);
  text += ",\"conditions\":[";
  for (const Condition& condition : design.conditions) {
    if (&condition != &design.conditions.front()) text += ",";
    text += "{\"name\":" + record::quoted(condition.name) + ",\"a\":" + record::to_json(condition.a) +
            ",\"b\":" + record::to_json(condition.b);
    if (condition.realism != design.realism) text += ",\"realism\":" + record::to_json(condition.realism);
    text += "}";
  }
  return text + "]}";
}

}  // namespace schedule
