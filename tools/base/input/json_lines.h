// JSON for files of cases that people compare: the members of the root, and the elements of these, each on a
// line of its own.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace penumbra {

// Numbers and texts are written as nlohmann::json::dump() writes them; the text ends with a line end.
std::string json_lines(const nlohmann::ordered_json& json);

}  // namespace penumbra
