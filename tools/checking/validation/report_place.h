// File names and columns in the conventions of other programs. Internal to this folder.
#pragma once

#include <string>
#include <string_view>

#include "validation/report.h"

namespace penumbra::validation {

// Returns the path relative to the style's root, with '/'; unchanged if it is elsewhere or there is no root.
std::string relative_file(const std::string& file, const ReportStyle& style);

// Returns a relative reference of RFC 3986, or file:///... for an absolute path. Every byte outside of the
// unreserved set and '/' is percent-encoded.
std::string uri_of(const std::string& file);

// Returns the number of Unicode code points before the 1-based byte column, plus one; `line` may be empty.
int column_in_characters(std::string_view line, int column);

// Returns well-formed UTF-8: invalid bytes become U+FFFD.
std::string valid_utf8(std::string_view text);

}  // namespace penumbra::validation
