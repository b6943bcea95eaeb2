#pragma once

#include <string>

namespace report {

/// A text that others wrote, for HTML and SVG: as it reads, one line, and nothing in it is markup; also
/// inside an attribute in double quotes.
std::string escaped(const std::string& text);

/// The same with its line ends, for <pre>.
std::string escaped_lines(const std::string& text);

}  // namespace report
