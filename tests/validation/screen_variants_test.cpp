#include "validation/screen_variants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace penumbra::validation {
namespace {

bool defines(const SourceVariant& variant, const std::string& keyword) {
  const auto& all = variant.unit.compile.defines;
  return std::any_of(all.begin(), all.end(), [&](const auto& define) { return define.first == keyword; });
}

bool resolve_has_the_masks_keyword(const std::string& technique) {
  ValidationRequest request;
  request.techniques = techniques::read_technique_list(PENUMBRA_SOURCE_DIR);
  for (const SourceVariant& variant : screen_variants(request, request.techniques->find(technique), {})) {
    if (variant.unit.pass == "Resolve" && variant.unit.compile.stage == hlsl::Stage::fragment)
      return defines(variant, "_PENUMBRA_MASK");
  }
  ADD_FAILURE() << technique << " has no Resolve pass";
  return false;
}

TEST(ScreenVariants, ResolveReadsTheMaskOnlyInAChainThatHasOne) {
  EXPECT_TRUE(resolve_has_the_masks_keyword("screen-tent-5-masked"));
  EXPECT_FALSE(resolve_has_the_masks_keyword("screen-tent-5"));
}

}  // namespace
}  // namespace penumbra::validation
