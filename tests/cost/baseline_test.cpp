#include "cost/baseline.h"

#include <gmock/gmock.h>

#include "cost/families.h"
#include "cost/made_up_report.h"
#include "input/input_error.h"

namespace penumbra::cost {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

void set_instructions(CostRow& row, std::uint64_t instructions) {
  row.measured.figures.instructions = instructions;
}

TEST(Baseline, EqualFiguresPass) {
  const BaselineComparison comparison = compare_with_baseline(made_up::report(), made_up::report(), {}, 0.0);
  EXPECT_TRUE(comparison.passed());
  EXPECT_THAT(comparison.better, IsEmpty());
  EXPECT_EQ(comparison.compared, 6U);
}

TEST(Baseline, OneInstructionMoreIsWorseAndOneLessBetter) {
  CostReport now = made_up::report();
  set_instructions(now.rows[0], 91);
  set_instructions(now.rows[1], 90);
  const BaselineComparison comparison = compare_with_baseline(now, made_up::report(), {}, 0.0);
  ASSERT_THAT(comparison.worse, SizeIs(1));
  ASSERT_THAT(comparison.better, SizeIs(1));
  EXPECT_FALSE(comparison.passed());
  EXPECT_THAT(comparison_text(comparison), HasSubstr("worse: old hard: instructions 90 -> 91\n"));
  EXPECT_THAT(comparison_text(comparison), HasSubstr("better: old hard +REVERSED: instructions 91 -> 90\n"));
}

TEST(Baseline, LessOccupancyIsWorse) {
  CostReport now = made_up::report();
  now.rows[0].measured.figures.occupancy = 15;
  now.rows[1].measured.figures.occupancy = 17;
  const BaselineComparison comparison = compare_with_baseline(now, made_up::report(), {}, 0.0);
  ASSERT_THAT(comparison.worse, SizeIs(1));
  EXPECT_EQ(comparison.worse[0].after, 15U);
  EXPECT_THAT(comparison.better, SizeIs(1));
}

TEST(Baseline, TheToleranceIsOfTheEarlierFigure) {
  CostReport now = made_up::report();
  set_instructions(now.rows[0], 99);  // 10 % of 90 more
  EXPECT_TRUE(compare_with_baseline(now, made_up::report(), {}, 10.0).passed());
  EXPECT_FALSE(compare_with_baseline(now, made_up::report(), {}, 9.9).passed());
}

TEST(Baseline, SpillsWhereNoneWereAreBeyondAnyPercentage) {
  CostReport before = made_up::report();
  CostReport now = made_up::report();
  before.rows[0].measured.figures.spilled_vgprs = 0;
  now.rows[0].measured.figures.spilled_vgprs = 1;
  EXPECT_FALSE(compare_with_baseline(now, before, {}, 1000.0).passed());
}

// Two passes of one shader may have one name.
TEST(Baseline, RowsOfEqualNamesAreComparedInTheirOrder) {
  CostReport report = made_up::report();
  report.rows.push_back(report.rows[0]);
  set_instructions(report.rows.back(), 7);
  const BaselineComparison same = compare_with_baseline(report, report, {}, 0.0);
  EXPECT_TRUE(same.passed());
  EXPECT_THAT(same.better, IsEmpty());
  EXPECT_EQ(same.compared, 7U);
  EXPECT_THAT(compare_with_baseline(made_up::report(), report, {}, 0.0).gone, ElementsAre("old hard"));
  EXPECT_THAT(compare_with_baseline(report, made_up::report(), {}, 0.0).unknown, ElementsAre("old hard"));
}

TEST(Baseline, NewAndGoneRowsAreFindings) {
  CostReport now = made_up::report();
  now.rows[0].variants = {{"soft", {}}};
  const BaselineComparison comparison = compare_with_baseline(now, made_up::report(), {}, 0.0);
  EXPECT_THAT(comparison.unknown, ElementsAre("old soft"));
  EXPECT_THAT(comparison.gone, ElementsAre("old hard"));
  EXPECT_FALSE(comparison.passed());
}

TEST(Baseline, ARunOfPartOfItMissesNothing) {
  CostReport now = made_up::report();
  now.rows = {now.rows[0], now.rows[1]};
  const ComparedExtent extent{{"old"}, {"hard"}, {}};
  EXPECT_TRUE(compare_with_baseline(now, made_up::report(), extent, 0.0).passed());
  EXPECT_THAT(compare_with_baseline(now, made_up::report(), {{"old"}, {}, {}}, 0.0).gone,
              ElementsAre("old box-3", "old box-5"));
}

TEST(Baseline, AUsersFileExpectsItselfAlone) {
  CostReport before = made_up::report();
  before.rows.push_back(made_up::row("old", {{"", {"A"}}}, 50));
  before.rows.back().file = "My.hlsl";
  CostReport now = before;
  now.rows = {before.rows.back()};
  EXPECT_TRUE(compare_with_baseline(now, before, {{"old"}, {}, {"My.hlsl"}}, 0.0).passed());
  now.rows.clear();
  EXPECT_THAT(compare_with_baseline(now, before, {{"old"}, {}, {"My.hlsl"}}, 0.0).gone,
              ElementsAre("old My.hlsl Fragment +A"));
}

TEST(Baseline, TechniquesThatPartStillMeetTheirSharedFigures) {
  CostReport now = made_up::report();
  now.rows[2].variants = {{"box-3", {}}};
  now.rows.push_back(made_up::row("old", {{"box-5", {}}}, 150));
  const BaselineComparison comparison = compare_with_baseline(now, made_up::report(), {}, 0.0);
  EXPECT_THAT(comparison.unknown, IsEmpty());
  EXPECT_THAT(comparison_text(comparison), HasSubstr("worse: old box-5: instructions 140 -> 150\n"));
}

TEST(Baseline, OtherCompilersAreRefusedWithTheRemedy) {
  const CostReport baseline = made_up::report();
  CostReport ours = baseline;
  EXPECT_NO_THROW(require_same_compilers(ours, baseline, "cost.json"));
  ours.driver = "radv Mesa 9";
  try {
    require_same_compilers(ours, baseline, "cost.json");
    FAIL() << "figures of two drivers were compared";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cost.json: measured with radv Mesa 1.2.3"));
    EXPECT_THAT(error.what(), HasSubstr("this machine has radv Mesa 9"));
    EXPECT_THAT(error.what(), HasSubstr("--any-driver"));
  }
  ours = baseline;
  ours.compiler = "glslang 9";
  EXPECT_THROW(require_same_compilers(ours, baseline, "cost.json"), EnvironmentError);
}

TEST(Baseline, AnotherFxcIsRefusedWhereBothHaveItsBytecode) {
  CostReport baseline = made_up::report();
  CostReport ours = baseline;
  ours.families.push_back({direct3d_family.name, direct3d_family.architecture, "FXC 2"});
  EXPECT_NO_THROW(require_same_compilers(ours, baseline, "cost.json"));
  baseline.families.push_back({direct3d_family.name, direct3d_family.architecture, "FXC 1"});
  try {
    require_same_compilers(ours, baseline, "cost.json");
    FAIL() << "figures of two versions of FXC were compared";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("glslang 1, SPIRV-Tools 2 and FXC 1, but this machine has radv Mesa "
                                        "1.2.3 and glslang 1, SPIRV-Tools 2 and FXC 2"));
  }
}

