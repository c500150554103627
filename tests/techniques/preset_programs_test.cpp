#include "techniques/generated_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "techniques/settings_emit.h"

namespace penumbra::techniques {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::filesystem::path root = PENUMBRA_SOURCE_DIR;

TechniqueList techniques() {
  return read_technique_list(root);
}

shaders::PackageShader feature_shader() {
  return shaders::PackageShader(root / "Shaders/PenumbraShadows.shader");
}

std::vector<PresetProgram> programs(const std::string& preset) {
  const TechniqueList list = techniques();
  return programs_of(list, list.find(preset), feature_shader());
}

std::vector<std::string> passes_of(const std::vector<PresetProgram>& programs) {
  std::vector<std::string> names;
  for (const PresetProgram& program : programs) names.push_back(program.pass);
  return names;
}

TEST(PresetPrograms, ArePassesOfTheChainWithTheKeywordsTheyDeclare) {
  const std::vector<PresetProgram> high = programs("preset-high");
  EXPECT_THAT(passes_of(high),
              ElementsAre("PenumbraMask", "MaskBlurHorizontal", "MaskBlurVertical", "Resolve", "Resolve"));
  EXPECT_THAT(high[0].keywords, IsEmpty());
  EXPECT_THAT(high[3].keywords, ElementsAre("_PENUMBRA_PCSS"));
  EXPECT_THAT(high[4].keywords, ElementsAre("_PENUMBRA_TENT_7X7")) << "below shader target 4.5";
  const std::vector<PresetProgram> low = programs("preset-low");
  EXPECT_THAT(passes_of(low), ElementsAre("Resolve", "Resolve"))
      << "its own and those of its fallbacks, none twice";
  EXPECT_THAT(low[0].keywords, ElementsAre("_PENUMBRA_PCSS")) << "it filters where neighbours differ widely";
  EXPECT_THAT(low[1].keywords, ElementsAre("_PENUMBRA_TENT_7X7"));
  EXPECT_THAT(passes_of(programs("preset-reference")), ElementsAre("Resolve", "Resolve"));
}

TEST(PresetPrograms, AVariantIsOneKeywordOfEverySet) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "preset_programs.shader";
  std::ofstream(file) << "Shader \"S\" { SubShader { Pass { Name \"P\"\nHLSLPROGRAM\n#pragma vertex V\n"
                         "#pragma multi_compile_local_fragment _ A B\n#pragma multi_compile_fragment _ C\n"
                         "ENDHLSL\n} Pass { Name \"Q\"\nHLSLPROGRAM\n#pragma vertex V\nENDHLSL\n} } }\n";
  const shaders::PackageShader shader(file);
  EXPECT_EQ(shader.variant_count("P"), 6U);
  EXPECT_EQ(shader.variant_count("Q"), 1U);
  EXPECT_THAT(shader.declared("P", {"C", "D", "A"}), ElementsAre("A", "C"));
  EXPECT_THAT(shader.declared("Q", {"C", "D", "A"}), IsEmpty());
}

}  // namespace
}  // namespace penumbra::techniques
