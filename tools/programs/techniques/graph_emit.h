// The graphs of the manifests as rows of the table that the renderer feature reads; TechniqueReader.cs says
// how. Graphs with a stencil are left out, because the feature does not draw them.
#pragma once

#include <string>
#include <vector>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Throws InputError where two graphs of the list have one name.
std::string graph_rows(const TechniqueList& list);

}  // namespace penumbra::techniques