TEST(Baseline, OfBytecodeAloneFxcIsNamedOnceAndTheDriverDoesNotMatter) {
  const auto of_fxc = [](const std::string& version) {
    CostReport report;
    report.driver = report.compiler = version;
    report.families = {{direct3d_family.name, direct3d_family.architecture, version}};
    return report;
  };
  CostReport both = made_up::report();
  both.families.push_back({direct3d_family.name, direct3d_family.architecture, "FXC 1"});
  EXPECT_NO_THROW(require_same_compilers(of_fxc("FXC 1"), both, "cost.json"));
  EXPECT_EQ(compilers_of(of_fxc("FXC 1"), of_fxc("FXC 2")), "FXC 1");
  EXPECT_EQ(compilers_of(of_fxc("FXC 1"), made_up::report()), "FXC 1");
  EXPECT_THROW(require_same_compilers(of_fxc("FXC 1"), made_up::report(), "cost.json"), EnvironmentError);
  EXPECT_THROW(require_same_compilers(of_fxc("FXC 2"), both, "cost.json"), EnvironmentError);
}

TEST(Baseline, CountsOfOneAreSingular) {
  CostReport now = made_up::report();
  set_instructions(now.rows[0], 91);
  now.rows[1].variants = {{"soft", {}}};
  EXPECT_THAT(
      comparison_text(compare_with_baseline(now, made_up::report(), {}, 0.0)),
      HasSubstr("\n5 rows compared, 1 figure worse, 0 better, 1 row not in the baseline, 1 only there\n"));
}

TEST(Baseline, FamiliesOutsideOfTheExtentAreNotCompared) {
  CostReport now = made_up::report();
  now.rows.push_back(made_up::row(direct3d_family.name, {{"hard", {}}}, 12));
  EXPECT_TRUE(compare_with_baseline(now, made_up::report(), {{"old", "new"}, {}, {}}, 0.0).passed());
  EXPECT_FALSE(compare_with_baseline(now, made_up::report(), {}, 0.0).passed());
}

}  // namespace
}  // namespace penumbra::cost
