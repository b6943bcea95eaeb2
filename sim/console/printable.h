#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Text that others wrote (names, reasons, what a program printed) made harmless for whoever reads it.
namespace console {

/// The text as one line of valid UTF-8 in which nothing acts on a terminal, an editor or a page.
///
/// Line ends and tabs become blanks. Control characters (also U+0080 to U+009F), what turns the direction of
/// writing, what has no width, separators of lines, tags and bytes that are no UTF-8 become U+FFFD each.
std::string printable(std::string_view text);

/// The same, but '\n' stays as it is.
std::string printable_lines(std::string_view text);

/// JSON in which such characters are written as \uXXXX: the same values, but harmless to look at. Bytes that
/// are no UTF-8 become U+FFFD.
/// @param text  valid JSON
std::string printable_json(std::string_view text);

/// Whether the text can stand for something by what is seen of it: printable() changes nothing in it, and no
/// letter of it is blank or for private use, where every font shows something else.
///
/// Selectors of a variant (U+FE00 to U+FE0F), with which emoji are written, may be in it.
bool is_visible(std::string_view text);

/// Characters of a printable text.
std::size_t length(std::string_view text);

/// At most `most` characters of a printable text; what is cut off ends in "...".
/// @pre most >= 3
std::string shortened(const std::string& text, std::size_t most);

/// Bytes at the end of a text that begin a character of which the rest may follow, at most three.
std::size_t unfinished(std::string_view text);

}  // namespace console
