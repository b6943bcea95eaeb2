#include "sim/console/printable.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace console {
namespace {

using namespace std::string_literals;
const std::string bad = "\xEF\xBF\xBD";

TEST(Printable, LeavesWordsOfAnyLanguageAsTheyAre) {
  for (const std::string text : {"", "team-reference 2", "Zürich ±", "日本", "🤖", "a\xEE\x80\x80"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, IsOneLine) { EXPECT_EQ(printable("a\nb\tc\r\n"), "a b c  "); }

TEST(Printable, KeepsLineEndsWhereThereAreLines) {
  EXPECT_EQ(printable_lines("a\nb\x1B[2J"), "a\nb" + bad + "[2J");
}

TEST(Printable, HasNoControlCharacters) {
  EXPECT_EQ(printable("\x1B]0;title\x07"), bad + "]0;title" + bad);
  EXPECT_EQ(printable("a\0b\x7F"s), "a" + bad + "b" + bad);
  EXPECT_EQ(printable("\xC2\x9B"), bad) << "U+009B, which begins a sequence as ESC [ does";
}

TEST(Printable, HasNothingThatTurnsOrHidesLetters) {
  EXPECT_EQ(printable("\xE2\x80\xAE"), bad) << "U+202E, right to left from here";
  EXPECT_EQ(printable("\xE2\x81\xA6"), bad) << "U+2066, an isolate";
  EXPECT_EQ(printable("\xE2\x80\x8B"), bad) << "U+200B, no width";
  EXPECT_EQ(printable("\xF3\xA0\x80\x81"), bad) << "U+E0001, a tag";
}

std::string utf8(char32_t code) {
  const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  const auto low = [&](int shift) { return byte(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0U | (code >> 6)), low(0)};
  if (code < 0x10000) return {byte(0xE0U | (code >> 12)), low(6), low(0)};
  return {byte(0xF0U | (code >> 18)), low(12), low(6), low(0)};
}

// Category Cf of DerivedGeneralCategory-15.1.0.txt, and Zl and Zp; the tested list has whole blocks.
TEST(Printable, HasNoFormatCharacter) {
  std::vector<char32_t> all{0xAD,   0x61C,  0x6DD,   0x70F,   0x890,  0x891,  0x8E2,
                            0x180E, 0xFEFF, 0x110BD, 0x110CD, 0x2028, 0x2029, 0xE0001};
  const auto from = [&](char32_t first, char32_t last) {
    for (char32_t code = first; code <= last; ++code) all.push_back(code);
  };
  from(0x600, 0x605);
  from(0x200B, 0x200F);
  from(0x202A, 0x202E);
  from(0x2060, 0x2064);
  from(0x2066, 0x206F);
  from(0xFFF9, 0xFFFB);
  from(0x13430, 0x1343F);
  from(0x1BCA0, 0x1BCA3);
  from(0x1D173, 0x1D17A);
  from(0xE0020, 0xE007F);
  EXPECT_EQ(all.size(), 172U);  // 170 of Cf, one each of Zl and Zp
  for (const char32_t code : all) {
    EXPECT_EQ(printable("a" + utf8(code) + "b"), "a" + bad + "b") << std::hex << static_cast<unsigned>(code);
    EXPECT_EQ(printable_json(utf8(code)).substr(0, 2), "\\u") << std::hex << static_cast<unsigned>(code);
  }
}

TEST(Printable, VisibleIsWhatIsSeenAndMeansTheSameEverywhere) {
  for (const std::string text :
       {"", "team-reference 2", "Zürich ±", "日本", "🤖", "a\xC2\xA0", "⚽\xEF\xB8\x8F"}) {
    EXPECT_TRUE(is_visible(text)) << text;
  }
  for (const std::string text : {"a\nb", "a\tb", "\x1B[2J", "\xFF"}) EXPECT_FALSE(is_visible(text)) << text;
  for (const char32_t code : {0x200B, 0xFEFF, 0xAD, 0x2028, 0xE0041, 0xFFF9,  // acts
                              0x34F, 0x115F, 0x3164, 0xFFA0, 0x2800, 0xE000, 0xF8FF, 0xF0000, 0x10FFFD}) {
    EXPECT_FALSE(is_visible("a" + utf8(code) + "b")) << std::hex << static_cast<unsigned>(code);
  }
}

TEST(Printable, IsValidUtf8) {
  EXPECT_EQ(printable("a\xFF"), "a" + bad);
  EXPECT_EQ(printable("\xC3"), bad) << "cut off";
  EXPECT_EQ(printable("\xC0\x80"), bad + bad) << "longer than necessary";
  EXPECT_EQ(printable("\xED\xA0\x80"), bad + bad + bad) << "a surrogate";
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), bad + bad + bad + bad) << "above U+10FFFF";
}

TEST(PrintableJson, EscapesInsteadOfReplacing) {
  EXPECT_EQ(printable_json("{\"a\":\n \"\xC2\x9B\"}"), "{\"a\":\n \"\\u009b\"}");
  EXPECT_EQ(printable_json("\"\xF3\xA0\x80\x81\""), "\"\\udb40\\udc01\"");
}

TEST(Shortened, CountsCharactersNotBytes) {
  EXPECT_EQ(shortened("ööööö", 5), "ööööö");
  EXPECT_EQ(shortened("öööööö", 5), "öö...");
  EXPECT_EQ(length("ö日🤖a"), 4U);
}

TEST(Unfinished, IsWhatBeginsACharacter) {
  EXPECT_EQ(unfinished("abc"), 0U);
  EXPECT_EQ(unfinished("a\xE6\x97"), 2U);
  EXPECT_EQ(unfinished("a\xF0"), 1U);
  EXPECT_EQ(unfinished("日"), 0U);
  EXPECT_EQ(unfinished("\x80\x80\x80\x80"), 0U);
}

}  // namespace
}  // namespace console
