#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fuzz {

/// A finding that no sanitizer sees: prints the sentence and aborts.
[[noreturn]] void finding(const std::string& sentence);

/// What a reader says of a file that it refuses: one short sentence that names the file.
void check_sentence(const std::string& sentence, const std::filesystem::path& file);
/// The same where there is no file to be named.
void check_sentence(const std::string& sentence);

/// Puts the bytes into a file of that name, in a folder of this process that is removed when it ends.
std::filesystem::path stored(std::string_view bytes, const std::string& name);
/// The folder.
const std::filesystem::path& scratch();

/// Protobuf prints a line for each message it cannot read: not here.
void silence_protobuf();

}  // namespace fuzz
