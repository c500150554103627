#include "cost/cost_block.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "cost/families.h"
#include "cost/made_up_report.h"
#include "input/input_error_matcher.h"

namespace penumbra::cost {
namespace {

using testing::HasSubstr;

std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream) << file << " is missing";
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(CostBlock, NamesDriverCompilerAndCommandThenATableAFamily) {
  const std::string block = cost_block(made_up::report());
  std::size_t last = 0;
  for (const char* part :
       {"radv Mesa 1.2.3", "glslang 1", "`penumbra cost --family old --family new`", "**old**",
        "| hard | 90 |", "| hard +REVERSED | 91 |", "**new**", "0 in every row: SGPRs"}) {
    const std::size_t at = block.find(part, last);
    ASSERT_NE(at, std::string::npos) << part << " after " << last;
    last = at;
  }
}

TEST(CostBlock, TheSummaryPutsFamiliesSideBySide) {
  CostReport report = made_up::report();
  for (CostRow& row : report.rows)
    for (CostVariant& variant : row.variants) variant.keywords = {"UNITY_REVERSED_Z"};
  report.rows[3].measured.figures.instructions = 77;
  const std::string block = cost_summary_block(report);
  EXPECT_THAT(block,
              HasSubstr("| Technique | instructions, old | instructions, new | cycles per 64 lanes, old | "
                        "cycles per 64 lanes, new |"));
  EXPECT_THAT(block, HasSubstr("| hard | 90 | 77 | - | - |"));
  EXPECT_THAT(block, HasSubstr("| tent-3 | - | - | - | - |"));
}

TEST(CostBlock, WritesTheBlocksAFileHas) {
  const CostReport report = made_up::report();
  const std::string full =
      replace_cost_blocks("a\n<!-- cost:begin -->\nold<!-- cost:end -->\nb", report, "x.md");
  EXPECT_EQ(full, "a\n<!-- cost:begin -->\n" + cost_block(report) + "<!-- cost:end -->\nb");
  const std::string summary =
      replace_cost_blocks("<!-- cost-summary:begin --><!-- cost-summary:end -->", report, "x.md");
  EXPECT_EQ(summary,
            "<!-- cost-summary:begin -->\n" + cost_summary_block(report) + "<!-- cost-summary:end -->");
  expect_input_error([&] { replace_cost_blocks("nothing", report, "x.md"); },
                     HasSubstr("x.md: the marker '<!-- cost:begin -->' is missing"));
  expect_input_error([&] { replace_cost_blocks("<!-- cost-summary:end -->", report, "x.md"); },
                     HasSubstr("'<!-- cost-summary:begin -->' is missing"));
}

TEST(CostDocumentation, NamesEveryKnownFamilyAndEveryFigure) {
  const std::string text = file_text(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "docs" / "cost.md");
  for (const KnownFamily& family : known_families()) EXPECT_THAT(text, HasSubstr(family.name));
  for (const FigureName& name : figure_names())
    EXPECT_THAT(text, HasSubstr("`" + std::string(name.key) + "`"));
}

}  // namespace
}  // namespace penumbra::cost
