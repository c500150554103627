// "Did you mean ...": the known name closest to what a person typed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

// The known name with the smallest edit distance (Damerau-Levenshtein, case ignored); empty when none is
// within a third of the given name's length (at least two edits).
std::string nearest_name(std::string_view given, const std::vector<std::string>& known);

// "unknown <kind> 'given'" and, when there is a near one, "did you mean 'x'?"; else the list of known names.
std::string unknown_name_way_out(std::string_view given, const std::vector<std::string>& known);

}  // namespace penumbra
