#include "techniques/technique_list.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "input/input_error_matcher.h"

namespace penumbra::techniques {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TechniqueList made_up() {
  TechniqueList list;
  list.structs = {{"Pcss",
                   "",
                   {{"blockerSamples", "int", "", "", ParameterRange{1.0, 64.0}, {}},
                    {"clump", "float", "", "", std::nullopt, {}},
                    {"stretch", "float2", "", "", std::nullopt, {}}}},
                  {"Mask", "", {{"reach", "float", "", "", ParameterRange{0.0, 8.0}, {}}}}};
  Technique technique;
  technique.name = "soft";
  GraphPass mask;
  mask.kind = PassKind::raster;
  mask.parameters = {"Mask"};
  GraphPass soft;
  soft.filter = FilterCall{"", "", {}, "Pcss"};
  technique.graph.passes = {mask, soft};
  technique.values = {
      {"blockerSamples", {24.0}}, {"clump", {1.0}}, {"stretch", {1.0, 2.0}}, {"reach", {2.0}}};
  list.techniques.push_back(technique);
  Technique bare;
  bare.name = "bare";
  GraphPass hard;
  hard.filter = FilterCall{};
  bare.graph.passes = {hard};
  list.techniques.push_back(bare);
  return list;
}

std::string problem(const std::string& technique, const std::string& parameter, double value) {
  const TechniqueList list = made_up();
  return input_error_of([&] { with_value(list, list.find(technique), parameter, value); });
}

TEST(TechniqueValues, OneValueIsReplacedAndNoOther) {
  const TechniqueList list = made_up();
  const Technique varied = with_value(list, list.find("soft"), "blockerSamples", 4.0);
  EXPECT_EQ(varied.values.at("blockerSamples"), std::vector<double>{4.0});
  EXPECT_EQ(varied.values.at("clump"), std::vector<double>{1.0});
  EXPECT_EQ(list.find("soft").values.at("blockerSamples"), std::vector<double>{24.0});
  EXPECT_EQ(with_value(list, list.find("soft"), "reach", 0.5).values.at("reach"), std::vector<double>{0.5})
      << "of any pass";
}

TEST(TechniqueValues, AnUnknownParameterNamesTheNearestAndAll) {
  EXPECT_THAT(
      problem("soft", "blockerSample", 4.0),
      HasSubstrs("technique 'soft' has no parameter 'blockerSample'", "did you mean 'blockerSamples'?",
                 "its parameters are: reach, blockerSamples, clump, stretch"));
  EXPECT_THAT(problem("soft", "x", 4.0), AllOf(HasSubstr("reach"), Not(HasSubstr("did you mean"))));
  EXPECT_THAT(problem("bare", "blockerSamples", 4.0), HasSubstrs("technique 'bare'", "it has no parameters"));
}

TEST(TechniqueValues, ValuesOutOfRangeNameIt) {
  for (const double value : {0.0, 65.0, -1.0, 1.5}) {
    EXPECT_THAT(problem("soft", "blockerSamples", value),
                HasSubstrs("technique 'soft'", "'blockerSamples' is a whole number from 1 to 64, not "));
  }
  EXPECT_EQ(problem("soft", "blockerSamples", 1.0), "no error");
  EXPECT_EQ(problem("soft", "blockerSamples", 64.0), "no error");
  EXPECT_EQ(problem("soft", "clump", -1e9), "no error") << "no range";
  EXPECT_THAT(problem("soft", "clump", std::numeric_limits<double>::infinity()),
              HasSubstr("a number, not inf"));
  EXPECT_THAT(problem("soft", "clump", std::nan("")), HasSubstr("a number, not nan"));
  EXPECT_THAT(problem("soft", "stretch", 1.0), HasSubstr("'stretch' of technique 'soft' is a float2"));
}

}  // namespace
}  // namespace penumbra::techniques
