// Makes SPIR-V modules of tests from text, and words that are none.
#pragma once

#include <gtest/gtest.h>

#include <spirv-tools/libspirv.hpp>
#include <string>
#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// The module has the ids of the text; the test fails where it is no valid module.
inline SpirvModule assembled(const std::string& text) {
  SpirvModule module;
  const spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_1);
  EXPECT_TRUE(tools.Assemble(text, &module, SPV_TEXT_TO_BINARY_OPTION_PRESERVE_NUMERIC_IDS)) << text;
  EXPECT_TRUE(tools.Validate(module)) << text;
  return module;
}

// The modules are nothing, too few words for a header, and instructions of no length and of more words than
// there are.
inline std::vector<SpirvModule> malformed_modules() {
  return {{}, {1, 2, 3}, {1, 2, 3, 4, 5, 0}, {1, 2, 3, 4, 5, 0x00900036}};
}

}  // namespace penumbra::shaders
