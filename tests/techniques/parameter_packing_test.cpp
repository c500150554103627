// Tests where each field lies in the vectors, and that the emitted texts say the same.
#include "techniques/parameter_packing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "techniques/parameter_emit.h"

namespace penumbra::techniques {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ParameterStruct mixed() {
  return {"MixedParameters",
          "A bit of everything.",
          {{"count", "int", "fetches", "number of taps", ParameterRange{1, 64}, {8.0}},
           {"offset", "float2", "texels", "of the kernel", std::nullopt, {}},
           {"plane", "float4", "m", "where it ends", std::nullopt, {}},
           {"width", "float", "m", "how wide", ParameterRange{0, 1e6}, {2.5}},
           {"centre", "float2", "1", "between 0 and 1", ParameterRange{0, 1}, {}},
           {"bias", "float2", "1", "of the depth", std::nullopt, {}}},
          "ShaderLibrary/Filters/Mixed.technique.json"};
}

TEST(ParameterPacking, AFieldThatDoesNotFitBeginsTheNextVector) {
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (const PackedPlace& place : packed_places(mixed())) places.emplace_back(place.vector, place.component);
  using P = std::pair<std::size_t, std::size_t>;
  EXPECT_THAT(places, ElementsAre(P{0, 0}, P{0, 1}, P{1, 0}, P{2, 0}, P{2, 1}, P{3, 0}));
  EXPECT_EQ(vector_count(mixed()), 4U);
  EXPECT_EQ(uniform_name(mixed(), 3), "_PenumbraMixedParameters3");
}

TEST(ParameterPacking, NumbersAreWhereTheShaderReadsThem) {
  const auto vectors = packed(mixed(), {{"count", {5.0}},
                                        {"offset", {6.0, 7.0}},
                                        {"plane", {8.0, 9.0, 10.0, 11.0}},
                                        {"width", {12.0}},
                                        {"centre", {0.25, 0.5}},
                                        {"bias", {13.0, 14.0}}});
  using V = std::array<float, 4>;
  EXPECT_THAT(vectors, ElementsAre(V{5, 6, 7, 0}, V{8, 9, 10, 11}, V{12, 0.25F, 0.5F, 0}, V{13, 14, 0, 0}));
  EXPECT_THROW((void)packed(mixed(), {}), std::out_of_range);
}

TEST(ParameterPacking, TheHlslUnpacksIt) {
  const EmittedFile hlsl = emit_hlsl(mixed());
  EXPECT_EQ(hlsl.file, "ShaderLibrary/Filters/Parameters/MixedParameters.hlsl");
  EXPECT_THAT(hlsl.text, HasSubstr("#ifndef PENUMBRA_MIXED_PARAMETERS_HLSL\n"));
  EXPECT_THAT(hlsl.text, HasSubstr("    // fetches: number of taps\n    int count;\n    // texels: of the "
                                   "kernel\n    float2 offset;\n"));
  EXPECT_THAT(hlsl.text, HasSubstr("MixedParameters UnpackMixedParameters(float4 packed0, float4 packed1, "
                                   "float4 packed2, float4 packed3)\n"));
  EXPECT_THAT(hlsl.text, HasSubstr("    parameters.count = int(packed0.x);\n"
                                   "    parameters.offset = packed0.yz;\n"
                                   "    parameters.plane = packed1.xyzw;\n"
                                   "    parameters.width = packed2.x;\n"
                                   "    parameters.centre = packed2.yz;\n"
                                   "    parameters.bias = packed3.xy;\n"));
}

TEST(ParameterPacking, TheHlslsCommentsAreWrapped) {
  ParameterStruct many = mixed();
  for (int i = 0; i < 40; ++i) many.fields.front().doc += " word" + std::to_string(i);
  std::istringstream lines(emit_hlsl(many).text);
  int comments = 0;
  for (std::string line; std::getline(lines, line); comments += line.starts_with("    // ") ? 1 : 0)
    EXPECT_LE(line.size(), 120U) << line;
  EXPECT_EQ(comments, static_cast<int>(many.fields.size()) + 2) << "the first has three";
}

TEST(ParameterPacking, TheCSharpPacksItWithinTheRanges) {
  const EmittedFile csharp = emit_csharp({mixed(), mixed()}, "TwoParameters");
  EXPECT_EQ(csharp.file, "Runtime/Parameters/TwoParameters.cs");
  EXPECT_THAT(csharp.text, HasSubstr("[Tooltip(\"Number of taps. Unit: fetches.\"), Range(1, 64)] "
                                     "public int count;\n"));
  EXPECT_THAT(csharp.text, HasSubstr("public Vector2 offset;"));
  EXPECT_THAT(csharp.text,
              HasSubstr("public Vector4 Vector0 => new Vector4(Bounded.Count(count, 1, 64),\n            "));
  EXPECT_THAT(csharp.text, HasSubstr("Bounded.OrLow(centre.y, 0.0f, 1.0f)"));
  EXPECT_THAT(csharp.text, HasSubstr("            { count = 8, offset = new Vector2(0.0f, 0.0f),"));
}

}  // namespace
}  // namespace penumbra::techniques
