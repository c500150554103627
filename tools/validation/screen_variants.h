// The passes of a technique that runs over the screen, as the package's .shader has them. Internal to this
// room.
#pragma once

#include <string>
#include <vector>

#include "validation/source_variants.h"

namespace penumbra::validation {

// Vertex and fragment stage of every pass, in the order of the chain, each once.
std::vector<SourceVariant> screen_variants(const ValidationRequest& request,
                                           const techniques::Technique& technique,
                                           const std::vector<std::string>& keywords);

}  // namespace penumbra::validation
