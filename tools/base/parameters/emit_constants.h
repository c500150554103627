// A CascadeSet as a table to read, JSON to process, or source to compile. Figures are printed as the floats a
// shader gets, with the fewest digits that read back to the same bits.
#pragma once

#include <string>
#include <vector>

#include "parameters/cascades.h"
#include "parameters/source_text.h"
#include "parameters/verify.h"

namespace penumbra::parameters {

// `errors` is the result of verify_fit() or verify_dump(), one list per cascade.
std::string constants_table(const CascadeSet& set, const std::vector<CascadeErrors>& errors);
std::string constants_json(const CascadeSet& set, const std::vector<CascadeErrors>& errors);
std::string constants_source(const CascadeSet& set, Language language);

}  // namespace penumbra::parameters
