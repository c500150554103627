// Matches paths against a pattern such as "Assets/Water/**".
//
//   ?     one character, not '/'
//   *     any characters, not '/'
//   **    any characters; "**/" between slashes also no folder at all
//
// Every other character matches itself; case-sensitive. A pattern without '/' is matched against the file's
// name only, one with '/' against the whole path. The time is the product of both lengths, whatever the
// pattern.
#pragma once

#include <string_view>

namespace penumbra::project {

// `path` has '/' as separator.
bool path_matches(std::string_view pattern, std::string_view path);

}  // namespace penumbra::project
