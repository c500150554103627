// Lists are given by commas, by repeating the option, or both; and several numbers with blanks or commas.
#include "cli/option_values.h"
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

class Lists : public ProgramTest {
 protected:
  // The names of the pictures that a small render writes.
  std::vector<std::string> drawn(const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"render",
                                       "--size",
                                       "32x18",
                                       "--map-size",
                                       "256",
                                       "--cache",
                                       path("cache").string(),
                                       "--reference-samples",
                                       "32",
                                       "-o",
                                       path("pictures").string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_success(arguments);
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path("pictures"))) {
      const std::string name = entry.path().stem().string();
      if (name.ends_with("_result")) names.push_back(name.substr(0, name.size() - 7));
    }
    return names;
  }
};

TEST_F(Lists, CommasAndRepetitionGoTogether) {
  EXPECT_THAT(drawn({"--scene", "slabs", "--technique", "hard,tent-5", "--light", "0.53,2", "--light", "5"}),
              UnorderedElementsAre("slabs_hard_0.53", "slabs_hard_2", "slabs_hard_5", "slabs_tent-5_0.53",
                                   "slabs_tent-5_2", "slabs_tent-5_5"));
}

TEST_F(Lists, ScenesToo) {
  EXPECT_THAT(
      drawn({"--scene", "slabs,contact-boxes", "--scene", "trees", "--technique", "hard", "--light", "2"}),
      UnorderedElementsAre("slabs_hard_2", "contact-boxes_hard_2", "trees_hard_2"));
}

TEST_F(Lists, TheNameOfAFileMayHoldAComma) {
  const std::string file = write("one,two.obj", "").string();
  EXPECT_THAT(cli::names_or_files({"a,b", file, "c"}), ElementsAre("a", "b", file, "c"));
}

TEST_F(Lists, OfFamiliesTargetsAndPatterns) {
  const auto shader = write("A.hlsl", "float4 Main() : SV_Target { return 1; }\n").string();
  const auto report =
      run({"validate", shader, "--target", "spirv,msl23", "--target", "hlsl50", "--no-cache"});
  EXPECT_THAT(report.output, HasSubstr("1 variant for 3 targets")) << report.errors;
  const auto cost =
      run({"cost", shader, "--family", "navi21,polaris10", "--family", "gfx1100", "--format", "csv"});
  for (const char* family : {"navi21", "polaris10", "gfx1100"}) EXPECT_THAT(cost.output, HasSubstr(family));
}

TEST_F(Lists, NumbersThatBelongTogetherHaveBlanksOrCommas) {
  const auto blanks =
      run({"constants", "--position", "1", "2", "3", "--splits", "0.1", "0.4", "--cascades", "3"});
  const auto commas = run({"constants", "--position", "1,2,3", "--splits", "0.1,0.4", "--cascades", "3"});
  EXPECT_EQ(blanks.exit_code, 0) << blanks.errors;
  EXPECT_EQ(blanks.output, commas.output);
  EXPECT_EQ(run({"constants", "--position=-1,2,3"}).exit_code, 0);
  EXPECT_EQ(run({"constants", "--position", "1,2"}).exit_code, 2);
}

}  // namespace
}  // namespace penumbra
