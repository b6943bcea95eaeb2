#include "experiments/judge/event.h"

#include <algorithm>

namespace judge {
namespace {

struct Names {
  std::string_view name, detector;
};

constexpr std::array<Names, event_count> names = {{
    {"ball left field", "ball left field"},
    {"goal", "goal"},
    {"chip goal", "chip goal"},
    {"icing", "icing"},
    {"ball too fast", "ball too fast"},
    {"dribbled too far", "dribbled too far"},
    {"double touch", "double touch"},
    {"collision", "collision"},
    {"touched the goalie", "touched the goalie"},
    {"defender in own area", "defender in own area"},
    {"attacker in area", "attacker in area"},
    {"goalie holds the ball", "goalie holds the ball"},
    {"no progress", "no progress"},
    {"too many robots", "too many robots"},
    {"robot left field", "robot left field"},
    {"kick taken", "kick taken"},
    {"opponent near the ball at the kick", "kick taken"},
    {"attacker near the area at the kick", "kick taken"},
    {"wrong half at the kickoff", "kick taken"},
    {"robots settled", "robots settled"},
    {"too fast in stop", "too fast in stop"},
    {"too near in stop", "too near in stop"},
    {"interfered placement", "interfered placement"},
}};

}  // namespace

std::string_view name(Event event) { return names[static_cast<std::size_t>(event)].name; }

std::optional<Event> event_named(std::string_view name) {
  const auto it = std::ranges::find(names, name, &Names::name);
  if (it == names.end()) return std::nullopt;
  return static_cast<Event>(it - names.begin());
}

std::string_view detector_of(Event event) { return names[static_cast<std::size_t>(event)].detector; }

Bands bands_of(std::string_view preset) {
  if (preset == "harsh") return {0.06, 0.3, 0.3};
  return {};
}

}  // namespace judge
