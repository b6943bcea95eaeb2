#include "sim/server/report.h"

#include <fmt/format.h>

namespace server {
namespace {

void append(std::string& text, const std::string& part, const char* separator) {
  if (!text.empty()) text += separator;
  text += part;
}

void add_port(std::string& text, const char* port, const PortCounts& before, const PortCounts& now) {
  std::string refused;
  for (const auto& [code, count] : now.refused) {
    const auto old = before.refused.find(code);
    const std::uint64_t fresh = count - (old == before.refused.end() ? 0 : old->second);
    if (fresh > 0) append(refused, fmt::format("{} {}", fresh, code), ", ");
  }
  if (!refused.empty()) append(text, fmt::format("refused from {}: {}", port, refused), "; ");
}

}  // namespace

std::string news(const Troubles& before, const Troubles& now) {
  std::string text;
  add_port(text, "control", before.control, now.control);
  add_port(text, "blue", before.robots.blue, now.robots.blue);
  add_port(text, "yellow", before.robots.yellow, now.robots.yellow);
  if (now.not_sent > before.not_sent) {
    append(text, fmt::format("{} datagrams could not be sent", now.not_sent - before.not_sent), "; ");
  }
  if (now.skipped > before.skipped) {
    append(text,
           fmt::format("cannot keep up with speed {:g}: {:.3f} s were not played", now.speed,
                       std::chrono::duration<double>(now.skipped - before.skipped).count()),
           "; ");
  }
  return text;
}

}  // namespace server
