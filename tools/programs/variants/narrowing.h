// What narrows the variants of a project, from all places where it is said.
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

// All of them together; each may only take variants away. Throws InputError.
Narrowing read_narrowing(const NarrowingInput& input);

}  // namespace penumbra::variants
