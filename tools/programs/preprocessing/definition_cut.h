// Parses the text that follows #define. Internal to this folder.
#pragma once

#include <optional>
#include <vector>

#include "preprocessing/cut_source.h"

namespace penumbra::preprocessing {

// Returns nothing if glslang would report an error or a warning.
std::optional<Definition> cut_definition(const std::vector<Token>& line);

// The comparison is that of the C standard and glslang (6.10.3): the same tokens, with white space at the
// same places.
bool are_identical(const Definition& a, const Definition& b);

}  // namespace penumbra::preprocessing
