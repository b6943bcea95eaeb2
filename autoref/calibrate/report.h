#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "autoref/calibrate/statistics.h"

namespace calibrate {

/// One quantity of a log: a value, or the reason why there is none.
struct Finding {
  std::string key;       ///< of a preset, "vision.ball_sigma"; empty: told, but not part of a preset
  std::string quantity;  ///< "ball noise, per axis"
  std::string unit;
  std::optional<double> value;
  double error = 0;         ///< standard error, as `unit`
  std::size_t samples = 0;  ///< independent or not; the method says of what
  std::string method;       ///< how it was found
  std::string missing;      ///< why there is no value
};

/// All quantities of a log.
class Report {
 public:
  /// A value; one outside the key's range becomes a missing one, one of a whole key is rounded.
  void add(std::string_view key, std::string quantity, std::string unit, const Estimate& estimate,
           std::string method);
  void lack(std::string_view key, std::string quantity, std::string why);
  /// A quantity that no preset has.
  void tell(std::string quantity, std::string unit, const Estimate& estimate, std::string method) {
    add("", std::move(quantity), std::move(unit), estimate, std::move(method));
  }

  const std::vector<Finding>& findings() const { return findings_; }
  /// The finding of that key; null when there is none.
  const Finding* find(std::string_view key) const;

 private:
  std::vector<Finding> findings_;
};

/// A realism preset in TOML: what was found with error, samples and method; what was not, with the reason.
///
/// @param title  what was calibrated from, one line
std::string to_toml(const Report& report, std::string_view title);
/// The same for a reader: quantity, value, standard error, samples, method.
std::string to_table(const Report& report);
/// {"findings": [...]}: every field of every finding; null for no value.
std::string to_json(const Report& report, std::string_view title);

}  // namespace calibrate
