// Findings that have no line are silenced for a whole file; found/suppression.hlsl has the other comments.
#include "lint/suppression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace penumbra::lint {
namespace {

TEST(Suppression, FindingsWithoutALineNeedTheWholeFile) {
  hlsl::SourceFiles sources;
  sources.add("A.hlsl",
              "// penumbra-lint: disable-file=sampler-limit\n// penumbra-lint: disable=register-limit\n");
  const hlsl::Diagnostic samplers{"A.hlsl", 0, 0, hlsl::Severity::error, "17", {}, "sampler-limit"};
  const hlsl::Diagnostic registers{"A.hlsl", 0, 0, hlsl::Severity::error, "33", {}, "register-limit"};
  const hlsl::Diagnostic elsewhere{"B.hlsl", 0, 0, hlsl::Severity::error, "17", {}, "sampler-limit"};
  const std::vector<hlsl::Diagnostic> left = without_suppressed({samplers, registers, elsewhere}, sources);
  ASSERT_THAT(left, testing::SizeIs(2));
  EXPECT_EQ(left[0].rule, "register-limit");
  EXPECT_EQ(left[1].file, "B.hlsl");
}

}  // namespace
}  // namespace penumbra::lint
