#include "sim/console/printable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace console {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

struct Character {
  char32_t code = 0;
  std::size_t bytes = 1;
  bool valid = false;
};

/// How many bytes a character has that begins with this one; 0: none does.
std::size_t bytes_of(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  if (first >= 0xF0 && first <= 0xF4) return 4;
  return 0;
}

/// The first character of a text that is not empty (Unicode 15, table 3-7).
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t bytes = bytes_of(byte(0));
  if (bytes == 0 || bytes > text.size()) return {};
  if (bytes == 1) return {byte(0), 1, true};
  auto code = static_cast<char32_t>(byte(0) & (0xFFU >> (bytes + 1)));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = (code << 6) | (byte(i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least.at(bytes) || code > 0x10FFFF || surrogate) return {};
  return {code, bytes, true};
}

struct Span {
  char32_t first;
  char32_t last;
};

/// What acts instead of being seen: Unicode's general categories Cc, Cf, Zl and Zp (Unicode 15.1), and what
/// is no character. Their blocks are taken whole where the rest of a block is not assigned.
constexpr std::array<Span, 23> acting{{{0x00, 0x1F},          // control
                                       {0x7F, 0x9F},          // control
                                       {0xAD, 0xAD},          // soft hyphen
                                       {0x600, 0x605},        // Arabic signs around numbers
                                       {0x61C, 0x61C},        // Arabic letter mark
                                       {0x6DD, 0x6DD},        // Arabic end of ayah
                                       {0x70F, 0x70F},        // Syriac abbreviation
                                       {0x890, 0x891},        // Arabic signs of money
                                       {0x8E2, 0x8E2},        // Arabic disputed end of ayah
                                       {0x180E, 0x180E},      // Mongolian vowel separator
                                       {0x200B, 0x200F},      // no width; left-to-right, right-to-left marks
                                       {0x2028, 0x202E},      // line, paragraph; embeddings and overrides
                                       {0x2060, 0x206F},      // no width; isolates
                                       {0xFDD0, 0xFDEF},      // no characters
                                       {0xFEFF, 0xFEFF},      // byte order mark
                                       {0xFFF9, 0xFFFB},      // annotations
                                       {0xFFFE, 0xFFFF},      // no characters
                                       {0x110BD, 0x110BD},    // Kaithi number signs
                                       {0x110CD, 0x110CD},    // the same above
                                       {0x13430, 0x1343F},    // of hieroglyphs
                                       {0x1BCA0, 0x1BCA3},    // of shorthand
                                       {0x1D173, 0x1D17A},    // of musical notation
                                       {0xE0000, 0xE0FFF}}};  // tags

/// What does not act, and is not seen either: Default_Ignorable_Code_Point (Unicode 15.1) without what is in
/// the list above and selectors of a variant, a blank pattern of Braille, and what is for private use.
constexpr std::array<Span, 9> unseen{{{0x34F, 0x34F},         // joins marks
                                      {0x115F, 0x1160},       // Hangul fillers
                                      {0x17B4, 0x17B5},       // Khmer vowels
                                      {0x180B, 0x180F},       // Mongolian selectors
                                      {0x2800, 0x2800},       // Braille
                                      {0x3164, 0x3164},       // Hangul filler
                                      {0xE000, 0xF8FF},       // private use
                                      {0xFFA0, 0xFFA0},       // Hangul filler of half width
                                      {0xF0000, 0x10FFFF}}};  // private use

template <std::size_t Count>
bool is_in(const std::array<Span, Count>& spans, char32_t code) {
  return std::any_of(spans.begin(), spans.end(),
                     [code](const Span& span) { return code >= span.first && code <= span.last; });
}
bool acts(char32_t code) { return is_in(acting, code); }

std::string escape(char32_t code) {
  std::array<char, 16> text{};
  if (code < 0x10000) {
    std::snprintf(text.data(), text.size(), "\\u%04x", static_cast<unsigned>(code));
  } else {
    const auto above = static_cast<unsigned>(code) - 0x10000U;
    std::snprintf(text.data(), text.size(), "\\u%04x\\u%04x", 0xD800U + (above >> 10),
                  0xDC00U + (above & 0x3FFU));
  }
  return text.data();
}

enum class Kind { Line, Lines, Json };

std::string made_printable(std::string_view text, Kind kind) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_of(text);
    const char32_t code = character.code;
    const bool blank = code == '\n' || code == '\t' || code == '\r';
    if (!character.valid) {
      result += replacement;
    } else if (!acts(code)) {
      result += text.substr(0, character.bytes);
    } else if (kind == Kind::Json) {
      result +=
          blank ? std::string(text.substr(0, 1)) : escape(code);  // a raw one stands between values only
    } else if (kind == Kind::Lines && code == '\n') {
      result += '\n';
    } else {
      result += blank ? std::string_view(" ") : replacement;
    }
    text.remove_prefix(character.bytes);
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text) { return made_printable(text, Kind::Line); }
std::string printable_lines(std::string_view text) { return made_printable(text, Kind::Lines); }
std::string printable_json(std::string_view text) { return made_printable(text, Kind::Json); }

bool is_visible(std::string_view text) {
  while (!text.empty()) {
    const Character character = first_of(text);
    if (!character.valid || acts(character.code) || is_in(unseen, character.code)) return false;
    text.remove_prefix(character.bytes);
  }
  return true;
}

std::size_t length(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

std::string shortened(const std::string& text, std::size_t most) {
  if (length(text) <= most) return text;
  std::size_t end = 0;
  for (std::size_t count = 0; count < most - 3 && end < text.size(); ++count)
    end += std::max<std::size_t>(1, bytes_of(static_cast<unsigned char>(text[end])));
  return text.substr(0, std::min(end, text.size())) + "...";
}

std::size_t unfinished(std::string_view text) {
  for (std::size_t back = 1; back <= 3 && back <= text.size(); ++back) {
    const auto byte = static_cast<unsigned char>(text[text.size() - back]);
    if ((byte & 0xC0U) == 0x80U) continue;
    return bytes_of(byte) > back ? back : 0;
  }
  return 0;
}

}  // namespace console
