// Tests one technique as one file: the compiler makes of it what it makes of the library's files.
#include "techniques/single_file.h"

#include <gmock/gmock.h>

#include <set>

#include "input/input_error_matcher.h"
#include "platform/data_directory.h"
#include "shaders/shader_files.h"
#include "techniques/technique_call.h"

namespace penumbra::techniques {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kCaller = R"(
ShadowTile _Tile;
float4 Fragment(float4 position : SV_Position, float3 shadowCoord : TEXCOORD0, float2 depthGradient : TEXCOORD1,
                nointerpolation float3 rotationAndCascade : TEXCOORD2) : SV_Target
{
    ShadowReceiver receiver;
    receiver.shadowCoord = shadowCoord;
    receiver.depthGradient = depthGradient;
    receiver.rotation = rotationAndCascade.xy;
    return ResolveTechnique(receiver, _Tile, int(rotationAndCascade.z));
}
)";

// The module is that before optimisation, with the names of functions.
std::vector<std::uint32_t> module_of(const std::string& text,
                                     const std::vector<std::filesystem::path>& directories,
                                     const std::vector<std::string>& keywords) {
  shaders::CompileRequest request;
  request.file = "Caller.hlsl";
  request.text = text + kCaller;
  request.entry = "Fragment";
  request.stage = hlsl::Stage::fragment;
  request.include_directories = directories;
  for (const std::string& keyword : keywords) request.defines.emplace_back(keyword, "1");
  request.optimise = false;
  const shaders::CompileResult result = shaders::compile(request);
  for (const hlsl::Diagnostic& said : result.diagnostics)
    if (said.severity == hlsl::Severity::error) ADD_FAILURE() << hlsl::format(said);
  return result.spirv;
}

std::string text_of(const std::string& technique) {
  static const TechniqueList list = read_own_techniques();
  return single_file(list, list.find(technique), "1.2.3").text;
}

// Techniques that differ in values alone have one program.
TEST(SingleFile, IsTheSameProgramAsTheLibrarysFiles) {
  const TechniqueList list = read_own_techniques();
  std::set<std::string> programs;
  for (const Technique& technique : list.techniques) {
    if (technique.graph.filter_pass() == nullptr) continue;
    const std::string text = single_file(list, technique, "1.2.3").text;
    EXPECT_THAT(text, Not(HasSubstr("#include"))) << technique.name;
    const std::string source = emit_technique_call(list, technique).source();
    if (!programs.insert(source).second) continue;
    for (const std::vector<std::string>& keywords :
         {std::vector<std::string>{}, {"UNITY_REVERSED_Z", "PENUMBRA_UNLIMITED"}}) {
      const std::vector<std::uint32_t> alone = module_of(text, {}, keywords);
      EXPECT_FALSE(alone.empty()) << technique.name;
      std::vector<std::string> all = technique.keywords;
      all.insert(all.end(), keywords.begin(), keywords.end());
      EXPECT_TRUE(alone == module_of(source, list.include_directories(), all)) << technique.name;
    }
  }
  EXPECT_GT(programs.size(), 30U);
}

TEST(SingleFile, SaysWhatToBindWithUnits) {
  const std::string text = text_of("pcss-angular-24-16");
  EXPECT_THAT(text,
              AllOf(testing::StartsWith("// Penumbra 1.2.3: the technique pcss-angular-24-16"),
                    HasSubstr("\n//   _ShadowMap: the shadow map's stored depths"),
                    HasSubstr("\n//   sampler_PointClamp: "),
                    HasSubstr("\n//   float4 _PenumbraPcssAngularParameters0:\n"
                              "//     x: blockerSamples = 24; fetches: samples of the blocker search")));
  EXPECT_THAT(text, HasSubstr("m: largest penumbra width"));
  EXPECT_THAT(
      text_of("moments-32"),
      HasSubstr("_PenumbraMomentsTexture: rgba32f, written by MapColumns of Shaders/PenumbraMaps.shader"));
}

