#include "tests/fuzz/support.h"

#include <google/protobuf/stubs/logging.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace fuzz {
namespace {

constexpr std::size_t longest_sentence = 2000;  // ours: what a terminal still shows at once

/// A folder that goes when the process ends.
struct Folder {
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "fuzz.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) finding("no temporary folder: " + name);
    path = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path path;
};

}  // namespace

void finding(const std::string& sentence) {
  std::fprintf(stderr, "FINDING: %s\n", sentence.c_str());
  std::abort();
}

void check_sentence(const std::string& sentence) {
  if (sentence.empty()) finding("bytes are refused without a word");
  if (sentence.size() > longest_sentence)
    finding("a sentence of " + std::to_string(sentence.size()) + " bytes");
}

void check_sentence(const std::string& sentence, const std::filesystem::path& file) {
  check_sentence(sentence);
  if (sentence.find(file.filename().string()) == std::string::npos) {
    finding("a sentence does not name " + file.filename().string() + ": " + sentence);
  }
}

const std::filesystem::path& scratch() {
  static const Folder folder;
  return folder.path;
}

std::filesystem::path stored(std::string_view bytes, const std::string& name) {
  const std::filesystem::path file = scratch() / name;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) finding("cannot write " + file.string());
  return file;
}

void silence_protobuf() { google::protobuf::SetLogHandler(nullptr); }

}  // namespace fuzz
