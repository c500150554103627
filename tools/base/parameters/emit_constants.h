// A CascadeSet as a table to read, JSON to process, or source to compile. Figures are printed as the floats a
// shader gets, with the fewest digits that read back to the same bits.
#pragma once

#include <string>

#include "parameters/cascades.h"
#include "parameters/source_text.h"

namespace penumbra::parameters {

std::string constants_table(const CascadeSet& set);
std::string constants_json(const CascadeSet& set);
std::string constants_source(const CascadeSet& set, Language language);

}  // namespace penumbra::parameters
