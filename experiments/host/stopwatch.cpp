#include "experiments/host/stopwatch.h"

namespace host {

const char* name(Part part) {
  switch (part) {
    case Part::Physics:
      return "physics";
    case Part::Vision:
      return "vision";
    case Part::Bookkeeping:
      return "bookkeeping";
    case Part::Referee:
      return "referee";
    case Part::Log:
      return "log";
    case Part::Messages:
      return "messages";
    case Part::Channel:
      return "channel";
  }
  return "";
}

std::vector<double> Stopwatch::times(Part part) const {
  std::vector<double> result;
  result.reserve(ticks_.size());
  for (const auto& tick : ticks_) result.push_back(static_cast<double>(tick[static_cast<std::size_t>(part)]));
  return result;
}

double Stopwatch::mean(Part part) const {
  double sum = 0;
  for (const auto& tick : ticks_) sum += static_cast<double>(tick[static_cast<std::size_t>(part)]);
  return ticks_.empty() ? 0 : sum / static_cast<double>(ticks_.size());
}

}  // namespace host
