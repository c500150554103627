// Expands a request into sources with their keywords. Internal to this folder.
#pragma once

#include <string>
#include <vector>

#include "validation/validate_techniques.h"

namespace penumbra::validation {

struct SourceVariant {
  const techniques::Technique* technique = nullptr;  // null for a user's file
  CompileUnit unit;
};

// Returns the sources of the techniques and of the files.
std::vector<SourceVariant> source_variants(const ValidationRequest& request);

// Returns vertex and fragment stage of every raster pass and every kernel, in the order in which they run. A
// pass that calls a filter has none of its own.
std::vector<SourceVariant> pass_variants(const ValidationRequest& request,
                                         const techniques::Technique& technique,
                                         const std::vector<std::string>& keywords);

}  // namespace penumbra::validation
