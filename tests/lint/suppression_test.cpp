// Some comments silence a rule, and others only look so.
#include "lint/suppression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lint/linted_shader.h"

namespace penumbra::lint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// The shader has a pow that may be of a negative base in line 3, with a comment behind it and one above it.
std::vector<std::string> with_comments(const std::string& behind, const std::string& above = {},
                                       const std::string& top = {}) {
  const std::string text = top + "\nfloat4 Main(float2 uv : TEXCOORD0) : SV_Target { float4 c = 0;\n" +
                           (above.empty() ? "" : above + "\n") + "c += pow(uv.x, 1.5); " + behind +
                           "\nreturn c; }\n";
  std::vector<std::string> rules;
  for (const hlsl::Diagnostic& finding : lint(text)) rules.push_back(finding.rule);
  return rules;
}

TEST(Suppression, OnTheLineOrTheLineBefore) {
  EXPECT_THAT(with_comments(""), ElementsAre("negative-pow"));
  EXPECT_THAT(with_comments("// penumbra-lint: disable=negative-pow"), IsEmpty());
  EXPECT_THAT(with_comments("", "  // penumbra-lint: disable=negative-pow"), IsEmpty());
}

TEST(Suppression, NamesSeveralRules) {
  EXPECT_THAT(with_comments("// penumbra-lint: disable=nan-check, negative-pow"), IsEmpty());
  EXPECT_THAT(with_comments("// penumbra-lint: disable=nan-check"), ElementsAre("negative-pow"));
}

TEST(Suppression, LinesOfCommentsStandTogether) {
  EXPECT_THAT(
      with_comments("", "// penumbra-lint: disable=negative-pow\n// penumbra-lint: disable=nan-check"),
      IsEmpty());
}

TEST(Suppression, BehindCodeItIsNotForTheNextLine) {
  EXPECT_THAT(with_comments("", "c += 1; // penumbra-lint: disable=negative-pow"),
              ElementsAre("negative-pow"));
}

TEST(Suppression, OfAWholeFile) {
  EXPECT_THAT(with_comments("", "", "// penumbra-lint: disable-file=negative-pow"), IsEmpty());
}

TEST(Suppression, OfARuleThatDoesNotExistIsSaid) {
  EXPECT_THAT(with_comments("// penumbra-lint: disable=negativ-pow"),
              ElementsAre("negative-pow", "unknown-rule"));
  EXPECT_THAT(
      findings_of("unknown-rule", "// penumbra-lint: disable=negativ-pow\n" + fragment("", "1")),
      ElementsAre(
          "1:27 warning unknown-rule: this comment disables an unknown rule, 'negativ-pow'; did you mean "
          "'negative-pow'?"));
}

TEST(Suppression, FindingsWithoutALineNeedTheWholeFile) {
  hlsl::SourceFiles sources;
  sources.add("A.hlsl",
              "// penumbra-lint: disable-file=sampler-limit\n// penumbra-lint: disable=register-limit\n");
  const hlsl::Diagnostic samplers{"A.hlsl", 0, 0, hlsl::Severity::error, "17", {}, "sampler-limit"};
  const hlsl::Diagnostic registers{"A.hlsl", 0, 0, hlsl::Severity::error, "33", {}, "register-limit"};
  const hlsl::Diagnostic elsewhere{"B.hlsl", 0, 0, hlsl::Severity::error, "17", {}, "sampler-limit"};
  const std::vector<hlsl::Diagnostic> left = without_suppressed({samplers, registers, elsewhere}, sources);
  ASSERT_THAT(left, SizeIs(2));
  EXPECT_EQ(left[0].rule, "register-limit");
  EXPECT_EQ(left[1].file, "B.hlsl");
}

}  // namespace
}  // namespace penumbra::lint
