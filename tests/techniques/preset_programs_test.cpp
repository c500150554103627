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
  for (const char* preset : {"preset-low", "preset-high", "preset-reference"}) {
    const std::vector<PresetProgram> those = programs(preset);
    ASSERT_THAT(passes_of(those), ElementsAre("Resolve", "Resolve"))
        << "kernels are no programs of the shader; those of its fallbacks, none twice";
    EXPECT_THAT(those[0].keywords, ElementsAre("_PENUMBRA_PCSS_BOUNDED")) << preset;
    EXPECT_THAT(those[1].keywords, ElementsAre("_PENUMBRA_TENT_7X7")) << "below shader target 4.5";
  }
}

TEST(PresetPrograms, APassHasTheKeywordsThatItDeclares) {
  const std::vector<PresetProgram> masked = programs("screen-pcss-angular-24-16-masked");
  ASSERT_THAT(passes_of(masked),
              ElementsAre("PenumbraMask", "MaskBlurHorizontal", "MaskBlurVertical", "Resolve", "Resolve"));
  for (std::size_t pass = 0; pass < 3; ++pass) EXPECT_THAT(masked[pass].keywords, IsEmpty());
  EXPECT_THAT(masked[3].keywords, ElementsAre("_PENUMBRA_PCSS"));
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
