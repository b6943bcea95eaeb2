#include "experiments/runner/status.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "experiments/record/json_text.h"

namespace runner {
namespace {

/// An object of JSON, written key by key.
class Object {
 public:
  void add(const char* key, const std::string& value) { raw(key, record::quoted(value)); }
  void add(const char* key, double value) { raw(key, record::number(value)); }
  void add(const char* key, std::size_t value) { raw(key, std::to_string(value)); }
  void add(const char* key, std::int64_t value) { raw(key, std::to_string(value)); }
  void add(const char* key, int value) { raw(key, std::to_string(value)); }
  void raw(const char* key, const std::string& value) {
    text_ += (text_.empty() ? "" : ", ") + record::quoted(key) + ": " + value;
  }
  std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

}  // namespace

std::string to_json(const Status& status) {
  Object object;
  object.add("experiment", status.experiment);
  object.add("state", status.state);
  object.add("reason", status.reason);
  object.add("process", status.process);
  object.add("started", status.started);
  object.add("updated", status.updated);
  object.add("seconds", status.seconds);
  object.add("games", status.games);
  object.add("resolved", status.resolved);
  object.add("played", status.played);
  object.add("voids", status.voids);
  object.add("forfeits", status.forfeits);
  object.add("given_up_pairs", status.given_up_pairs);
  object.add("distinct", status.distinct);
  object.add("audited", status.audited);
  object.add("audits_that_differ", status.audits_that_differ);
  object.add("strays", status.strays);
  if (status.left) {
    Object left;
    left.add("seconds", status.left->seconds);
    left.add("low", status.left->low);
    left.add("high", status.left->high);
    object.raw("left", left.text());
  } else {
    object.raw("left", "null");
  }
  object.add("memory", status.memory);
  object.add("open_files", status.open_files);
  object.add("free_disk", status.free_disk);
  object.add("kept_files", status.kept_files);
  std::string running;
  for (const Status::Game& game : status.running) {
    Object one;
    one.add("game", game.game);
    one.add("attempt", game.attempt);
    one.add("kind", game.kind);
    one.add("simulated", game.simulated);
    one.add("seconds", game.seconds);
    running += (running.empty() ? "" : ", ") + one.text();
  }
  object.raw("running", "[" + running + "]");
  return object.text();
}

void write_status(const std::filesystem::path& file, const Status& status) {
  std::filesystem::path unfinished = file;
  unfinished += ".part";
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);  // of a killed run, or a named pipe, which would block us
  std::ofstream stream(unfinished, std::ios::trunc);
  stream << to_json(status) << '\n';
  stream.close();
  if (stream) std::filesystem::rename(unfinished, file, ignored);
}

std::size_t open_files() {
  std::error_code error;
  const std::filesystem::directory_iterator files("/proc/self/fd", error);
  if (error) return 0;
  const auto count = std::distance(begin(files), end(files));
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(count - 1, 0));  // less the folder itself
}

}  // namespace runner
