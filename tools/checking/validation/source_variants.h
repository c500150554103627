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

}  // namespace penumbra::validation
