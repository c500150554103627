#include "variants/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

using hlsl::Stage;
using testing::HasSubstr;
using testing::Not;

const char* const lit_text =
    "#pragma multi_compile _ SHADOWS SHADOWS_SOFT\n#pragma multi_compile_fragment _ COOKIES\n"
    "#pragma multi_compile FAST SLOW\n";

TEST(Plan, CountsEveryStageOfEveryProgram) {
  const KeywordSpace lit(pragmas_of(lit_text));
  const KeywordSpace blur(pragmas_of("#pragma kernel K\n#pragma multi_compile _ WIDE\n"));
  const Plan counted = plan({{"Lit.shader: Forward", &lit, {Stage::vertex, Stage::fragment}},
                             {"Blur.compute: K", &blur, {Stage::compute}}});
  ASSERT_EQ(counted.programs.size(), 2U);
  EXPECT_EQ(counted.programs[0].stages[0].variants, VariantCount(6));
  EXPECT_EQ(counted.programs[0].stages[1].variants, VariantCount(12));
  EXPECT_EQ(counted.programs[0].results, VariantCount(18));
  EXPECT_EQ(counted.results, VariantCount(20));
  EXPECT_EQ(
      text_of(counted),
      "  Lit.shader: Forward   vertex 6   fragment 12\n  Blur.compute: K   compute 2\n  in all 20 results\n");
}

TEST(Plan, AVariantHasAResultForEachTarget) {
  const KeywordSpace blur(pragmas_of("#pragma kernel K\n#pragma multi_compile _ WIDE\n"));
  const PlannedProgram program{"Blur.compute: K", &blur, {Stage::compute}, 5};
  EXPECT_EQ(plan({program}).programs[0].stages[0].variants, VariantCount(2));
  EXPECT_EQ(plan({program}).results, VariantCount(10));
  EXPECT_EQ(refusal({program}, 10), "");
  EXPECT_THAT(refusal({program}, 9), testing::HasSubstr("10 results to compile; the limit is 9"));
  EXPECT_THAT(refusal({program}, 9), testing::HasSubstr("  5 left   --keywords '-WIDE'"));
}

TEST(Plan, SaysWhatWouldBeBesideWhatIs) {
  const KeywordSpace lit(pragmas_of(lit_text));
  const KeywordSpace less(pragmas_of(lit_text), {{never("COOKIES", "")}, {}, {}, {}});
  EXPECT_EQ(text_of(plan({{"Lit", &lit, {Stage::vertex, Stage::fragment}}}),
                    plan({{"Lit", &less, {Stage::vertex, Stage::fragment}}}), "-COOKIES"),
            "  Lit   vertex 6 (6)   fragment 12 (6)\n  in all 18 results (12 with -COOKIES)\n");
}

TEST(Refusal, IsEmptyWithinTheLimit) {
  const KeywordSpace lit(pragmas_of(lit_text));
  EXPECT_EQ(refusal({{"Lit", &lit, {Stage::vertex}}}, 6), "");
}

TEST(Refusal, NamesWhatMultipliesMostAndHowToPinIt) {
  const KeywordSpace lit(pragmas_of(lit_text));
  EXPECT_EQ(refusal({{"Lit", &lit, {Stage::vertex, Stage::fragment}}, {"Unlit", &lit, {Stage::vertex}}}, 10),
            "24 results to compile; the limit is 10\nmost of them in\n  Lit   vertex 6   fragment 12\n  "
            "Unlit   vertex 6\nwhat multiplies the number most, and how many results are left without it\n  "
            "8 left   --keywords '-SHADOWS -SHADOWS_SOFT'\n  12 left   --keywords '+FAST'\n  18 left   "
            "--keywords '-COOKIES'\nnarrow the keywords (+NAME always, -NAME never, A|B only these), pass a "
            "stripping file with what the project uses (URP settings, materials), compile only some variants "
            "of each entry "
            "point with --sample 3, or raise the limit\n");
}

TEST(Refusal, WhatItPromisesHolds) {
  const Pragmas pragmas = pragmas_of(lit_text);
  const KeywordSpace pinned(pragmas, {{never("SHADOWS", ""), never("SHADOWS_SOFT", "")}, {}, {}, {}});
  EXPECT_EQ(
      plan({{"Lit", &pinned, {Stage::vertex, Stage::fragment}}, {"Unlit", &pinned, {Stage::vertex}}}).results,
      VariantCount(8));
}

TEST(Refusal, StaysShort) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "#pragma multi_compile _ K" + std::to_string(i) + "\n";
  const KeywordSpace space(pragmas_of(text));
  std::vector<PlannedProgram> programs(20, {"P", &space, {Stage::vertex}});
  const std::string refused = refusal(programs, 1000);
  EXPECT_THAT(refused,
              HasSubstr("more than 18,446,744,073,709,551,614 results to compile; the limit is 1,000\n"));
  EXPECT_THAT(refused, HasSubstr("  and 12 more programs\n"));
  EXPECT_LT(std::count(refused.begin(), refused.end(), '\n'), 25);
}

}  // namespace
}  // namespace penumbra::variants
