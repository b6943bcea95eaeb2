#include "sim/console/printable.h"

#include <gtest/gtest.h>

#include <string>

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
