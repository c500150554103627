// Tests rules for far cascades where a shader keyword selects the filter: the emitted HLSL and C#, and what
// both are told.
#include "techniques/technique_call.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "input/input_error_matcher.h"
#include "input/json_lines.h"
#include "shaders/compile.h"
#include "techniques/feature_tables.h"
#include "techniques/parameter_packing.h"
#include "techniques/selection_hlsl.h"

namespace penumbra::techniques {
namespace {

namespace fs = std::filesystem;

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Technique& technique_of(TechniqueList& list, const std::string& name) {
  return *std::find_if(list.techniques.begin(), list.techniques.end(),
                       [&](const Technique& technique) { return technique.name == name; });
}

// The list is the library's, with fewer samples from cascade 1 on and a tent from cascade 3 on where
// _PENUMBRA_PCSS is on.
TechniqueList with_rules() {
  TechniqueList list = read_technique_list(PENUMBRA_SOURCE_DIR);
  Technique& pcss = technique_of(list, "pcss-angular-24-16");
  const Technique tent = list.find("tent-5-plane");
  const FilterCall own = *pcss.graph.filter();
  pcss.cascades = {{1, "", own, {{"filterSamples", {5.0}}, {"maxPenumbraMetres", {2.5}}}, {}},
                   {3, tent.name, *tent.graph.filter(), {}, {}}};
  return list;
}

TEST(CascadeRules, AreBranchesOfTheirKeywordAlone) {
  const std::string text = emit_keywords_hlsl(with_rules());
  EXPECT_THAT(text, HasSubstr("#if defined(PENUMBRA_USES_PCSS)\n"
                              "float4 _PenumbraPcssAngularParameters0From1;\n"
                              "float4 _PenumbraPcssAngularParameters1From1;\n#endif\n"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "#include \"../Filters/Pcss/PcssAngular.hlsl\"\n#include \"../Filters/Fixed/TentPcf.hlsl\"\n"));
  EXPECT_THAT(text,
              HasSubstr("#elif defined(PENUMBRA_USES_PCSS)\n"
                        "    if (cascade >= 3) return FilterTent5x5Plane(TEXTURE2D_SHADOW_ARGS(shadowMap, "
                        "sampler_shadowMap), receiver, tile);\n"
                        "    if (cascade >= 1) return FilterPcssAngular(TEXTURE2D_SHADOW_ARGS(shadowMap, "
                        "sampler_shadowMap), sampler_point,\n"
                        "                                               receiver, tile,\n"
                        "                                               UnpackPcssAngularParameters("
                        "_PenumbraPcssAngularParameters0From1, _PenumbraPcssAngularParameters1From1));\n"
                        "    return FilterPcssAngular("));
  const std::size_t hdrp = text.rfind("#elif defined(PENUMBRA_USES_PCSS_HDRP)");
  EXPECT_THAT(text.substr(hdrp), Not(HasSubstr("cascade >=")));
}

TEST(CascadeRules, OfTheFilterWithoutAKeywordAreThereWithoutAny) {
  TechniqueList list = with_rules();
  technique_of(list, "pcss-angular-24-16").cascades.clear();
  const auto otherwise = std::find_if(list.selections.begin(), list.selections.end(),
                                      [](const Selection& selection) { return selection.keyword.empty(); });
  Technique& tent = technique_of(list, otherwise->technique);
  tent.cascades = {{2, "hard", *list.find("hard").graph.filter(), {}, {}}};
  EXPECT_THAT(emit_keywords_hlsl(list),
              HasSubstr("#else\n    if (cascade >= 2) return FilterHard(TEXTURE2D_SHADOW_ARGS(shadowMap, "
                        "sampler_shadowMap), receiver, tile);\n    return FilterTent5x5Plane("));
}

TEST(CascadeRules, AFilterOfRawDepthsInFarCascadesAloneIsRefused) {
  TechniqueList list = with_rules();
  const Technique& pcss = list.find("pcss-angular-24-16");
  const auto tent =
      std::find_if(list.selections.begin(), list.selections.end(),
                   [](const Selection& selection) { return selection.keyword == "_PENUMBRA_TENT_7X7"; });
  CascadeRule rule{1, pcss.name, *pcss.graph.filter(), pcss.values, {}};
  technique_of(list, tent->technique).cascades = {rule};
  expect_input_error([&] { emit_keywords_hlsl(list); },
                     HasSubstr("'Tent7x7' reads raw depths in far cascades alone"));
}

TEST(CascadeRules, WithThemTheIncludeFileCompiles) {
  const fs::path library = fs::path(PENUMBRA_SOURCE_DIR) / "ShaderLibrary";
  for (const char* keyword : {"_PENUMBRA_PCSS", "_PENUMBRA_TENT_3X3", "SHADER_API_GLES3"}) {
    shaders::CompileRequest request;
    request.file = library / "Pipelines" / "TechniqueByKeyword.hlsl";
    request.text = "#include \"../Platform/Platform.hlsl\"\n" + emit_keywords_hlsl(with_rules()) + R"(
TEXTURE2D_SHADOW(_Map);
SAMPLER_CMP(sampler_Map);
SAMPLER(sampler_PointClamp);
float4 _Coord;
int _Cascade;
float4 Fragment(float4 position : SV_Position) : SV_Target
{
    ShadowReceiver receiver = (ShadowReceiver)0;
    receiver.shadowCoord = _Coord.xyz;
    ShadowTile tile = (ShadowTile)0;
    tile.offsetScale = _Coord;
    return FilterByKeyword(TEXTURE2D_SHADOW_ARGS(_Map, sampler_Map), sampler_PointClamp, receiver, tile, _Cascade);
})";
    request.stage = hlsl::Stage::fragment;
    request.entry = "Fragment";
    request.defines = {{keyword, "1"}, {"_PENUMBRA_PCSS", "1"}};
    if (std::string(keyword) != "SHADER_API_GLES3") request.defines.pop_back();
    const shaders::CompileResult result = shaders::compile(request);
    EXPECT_FALSE(result.spirv.empty()) << keyword;
  }
}

TEST(CascadeRules, HoldWhereAPassOfAShaderCallsTheFilter) {
  const TechniqueList list = with_rules();
  EXPECT_EQ(compiled_rules(list, list.find("screen-pcss-angular-24-16")).size(), 2U) << "by its keyword";
  EXPECT_EQ(compiled_rules(list, list.find("pcss-angular-24-16")).size(), 2U);
  EXPECT_TRUE(compiled_rules(list, list.find("tent-5-plane")).empty());
  const Technique& screen = list.find("screen-pcss-angular-24-16");
  EXPECT_EQ(values_of(compiled_rules(list, screen)[0], screen).at("blockerSamples"),
            std::vector<double>{24.0});
}

TEST(CascadeRules, AreRowsOfTheirTechnique) {
  EXPECT_THAT(
      selection_rows(with_rules()),
      HasSubstr("cascade\t_PenumbraPcssAngularParameters0From1\t_PenumbraPcssAngularParameters0\t2\t24\t5\t0"
                "\t1.25\n"
                "cascade\t_PenumbraPcssAngularParameters1From1\t_PenumbraPcssAngularParameters1\t1\t2.5"
                "\t1000\t0\t0\nformat\n"));
}

// The rule's fields go over a frame's, packed as a program of this kind is measured with.
std::string golden() {
  TechniqueList list = with_rules();
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  const std::map<std::string, std::vector<double>> frame = {
      {"blockerSamples", {20.0}}, {"filterSamples", {10.0}},     {"blockerClump", {0.5}},
      {"minFilterTexels", {1.5}}, {"maxPenumbraMetres", {50.0}}, {"maxSamplingMetres", {300.0}}};
  for (const char* other : {"", "pcss-angular-24-16"}) {
    Technique technique = list.find("pcss-angular-24-16");
    CascadeRule& rule = technique.cascades.front();
    rule.technique = other;
    if (!rule.technique.empty()) rule.values.insert(technique.values.begin(), technique.values.end());
    const std::vector<CascadeVector> vectors = cascade_vectors(list, technique);
    technique.values = frame;
    const ParameterStruct& parameters = *list.find_struct("PcssAngularParameters");
    const auto expected = packed(parameters, values_of(rule, technique));
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      int own = 0;
      for (std::size_t k = 0; k < 4; ++k) own |= vectors[i].own[k] ? 1 << k : 0;
      cases.push_back({{"uniform", vectors[i].uniform},
                       {"base", vectors[i].base},
                       {"own", own},
                       {"value", vectors[i].value},
                       {"expected", expected[i]}});
    }
  }
  nlohmann::ordered_json fields = nlohmann::ordered_json::object();
  for (const auto& [name, value] : frame) fields[name] = value.front();
  return json_lines(nlohmann::ordered_json{{"frame", fields}, {"cases", cases}}.dump());
}

TEST(CascadeRules, ArePackedAsTheCheckedInCasesSay) {
  std::ifstream file(fs::path(PENUMBRA_SOURCE_DIR) / "tests/golden/cascade_rules.json", std::ios::binary);
  const std::string checked_in{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(checked_in, golden()) << "put the second text in its place";
}

}  // namespace
}  // namespace penumbra::techniques
