// Expands a request into sources with their keywords. Internal to this room.
#pragma once

#include <string>
#include <vector>

#include "validation/validate_techniques.h"

namespace penumbra::validation {

struct SourceVariant {
  const techniques::Technique* technique = nullptr;  // null for a user's file
  CompileUnit unit;
};

// Of the techniques, each with exits where its filter has them, and of the files.
std::vector<SourceVariant> source_variants(const ValidationRequest& request);

// The renderer feature's own pass over the screen with exits, for every technique that it offers them for.
// Those without exits are the techniques' that run over the screen.
std::vector<SourceVariant> screen_exits_variants(const ValidationRequest& request);

}  // namespace penumbra::validation
