#include "cost/cost_report.h"

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
using testing::Not;

std::filesystem::path written(const std::string& text) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) /
      (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "-cost.json");
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

TEST(CostReport, JsonReadsBackAsItWasWritten) {
  CostReport report = made_up::report();
  report.rows[1].measured = {};
  report.rows[1].measured.failure = "the driver's compiler was terminated by signal 11";
  const std::string json = cost_json(report);
  const CostReport again = read_cost_report(written(json));
  EXPECT_EQ(again.driver, report.driver);
  EXPECT_EQ(again.compiler, report.compiler);
  ASSERT_EQ(again.rows.size(), report.rows.size());
  for (std::size_t i = 0; i < report.rows.size(); ++i) {
    EXPECT_EQ(again.rows[i].variants, report.rows[i].variants);
    EXPECT_EQ(again.rows[i].measured.figures, report.rows[i].measured.figures);
    EXPECT_EQ(again.rows[i].measured.failure, report.rows[i].measured.failure);
  }
  EXPECT_EQ(again.failures(), 1U);
}

TEST(CostReport, JsonHoldsTheDriversOwnNamesButNoHash) {
  const std::string json = cost_json(made_up::report());
  EXPECT_THAT(json, HasSubstr("\"Branches\":3"));
  EXPECT_THAT(json, HasSubstr("\"Subgroups per SIMD\":16"));
  EXPECT_THAT(json, Not(HasSubstr("hash"))) << "two builds of one driver differ in it";
}

TEST(CostReport, ABadFileIsNamedWithItsPlace) {
  const auto reading = [](const std::string& text) { return [text] { read_cost_report(written(text)); }; };
  expect_input_error(reading("{}"), HasSubstr("is not a report of penumbra cost"));
  expect_input_error(reading("{\"driver\": \"d\",\n \"rows\": [\n {\"figures\": {\"instructions\": -1}}]}"),
                     HasSubstr("-cost.json:3:"));
  expect_input_error(reading("{\"driver\": \"d\", \"rows\": [{\"figures\": {\"instructoins\": 1}}]}"),
                     HasSubstr("instructoins"));
}

// A file of figures may come from anywhere.
TEST(CostReport, NothingOfAReportReachesTheTerminalAsItIs) {
  const std::string hostile = "\x1b[31m\n::error ::a";
  CostReport report = made_up::report();
  report.driver = hostile;
  for (RadvFamily& family : report.families) family.device = family.driver = hostile;
  report.families[0].name = hostile;
  for (CostRow& row : report.rows) {
    if (row.family == "old") row.family = hostile;
    row.file = row.entry = hostile;
    row.variants = {{"", {hostile}}};
  }
  report.rows[3].variants = {{hostile, {}}, {hostile + "b", {}}};
  report.rows[1].measured.failure = hostile;
  for (const std::string& text : {cost_table(report), cost_csv(report)}) {
    EXPECT_THAT(text, Not(HasSubstr("\x1b")));
    EXPECT_THAT(text, Not(HasSubstr("\n::error")));
    EXPECT_THAT(text, HasSubstr("\\x1B[31m\\n::error ::a"));
  }
}

TEST(CostReport, NamesSayWhatSharesAModule) {
  const CostReport report = made_up::report();
  EXPECT_EQ(row_name(report.rows[0]), "hard");
  EXPECT_EQ(row_name(report.rows[1]), "hard +REVERSED");
  EXPECT_EQ(row_name(report.rows[2]), "box-3 (and 1 more)");
  CostRow same = report.rows[0];
  same.variants.push_back({"hard", {"NO_EFFECT"}});
  EXPECT_EQ(row_name(same), "hard or +NO_EFFECT");
  same.variants = {{"", {"A", "B"}}};
  same.file = "My.hlsl";
  EXPECT_EQ(row_name(same), "My.hlsl Fragment +A +B");
}

TEST(CostReport, TheTableHasARowAFamilyAndExplainsItself) {
  CostReport report = made_up::report();
  report.rows[5].measured = {};
  report.rows[5].measured.failure = "the driver's compiler was terminated by signal 8";
  const std::string table = cost_table(report);
  EXPECT_THAT(table, HasSubstr("old: Old GPU, radv Mesa 1.2.3\n"));
  EXPECT_THAT(table, HasSubstr("box-3 is the same shader as box-5: they differ in uniforms\n"));
  EXPECT_THAT(table, HasSubstr("0 in every row: SGPRs, spilled VGPRs"));
  EXPECT_THAT(table,
              HasSubstr("failed: box-3 (and 1 more), new: the driver's compiler was terminated by signal 8"));
}

TEST(CostReport, CsvQuotesWhatWouldBreakALine) {
  CostReport report = made_up::report();
  report.rows.resize(1);
  report.rows[0].file = "a,\"b\".hlsl";
  const std::string csv = cost_csv(report);
  EXPECT_THAT(csv, HasSubstr("old,hard,\"a,\"\"b\"\".hlsl\",Fragment,fragment,,90,24,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2);
}

TEST(CostReport, CsvHasNoFormulas) {
  CostReport report = made_up::report();
  report.rows.resize(1);
  for (const char* begin : {"=", "+", "-", "@"}) {
    report.rows[0].file = std::string(begin) + "cmd|' /C calc'!A0";
    EXPECT_THAT(cost_csv(report), HasSubstr(",'" + report.rows[0].file + ",Fragment,"));
  }
  report.rows[0].file = "=1,2";
  EXPECT_THAT(cost_csv(report), HasSubstr(",\"'=1,2\",Fragment,"));
  report.rows[0].file = "a;=1";
  EXPECT_THAT(cost_csv(report), HasSubstr(",\"a;=1\",Fragment,"));
  report.rows[0].file = "+DARK +FOG_2";
  EXPECT_THAT(cost_csv(report), HasSubstr(",+DARK +FOG_2,Fragment,"));
  report.rows[0].file = "\t=1";
  EXPECT_THAT(cost_csv(report), HasSubstr(",\\t=1,Fragment,"));
}

TEST(CostDocumentation, NamesEveryKnownFamilyAndEveryFigure) {
  std::ifstream page(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "docs" / "cost.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  for (const KnownFamily& family : known_families()) EXPECT_THAT(text, HasSubstr(family.name));
  for (const FigureName& name : figure_names())
    EXPECT_THAT(text, HasSubstr("`" + std::string(name.key) + "`"));
}

}  // namespace
}  // namespace penumbra::cost
