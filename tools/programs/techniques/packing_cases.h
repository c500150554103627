// Values of every parameter struct and the vectors that they are packed into. The emitted C# is compared with
// them.
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Returns {struct: [{values: {field: number, numbers or "NaN"}, vectors: [[x, y, z, w]]}]}. Each struct has
// cases with the defaults, both ends of every range, values beyond them, NaN, and some between; the vectors
// hold what is kept of them. Every number is a float exactly.
std::string packing_cases_json(const TechniqueList& list);

}  // namespace penumbra::techniques
