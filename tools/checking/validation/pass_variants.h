// The programs of a technique's passes, as its .shader and .compute files have them. Internal to this folder.
#pragma once

#include <string>
#include <vector>

#include "validation/source_variants.h"

namespace penumbra::validation {

// Returns vertex and fragment stage of every raster pass and every kernel, in the order in which they run. A
// pass that calls a filter has none of its own.
std::vector<SourceVariant> pass_variants(const ValidationRequest& request,
                                         const techniques::Technique& technique,
                                         const std::vector<std::string>& keywords);

}  // namespace penumbra::validation
