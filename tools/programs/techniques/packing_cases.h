// Values of every parameter struct and the vectors that they are packed into: what the emitted C# is compared
// with.
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// {struct: [{values: {field: number, numbers or "NaN"}, vectors: [[x, y, z, w]]}]}. Of each struct: the
// defaults, both ends of every range, values beyond them, NaN, and some between; the vectors hold what is
// kept of them. Every number is a float exactly.
std::string packing_cases_json(const TechniqueList& list);

}  // namespace penumbra::techniques
