#include "experiments/runner/manifest.h"

#include <sys/utsname.h>

#include <fstream>
#include <system_error>

#include "experiments/process/filter.h"
#include "experiments/process/whole_file.h"
#include "experiments/record/json_text.h"
#include "experiments/record/ledger.h"
#include "experiments/runner/worker.h"

namespace runner {
namespace {

/// The commit of the checkout we are started in; "unknown" outside of one or without git.
std::string commit() {
  try {
    const process::Filtered found = process::filter({.arguments = {"git", "rev-parse", "HEAD"}});
    if (found.well) return found.output.substr(0, found.output.find('\n'));
  } catch (const process::StartError&) {  // there is no git
  }
  return "unknown";
}

/// A line of /proc/cpuinfo, "model name" or "flags".
std::string cpu_line(const std::string& key) {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(key, 0) == 0 && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  }
  return "unknown";
}

/// What the C library chooses its sine and exponential by; a game hash is promised within one class.
std::string cpu_class() {
  const std::string flags = " " + cpu_line("flags") + " ";
  std::string found;
  for (const char* flag : {"avx2", "fma", "avx512f"}) {
    if (flags.find(" " + std::string(flag) + " ") != std::string::npos)
      found += (found.empty() ? "" : " ") + std::string(flag);
  }
  return found.empty() ? "none of avx2, fma, avx512f" : found;
}

std::string kernel() {
  utsname name{};
  ::uname(&name);
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

template <class Items, class Write>
std::string list(const Items& items, Write write) {
  std::string text = "[";
  for (const auto& item : items) text += (text.size() > 1 ? ",\n    " : "\n    ") + write(item);
  return text + "\n  ]";
}

}  // namespace

void write_manifest(const std::filesystem::path& file, const Manifest& manifest) {
  std::string text = "{\n";
  const auto field = [&text](const char* key, const std::string& value) {
    text += (text.size() > 2 ? ",\n  \"" : "  \"") + std::string(key) + "\": " + value;
  };
  field("experiment_hash", record::quoted(manifest.experiment_hash));
  field("design", schedule::canonical(manifest.design));
  field("design_file", record::quoted(manifest.design.text));
  field("description", record::quoted(manifest.design.description));
  field("files", list(manifest.files, [](const ProgramFile& one) {
          return "{\"path\": " + record::quoted(one.path.string()) +
                 ", \"xxh3_128\": " + record::quoted(one.hash) + "}";
        }));
  field("matchday", record::quoted(manifest.version));
  field("protocol", record::quoted(manifest.protocol));
  field("ledger_schema", std::to_string(record::Ledger::schema));
  field("command_line",
        list(manifest.command_line, [](const std::string& word) { return record::quoted(word); }));
  field("isolation", record::quoted(manifest.isolation));
  field("date", record::quoted(utc_now()));
  field("commit", record::quoted(commit()));
  field("compiler", record::quoted(__VERSION__));
  field("processor", record::quoted(cpu_line("model name")));
  field("processor_class", record::quoted(cpu_class()));
  field("system", record::quoted(kernel()));

  try {
    process::write_whole(file, text + "\n}\n");
  } catch (const std::system_error& error) {
    throw record::StorageError(error.what());
  }
}

}  // namespace runner
