// Everything that narrows the variants of a project.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "variants/keyword_space.h"

namespace penumbra::variants {

struct NarrowingInput {
  std::filesystem::path stripping;                // stripping.h; empty: none
  std::vector<std::filesystem::path> urp_assets;  // urp_settings.h
  std::vector<std::string> keywords;              // keyword_expression.h
};

// Combines all of them; each may only remove variants. Throws InputError.
Narrowing read_narrowing(const NarrowingInput& input);

}  // namespace penumbra::variants
