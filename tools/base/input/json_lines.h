// JSON for files of cases that people compare: the members of the root, and the elements of these, each on a
// line of its own.
#pragma once

#include <string>
#include <string_view>

namespace penumbra {

// `json` is JSON as nlohmann::json::dump() writes it, and its numbers and texts stay as they are.
std::string json_lines(std::string_view json);

}  // namespace penumbra
