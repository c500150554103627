// What stands behind #define. Internal to this room.
#pragma once

#include <optional>
#include <vector>

#include "preprocessing/cut_source.h"

namespace penumbra::preprocessing {

// Nothing where glslang has something to say of it.
std::optional<Definition> cut_definition(const std::vector<Token>& line);

// As the C standard and glslang compare them (6.10.3): the same tokens with blanks at the same places.
bool are_identical(const Definition& a, const Definition& b);

}  // namespace penumbra::preprocessing
