#include "autoref/calibrate/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "autoref/calibrate/preset_keys.h"

namespace calibrate {
namespace {

// The preset that stays in force where a log tells nothing.
constexpr std::string_view base = "measured";

// Digits that the error leaves meaningful: two of its own.
std::string with_error(const Finding& finding) {
  const double value = finding.value.value_or(0);
  if (value == 0 || (!finding.key.empty() && preset_key(finding.key).whole))
    return fmt::format("{:.0f}", value);
  if (!(finding.error > 0)) return fmt::format("{:.4g}", value);
  const int digits = std::clamp(1 - static_cast<int>(std::floor(std::log10(finding.error))), 0, 9);
  return fmt::format("{:.{}f}", value, digits);
}

std::string toml_number(const Finding& finding) {
  std::string text = with_error(finding);
  if (!preset_key(finding.key).whole && text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string short_error(double error) { return fmt::format("{:.2g}", error); }

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      result += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

// One line of a comment: a file name may hold anything.
std::string on_one_line(std::string_view text) {
  std::string result(text);
  std::ranges::replace_if(
      result, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  return result;
}

}  // namespace

void Report::add(std::string_view key, std::string quantity, std::string unit, const Estimate& estimate,
                 std::string method) {
  double value = estimate.value;
  if (!key.empty()) {
    const PresetKey& known = preset_key(key);
    if (known.whole) value = std::round(value);
    if (!(value >= known.lowest && value <= known.highest)) {
      return lack(key, std::move(quantity),
                  fmt::format("{:.4g} {} is outside what a preset may hold, {} to {}", value, unit,
                              known.lowest, known.highest));
    }
  }
  findings_.push_back({std::string(key), std::move(quantity), std::move(unit), value, estimate.error,
                       estimate.samples, std::move(method), ""});
}

void Report::lack(std::string_view key, std::string quantity, std::string why) {
  findings_.push_back({std::string(key), std::move(quantity), "", std::nullopt, 0, 0, "", std::move(why)});
}

const Finding* Report::find(std::string_view key) const {
  const auto found = std::ranges::find(findings_, key, &Finding::key);
  return found == findings_.end() ? nullptr : &*found;
}

std::string to_toml(const Report& report, std::string_view title) {
  std::string text = fmt::format("# Calibrated from {}\n", on_one_line(title));
  text += "# Each line: value  # what it is [unit], standard error, samples: method\n";
  text += fmt::format("[realism]\npreset = \"{}\"  # in force for everything that is not set below\n", base);
  std::string section;
  for (const PresetKey& key : preset_keys()) {
    const Finding* finding = report.find(key.name);
    if (finding == nullptr) continue;
    const std::size_t dot = key.name.find('.');
    if (section != key.name.substr(0, dot)) {
      section = key.name.substr(0, dot);
      text += fmt::format("\n[realism.{}]\n", section);
    }
    const std::string_view name = key.name.substr(dot + 1);
    if (!finding->value) {
      text += fmt::format("# {}: left as in \"{}\": {}\n", name, base, on_one_line(finding->missing));
      continue;
    }
    const std::string unit = finding->unit.empty() ? "" : fmt::format(" [{}]", finding->unit);
    text +=
        fmt::format("{} = {}  # {}{}, +- {}, {} samples: {}\n", name, toml_number(*finding),
                    finding->quantity, unit, short_error(finding->error), finding->samples, finding->method);
  }
  text +=
      "\n# No log tells what teams commanded, so radio, actuators, contact, kicker, dribbler and "
      "everything\n";
  text += fmt::format("# else that is not named above stays as in \"{}\".\n", base);
  return text;
}

std::string to_table(const Report& report) {
  std::string text = fmt::format("{:<44} {:>11} {:>9} {:<7} {:>8}  {}\n", "quantity", "value", "std.err.",
                                 "unit", "samples", "method");
  for (const Finding& f : report.findings()) {
    if (f.value) {
      text += fmt::format("{:<44} {:>11} {:>9} {:<7} {:>8}  {}\n", f.quantity, with_error(f),
                          short_error(f.error), f.unit, f.samples, f.method);
    } else {
      text += fmt::format("{:<44} {:>11} {:>9} {:<7} {:>8}  {}\n", f.quantity, "-", "", "", "", f.missing);
    }
  }
  return text;
}

std::string to_json(const Report& report, std::string_view title) {
  const auto number = [](double value) {
    return std::isfinite(value) ? fmt::format("{:.9g}", value) : std::string("null");
  };
  std::string findings;
  for (const Finding& f : report.findings()) {
    findings += fmt::format(
        "{}\n  {{\"key\": {}, \"quantity\": {}, \"unit\": {}, \"value\": {}, \"error\": {}, \"samples\": {}, "
        "\"method\": {}, \"missing\": {}}}",
        findings.empty() ? "" : ",", in_quotes(f.key), in_quotes(f.quantity), in_quotes(f.unit),
        f.value ? number(*f.value) : "null", f.value ? number(f.error) : "null", f.samples,
        in_quotes(f.method), in_quotes(f.missing));
  }
  return fmt::format("{{\"title\": {}, \"preset\": {}, \"findings\": [{}\n]}}\n", in_quotes(title),
                     in_quotes(base), findings);
}

}  // namespace calibrate
