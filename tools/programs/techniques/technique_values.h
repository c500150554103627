// A technique with other values than the list gives it.
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Describes the problem of a value of the field: no finite number, not whole where the field is an int, out
// of range. The result is empty if there is none.
std::string value_problem(const ParameterField& field, double value);

// Throws InputError, naming the technique and its parameters, when it has none of that name, and for a value
// that value_problem() refuses.
Technique with_value(const TechniqueList& list, Technique technique, const std::string& parameter,
                     double value);

}  // namespace penumbra::techniques
