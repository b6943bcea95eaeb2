#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

// Reading JSON from outside, for the sources of this folder only: nlohmann's header is slow to compile.
namespace record {

using Json = nlohmann::ordered_json;

// The log of a program may hold any bytes; a record must still be written.
inline std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// A value for a message: short, and never deep.
inline std::string shown(const Json& json) {
  constexpr std::size_t longest = 60;
  if (json.is_array()) return "a list of " + std::to_string(json.size());
  if (json.is_object()) return "an object of " + std::to_string(json.size());
  std::string text = dumped(json);
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  return text;
}

// Ours: a full game's record has 36 kB and is 5 deep.
inline constexpr std::size_t longest_json = std::size_t{64} << 20;  // [bytes]
inline constexpr int deepest_json = 32;

/// @param skipped  a key at the top whose value is left out; null: none
/// @throws std::invalid_argument
inline Json parsed(const std::string& text, const char* what, const char* skipped = nullptr) {
  if (text.size() > longest_json) {
    throw std::invalid_argument(std::string(what) + ": " + std::to_string(text.size()) + " bytes, at most " +
                                std::to_string(longest_json) + " are read");
  }
  bool skip = false;
  const auto look = [&](int depth, Json::parse_event_t event, Json& value) {
    if (depth > deepest_json) {
      throw std::invalid_argument(std::string(what) + ": nested deeper than " + std::to_string(deepest_json));
    }
    if (depth == 1 && event == Json::parse_event_t::key) {
      skip = skipped != nullptr && value == skipped;
      return true;
    }
    return !skip || depth == 0;
  };
  try {
    Json json = Json::parse(text, look);
    if (!json.is_object()) throw std::invalid_argument(std::string(what) + ": not a JSON object");
    return json;
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string(what) + ": not JSON: " + error.what());
  }
}

/// Reads fields and says which one was wrong.
class Fields {
 public:
  Fields(const Json& json, std::string what) : json_(json), what_(std::move(what)) {
    if (!json_.is_object()) throw std::invalid_argument(what_ + ": not a JSON object");
  }
  const Json& at(const char* key) const {
    const auto found = json_.find(key);
    if (found == json_.end()) throw std::invalid_argument(what_ + ": field '" + key + "' is missing");
    return *found;
  }
  bool has(const char* key) const {
    const auto found = json_.find(key);
    return found != json_.end() && !found->is_null();
  }
  template <class T>
  void read(const char* key, T& value) const {
    const Json& field = at(key);
    try {
      field.get_to(value);
    } catch (const Json::exception&) {
      throw std::invalid_argument(what_ + ": field '" + key + "' has the wrong type: " + shown(field));
    }
  }
  std::string text(const char* key) const {
    std::string value;
    read(key, value);
    return value;
  }
  std::int64_t integer(const char* key, std::int64_t least, std::int64_t most) const {
    const Json& field = at(key);
    const bool fits = field.is_number_unsigned()
                          ? field.get<std::uint64_t>() <=
                                static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())
                          : field.is_number_integer();
    if (!fits || field.get<std::int64_t>() < least || field.get<std::int64_t>() > most) {
      wrong(key, "a whole number from " + std::to_string(least) + " to " + std::to_string(most), field);
    }
    return field.get<std::int64_t>();
  }
  int count(const char* key, int most) const { return static_cast<int>(integer(key, 0, most)); }
  std::uint64_t seed(const char* key) const {
    const Json& field = at(key);
    const bool negative =
        field.is_number_integer() && !field.is_number_unsigned() && field.get<std::int64_t>() < 0;
    if (!field.is_number_integer() || negative) wrong(key, "a whole number from 0 to 2^64 - 1", field);
    return field.get<std::uint64_t>();
  }
  double real(const char* key, double least, double most) const {
    const Json& field = at(key);
    if (!field.is_number() || !(field.get<double>() >= least && field.get<double>() <= most)) {
      wrong(key, "a number from " + dumped(Json(least)) + " to " + dumped(Json(most)), field);
    }
    return field.get<double>();
  }
  /// Calls `visit` with every key.
  template <class Visit>
  void each(Visit visit) const {
    for (const auto& item : json_.items()) visit(item.key());
  }
  std::string name_of(const char* key) const { return what_ + ": field '" + key + "'"; }

 private:
  [[noreturn]] void wrong(const char* key, const std::string& right, const Json& value) const {
    throw std::invalid_argument(name_of(key) + " must be " + right + ", not " + shown(value));
  }

  const Json& json_;
  std::string what_;
};

}  // namespace record