TEST(SingleFile, HasTheLicencesOfWhatIsInIt) {
  const std::string plain = text_of("tent-5");
  EXPECT_THAT(plain, AllOf(HasSubstr("// MIT License"), HasSubstr("The Penumbra authors"),
                           Not(HasSubstr("Apache")), Not(HasSubstr("Godot Engine"))));
  EXPECT_THAT(text_of("godot-pcss-8"),
              AllOf(HasSubstr("Godot Engine contributors"), Not(HasSubstr("Apache"))));
  EXPECT_THAT(text_of("filament-pcss-16-16"),
              HasSubstrs("The Android Open Source Project", "END OF TERMS AND CONDITIONS"));
}

// The harness that measures a copy includes files of the library, too.
TEST(SingleFile, TheLibrarysFilesMayFollowIt) {
  const TechniqueList list = read_own_techniques();
  const std::string text = text_of("pcss-angular-24-16") +
                           "#include \"Core/ShadowStructs.hlsl\"\n"
                           "#include \"Core/Disk.hlsl\"\n#include \"Core/CascadeSelection.hlsl\"\n";
  EXPECT_THAT(module_of(text, list.include_directories(), {}), Not(IsEmpty()));
}

class OwnSingleFile : public testing::Test {
 protected:
  std::string text(const std::string& hlsl) const {
    files_.write("Own.hlsl", hlsl);
    const TechniqueList list = read_technique_list(files_.write("own.technique.json", R"({"techniques": [
      {"name": "own", "title": "Own", "family": "own", "source": "a test", "keywords": ["_OWN"],
       "filter": {"file": "Own.hlsl", "function": "FilterOwn"}}]})"));
    return single_file(list, list.find("own"), "1.2.3").text;
  }

  std::string refusal(const std::string& hlsl) const {
    return input_error_of([&] { (void)text(hlsl); });
  }

  shaders::ShaderFiles files_;
};

TEST_F(OwnSingleFile, PastesEachFileOnceAndBeforeTheOneThatIncludesIt) {
  files_.write("A.hlsl", "#pragma once\n#include \"B.hlsl\"\nfloat a;\n");
  files_.write(
      "B.hlsl",
      "#ifndef B\n#define B\n#include \"A.hlsl\"\n#if C\nfloat c;\n#else\nfloat b;\n#endif\n#endif\n");
  const std::string made = text(
      "// Own.\n  # include <A.hlsl> // \"A\"\n#include \"B.hlsl\"\n\n\n/* #include \"C.hlsl\" */\nfloat "
      "own;\n");
  EXPECT_THAT(made, HasSubstr("#define _OWN 1\n"));
  EXPECT_THAT(made, HasSubstr("\n// ---- B.hlsl\n#define B\n#if C\nfloat c;\n#else\nfloat b;\n#endif\n"
                              "\n// ---- A.hlsl\nfloat a;\n"
                              "\n// ---- Own.hlsl\n// Own.\n\n/* #include \"C.hlsl\" */\nfloat own;\n"));
  EXPECT_THAT(made, Not(HasSubstr(files_.path("").string()))) << "no folder of this machine";
}

TEST_F(OwnSingleFile, IncludesOfOtherPackagesStay) {
  const std::string core =
      "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl\"\n";
  EXPECT_THAT(text(core), HasSubstr(core));
  EXPECT_THAT(text("#include \"Packages/com.penumbra.shadows/ShaderLibrary/Core/Disk.hlsl\"\n"),
              HasSubstr("// ---- ShaderLibrary/Core/Disk.hlsl\n"));
}

TEST_F(OwnSingleFile, WhatCannotBePastedIsRefusedAtItsLine) {
  files_.write("A.hlsl", "float a;\n");
  EXPECT_THAT(refusal("\n#if defined(X)\n#include \"A.hlsl\"\n#endif\n"),
              HasSubstrs("Own.hlsl:3: ", "in a condition"));
  EXPECT_THAT(refusal("#include \"None.hlsl\"\n"), HasSubstr("Own.hlsl:1: "));
  EXPECT_THAT(refusal("#include NAME\n"), HasSubstrs("Own.hlsl:1: ", "of a macro"));
  const TechniqueList list = read_own_techniques();
  EXPECT_THROW((void)single_file(list, list.find("tiled-pcss"), "1.2.3"), InputError);
}

}  // namespace
}  // namespace penumbra::techniques
