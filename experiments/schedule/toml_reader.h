#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace schedule {

/// A list whose elements are taken one after the other.
struct TomlAxis {
  struct Element {
    std::string label;             ///< "0.3", "on"; of a list its place, from 1
    std::optional<double> number;  ///< of a number the number, of a list how many things it has
  };
  std::string name;  ///< "b.speed_factor"
  std::vector<Element> elements;
};

/// One table of a TOML file, read key by key; every complaint names file, line, key and value.
///
/// A key that nobody asked for is a mistake: finish() says so.
class TomlTable {
 public:
  /// @throws std::invalid_argument naming file and line when the text is not TOML
  static TomlTable parse(const std::string& text, const std::string& file);

  bool has(const std::string& key) const;

  // Each returns nothing when the key is absent and throws std::invalid_argument when it is something else.
  std::optional<std::string> text(const std::string& key);
  std::optional<std::int64_t> integer(const std::string& key);
  std::optional<bool> boolean(const std::string& key);
  std::optional<double> number(const std::string& key);
  std::optional<std::vector<std::string>> texts(const std::string& key);
  std::optional<std::vector<std::int64_t>> integers(const std::string& key);
  std::optional<TomlTable> table(const std::string& key);
  std::optional<std::vector<TomlTable>> tables(const std::string& key);

  /// Gives `take` every number whose key was not asked for yet, here and in tables inside,
  /// together with its name from here ("vision.ball_sigma"), and with table and key for complaints.
  /// Anything else there is rejected.
  void numbers(const std::function<void(const std::string& name, double value, TomlTable& table,
                                        const std::string& key)>& take);

  /// A text, a whole number, a number or a truth value, as it would be typed on a command line.
  std::optional<std::string> word(const std::string& key);

  /// Whether the key holds a text (and not, say, a list).
  bool is_text(const std::string& key) const;
  bool is_integer(const std::string& key) const;

  /// All keys, in the file's order.
  std::vector<std::string> keys() const;

  /// The lists here and in tables inside, in the file's order. Keys `command` and `arguments` hold lists
  /// anyway: they count only when they hold lists of lists.
  ///
  /// @throws std::invalid_argument about an empty list
  std::vector<TomlAxis> axes() const;
  /// This table with element number `elements[i]` in the place of list number i of axes().
  TomlTable point(const std::vector<std::size_t>& elements) const;

  /// "file:line" of a key that is there.
  std::string place(const std::string& key) const;

  /// @throws std::invalid_argument "file:line: key = value: `problem`"
  [[noreturn]] void reject(const std::string& key, const std::string& problem) const;
  /// The same about a key that should be there.
  [[noreturn]] void missing(const std::string& key, const std::string& hint) const;

  /// @throws std::invalid_argument when the table has a key that was never asked for, with the one that was
  ///         perhaps meant and the known ones
  void finish() const;

 private:
  struct Node;
  explicit TomlTable(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::string full_name(const std::string& key) const;

  std::shared_ptr<const Node> node_;
  std::vector<std::string> known_;
};

}  // namespace schedule
