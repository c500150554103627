// Compares the library's own figures: a change of a shader that costs an instruction more is seen here.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iostream>

#include "cost/baseline.h"
#include "cost/families.h"
#include "cost/measure_cost.h"
#include "fxc/at_hand.h"

namespace penumbra::cost {
namespace {

using testing::IsEmpty;

constexpr const char* family = "navi21";

CostRequest library_request() {
  const std::filesystem::path root = PENUMBRA_SOURCE_DIR;
  CostRequest request;
  request.techniques = techniques::read_technique_list(root);
  request.families = {family};
  request.worker = PENUMBRA_PROGRAM;
  request.jobs = 2;
  return request;
}

void keep(CostRequest& request, const std::vector<std::string>& names) {
  std::erase_if(request.techniques->techniques, [&names](const techniques::Technique& technique) {
    return std::find(names.begin(), names.end(), technique.name) == names.end();
  });
}

const Figures& figures_of_technique(const CostReport& report, const std::string& technique) {
  for (const CostRow& row : report.rows)
    for (const CostVariant& variant : row.variants)
      if (variant == CostVariant{technique, {"UNITY_REVERSED_Z"}}) return row.measured.figures;
  ADD_FAILURE() << "no row of " << technique;
  static const Figures none;
  return none;
}

// The order is true of any compiler worth the name.
void expect_order(const CostReport& report) {
  const auto instructions = [&report](const char* technique) {
    return figures_of_technique(report, technique).instructions.value_or(0);
  };
  EXPECT_LT(instructions("hard"), instructions("bilinear"));
  EXPECT_LT(instructions("bilinear"), instructions("four-tap-plane"));
  EXPECT_LT(instructions("hard"), instructions("tent-3"));
  EXPECT_LT(instructions("tent-3"), instructions("tent-5"));
  EXPECT_LT(instructions("tent-5"), instructions("tent-7"));
  EXPECT_LT(instructions("tent-5"), instructions("tent-5-plane"));
  EXPECT_LT(instructions("bilinear"), instructions("pcss-poisson-25"));
  for (const CostRow& row : report.rows) {
    EXPECT_EQ(row.measured.failure, "") << row_name(row);
    EXPECT_EQ(row.measured.figures.spilled_vgprs, 0U) << row_name(row);
    EXPECT_EQ(row.measured.figures.spilled_sgprs, 0U) << row_name(row);
    EXPECT_EQ(row.measured.figures.scratch_bytes, 0U) << row_name(row);
    // This is what Vulkan promises every group (maxComputeSharedMemorySize), and OpenGL ES 3.1.
    EXPECT_LE(row.measured.figures.lds_bytes.value_or(0), 16384U) << row_name(row);
  }
}

TEST(LibraryCost, IsTheCommittedOne) {
  const std::filesystem::path file = PENUMBRA_SOURCE_DIR "/Documentation~/results/cost.json";
  const CostReport committed = read_cost_report(file);
  const CostOutcome measured = measure_cost(library_request());
  EXPECT_THAT(measured.diagnostics, IsEmpty());
  expect_order(measured.report);

  const BaselineComparison comparison =
      compare_with_baseline(measured.report, committed, {{family}, {}, {}}, 0.0);
  EXPECT_THAT(comparison.unknown, IsEmpty()) << "techniques without committed figures: run scripts/publish";
  EXPECT_THAT(comparison.gone, IsEmpty()) << "committed figures without a technique: run scripts/publish";
  if (measured.report.driver != committed.driver || measured.report.compiler != committed.compiler) {
    std::cout << "the committed figures are of " << committed.driver << " and " << committed.compiler
              << "; here are " << measured.report.driver << " and " << measured.report.compiler
              << ": only rows, order and spills were compared\n";
    return;
  }
  EXPECT_TRUE(comparison.worse.empty() && comparison.better.empty())
      << comparison_text(comparison) << "when that is meant, scripts/publish writes the new figures";
  for (const CostRow& row : committed.rows) {
    if (row.family != family) continue;
    const auto same = std::find_if(
        measured.report.rows.begin(), measured.report.rows.end(),
        [&row](const CostRow& other) { return other.variants == row.variants && other.entry == row.entry; });
    ASSERT_NE(same, measured.report.rows.end()) << row_name(row) << " shares its module with others now";
    EXPECT_EQ(same->measured.subgroup_size, row.measured.subgroup_size) << row_name(row);
  }
}

// OpenGL ES 3.1 and Vulkan promise every group this memory. Bytecode is the one form in which a group's
// memory does not depend on a driver.
TEST(LibraryCost, BytecodeIsTheCommittedOneAndGroupsHaveTheirMemory) {
  PENUMBRA_NEEDS_FXC();
  const CostReport committed = read_cost_report(PENUMBRA_SOURCE_DIR "/Documentation~/results/cost.json");
  CostRequest request = library_request();
  request.families = {direct3d_family.name};
  const CostOutcome measured = measure_cost(request);
  EXPECT_THAT(measured.diagnostics, IsEmpty());
  std::uint64_t most = 0;
  for (const CostRow& row : measured.report.rows) {
    const std::uint64_t bytes = row.measured.figures.lds_bytes.value_or(0);
    EXPECT_LE(bytes, 16384U) << row_name(row);
    most = std::max(most, bytes);
  }
  EXPECT_EQ(most, 1024U) << "some technique has memory of its groups";
  const BaselineComparison comparison =
      compare_with_baseline(measured.report, committed, {{direct3d_family.name}, {}, {}}, 0.0);
  EXPECT_THAT(comparison.unknown, IsEmpty()) << "techniques without committed figures: run scripts/publish";
  EXPECT_THAT(comparison.gone, IsEmpty()) << "committed figures without a technique: run scripts/publish";
  if (driver_of(measured.report, direct3d_family.name) != driver_of(committed, direct3d_family.name)) return;
  EXPECT_TRUE(comparison.worse.empty() && comparison.better.empty())
      << comparison_text(comparison) << "when that is meant, scripts/publish writes the new figures";
}

TEST(LibraryCost, TwoRunsGiveTheSameBytesWhateverTheThreads) {
  CostRequest request = library_request();
  keep(request, {"hard", "four-tap-plane", "box-5", "pcss-angular-24-16", "pcss-angular-64-64"});
  const std::string once = cost_json(measure_cost(request).report);
  request.jobs = 5;
  EXPECT_EQ(cost_json(measure_cost(request).report), once);
}

// PCSS 24+16 and 64+64 differ in uniforms alone, so their figures are one row; keywords make rows of their
// own.
TEST(LibraryCost, PresetsThatAreUniformsShareARow) {
  CostRequest request = library_request();
  keep(request, {"hard", "pcss-angular-24-16", "pcss-angular-64-64"});
  const CostReport report = measure_cost(request).report;
  ASSERT_EQ(report.rows.size(), 6U);
  EXPECT_EQ(row_name(report.rows[0]), "hard");
  EXPECT_EQ(row_name(report.rows[1]), "hard +UNITY_REVERSED_Z");
  const std::vector<CostVariant> both{{"pcss-angular-24-16", {}}, {"pcss-angular-64-64", {}}};
  EXPECT_EQ(report.rows[2].variants, both);
}

// The two bodies differ in precision alone, as Unity's libraries have them: glslang refuses the second.
TEST(LibraryCost, AUsersFileMayBeWrittenAsUnitysAre) {
  const std::filesystem::path folder = testing::TempDir();
  std::ofstream(folder / "cost-twins.hlsl") << "half4 Tint(half4 a) { return a * a; }\n"
                                               "float4 Tint(float4 a) { return a * a; }\n"
                                               "half4 Main(float4 a : A) : SV_Target { return Tint(a); };;\n";
  CostRequest request;
  request.families = {family};
  request.worker = PENUMBRA_PROGRAM;
  request.files = {{folder / "cost-twins.hlsl"}};
  const CostOutcome outcome = measure_cost(request);
  EXPECT_THAT(outcome.diagnostics, IsEmpty());
  ASSERT_EQ(outcome.report.rows.size(), 1U);
  EXPECT_EQ(outcome.report.failures(), 0U);
}

TEST(LibraryCost, AFileThatDoesNotCompileIsADiagnosticAndTheRestGoesOn) {
  const std::filesystem::path folder = testing::TempDir();
  std::ofstream(folder / "cost-good.hlsl") << "float4 Main() : SV_Target { return 1; }\n";
  std::ofstream(folder / "cost-bad.hlsl") << "float4 Main() : SV_Target { return undeclared; }\n";
  CostRequest request;
  request.families = {family};
  request.worker = PENUMBRA_PROGRAM;
  request.files = {{folder / "cost-bad.hlsl"}, {folder / "cost-good.hlsl"}};
  const CostOutcome outcome = measure_cost(request);
  ASSERT_EQ(outcome.diagnostics.size(), 1U);
  EXPECT_EQ(outcome.diagnostics[0].line, 1);
  ASSERT_EQ(outcome.report.rows.size(), 1U);
  EXPECT_EQ(outcome.report.failures(), 0U);
}

}  // namespace
}  // namespace penumbra::cost
