// "Did you mean ...": the known name closest to a misspelt one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

// Returns the known name that a person most likely meant; empty when none is near. The first choice is a name
// a single edit away (Damerau-Levenshtein, case ignored); then the shortest that begins with the given text,
// then the shortest one of whose words does ("fov" is near "fov_y_degrees"); then the one with the fewest
// edits, up to a third of the given name's length or two.
std::string nearest_name(std::string_view given, const std::vector<std::string>& known);

// Returns "unknown <kind> 'given'" and, when there is a near one, "did you mean 'x'?"; else the list of known
// names.
std::string unknown_name_remedy(std::string_view given, const std::vector<std::string>& known);

}  // namespace penumbra
