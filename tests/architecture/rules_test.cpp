// Each rule is shown to hold for this repository, and to fail for a small tree that breaks it.
#include "architecture/rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "architecture/repository.h"

namespace penumbra::architecture {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Tree& repository() {
  static const Tree tree = read_repository(PENUMBRA_SOURCE_DIR);
  return tree;
}

TEST(Repository, IsReadWhole) {
  EXPECT_TRUE(repository().contains("tools/measurement/scene/scene.h"));
  EXPECT_TRUE(repository().contains("tools/measurement/scene/CMakeLists.txt"));
  EXPECT_TRUE(repository().contains("ShaderLibrary/Shadows.hlsl"));
}

TEST(Repository, ToolIncludesPointDown) {
  EXPECT_THAT(tool_includes_point_down(repository()), IsEmpty());
}
TEST(Repository, ToolLinksPointDown) {
  EXPECT_THAT(tool_links_point_down(repository()), IsEmpty());
}
TEST(Repository, ShaderIncludesPointDown) {
  EXPECT_THAT(shader_includes_point_down(repository()), IsEmpty());
}
TEST(Repository, SystemHeadersStayInPlatform) {
  EXPECT_THAT(system_headers_stay_in_platform(repository()), IsEmpty());
}
TEST(Repository, PublicHeadersStayLight) {
  EXPECT_THAT(public_headers_stay_light(repository()), IsEmpty());
}
TEST(Repository, NothingIsUnfinished) {
  EXPECT_THAT(nothing_is_unfinished(repository()), IsEmpty());
}
TEST(Repository, NothingNamesAMachine) {
  EXPECT_THAT(nothing_names_a_machine(repository()), IsEmpty());
}

TEST(ToolIncludes, UpwardOnesAreFound) {
  EXPECT_THAT(tool_includes_point_down(
                  {{"tools/measurement/scene/a.cpp", "#include <vector>\n#include \"study/report.h\"\n"}}),
              ElementsAre("tools/measurement/scene/a.cpp:2: scene must not include study/report.h"));
  EXPECT_THAT(tool_includes_point_down(
                  {{"tools/measurement/scene/a.cpp", "#include \"scene/b.h\"\n#include \"gpu/device.h\"\n"}}),
              IsEmpty());
}

TEST(ToolIncludes, ParametersAndShadersDoNotKnowEachOther) {
  EXPECT_THAT(
      tool_includes_point_down({{"tools/programs/shaders/a.h", "#include \"parameters/cascades.h\"\n"}}),
      ElementsAre("tools/programs/shaders/a.h:1: shaders must not include parameters/cascades.h"));
  EXPECT_THAT(tool_includes_point_down({{"tools/base/parameters/a.h", "#include \"input/input_error.h\"\n"}}),
              IsEmpty());
}

TEST(ToolIncludes, MeasurementAndCheckingDoNotKnowEachOther) {
  EXPECT_THAT(
      tool_includes_point_down({{"tools/measurement/study/a.h", "#include \"validation/report.h\"\n"}}),
      ElementsAre("tools/measurement/study/a.h:1: study must not include validation/report.h"));
  EXPECT_THAT(tool_includes_point_down({{"tools/checking/cost/a.h", "#include \"scene/scene.h\"\n"}}),
              ElementsAre("tools/checking/cost/a.h:1: cost must not include scene/scene.h"));
}

TEST(ToolIncludes, RoomsWithoutAPlaceAndWaysAroundAreFound) {
  EXPECT_THAT(tool_includes_point_down({{"tools/base/scene/a.h", "#include <vector>\n"},
                                        {"tools/scene/a.h", "#include <vector>\n"}}),
              ElementsAre("tools/base/scene/a.h:1: scene belongs into tools/measurement",
                          "tools/scene/a.h:1: scene belongs into tools/measurement"));
  EXPECT_THAT(tool_includes_point_down({{"tools/helpers/a.h", "#include <vector>\n"}}),
              ElementsAre("tools/helpers/a.h:1: 'helpers' has no place in the order of rooms"));
  EXPECT_THAT(tool_includes_point_down({{"tools/programs/gpu/a.h", "#include \"../study/report.h\"\n"}}),
              ElementsAre("tools/programs/gpu/a.h:1: names a room by '..'; name it from tools/"));
}

TEST(ToolLinks, UpwardOnesAreFoundInUsesAndAsTargets) {
  EXPECT_THAT(tool_links_point_down({{"tools/programs/gpu/CMakeLists.txt",
                                      "penumbra_room(gpu\n  SOURCES study.cpp\n  USES shaders\n       scene\n"
                                      "  PRIVATE_LIBRARIES Vulkan::Vulkan)\n"}}),
              ElementsAre("tools/programs/gpu/CMakeLists.txt:4: gpu must not link scene"));
  EXPECT_THAT(tool_links_point_down({{"tools/base/input/CMakeLists.txt",
                                      "target_link_libraries(penumbra_input PUBLIC penumbra::platform)\n"}}),
              ElementsAre("tools/base/input/CMakeLists.txt:1: input must not link platform"));
  EXPECT_THAT(tool_links_point_down({{"tools/cli/CMakeLists.txt", "penumbra_room(cli USES study input)\n"}}),
              IsEmpty());
}

TEST(ShaderIncludes, UpwardAndSidewardOnesAreFound) {
  const auto check = [](const std::string& path, const std::string& target) {
    return shader_includes_point_down({{path, "#include \"" + target + "\"\n"}});
  };
  EXPECT_THAT(check("ShaderLibrary/Core/A.hlsl", "../Filters/B.hlsl"),
              ElementsAre("ShaderLibrary/Core/A.hlsl:1: must not include ShaderLibrary/Filters/B.hlsl"));
  EXPECT_THAT(check("ShaderLibrary/Filters/A.hlsl", "../Screen/B.hlsl"), testing::SizeIs(1));
  EXPECT_THAT(check("ShaderLibrary/Filters/A.hlsl", "../Shadows.hlsl"), testing::SizeIs(1));
  EXPECT_THAT(check("ShaderLibrary/Pipelines/A.hlsl", "Packages/com.penumbra.shadows/Shaders/B.hlsl"),
              testing::SizeIs(1));
  EXPECT_THAT(check("ShaderLibrary/Core/A.hlsl", "../Utils/B.hlsl"), testing::SizeIs(1));
  EXPECT_THAT(check("ShaderLibrary/Core/A.hlsl", "../../tests/B.hlsl"), testing::SizeIs(1));
  EXPECT_THAT(check("ShaderLibrary/Filters/A.hlsl", "../Core/B.hlsl"), IsEmpty());
  EXPECT_THAT(check("ShaderLibrary/Filters/A.hlsl", "B.hlsl"), IsEmpty());
  EXPECT_THAT(check("ShaderLibrary/Shadows.hlsl", "Pipelines/Urp.hlsl"), IsEmpty());
}

TEST(SystemHeaders, OutsidePlatformAreFound) {
  const std::string text = "#include <cstdio>\n#include <unistd.h>\n#include <sys/stat.h>\n";
  EXPECT_THAT(system_headers_stay_in_platform({{"tools/cli/a.cpp", text}}), testing::SizeIs(2));
  EXPECT_THAT(system_headers_stay_in_platform({{"tools/base/platform/a.cpp", text}}), IsEmpty());
}

TEST(PublicHeaders, HeavyOnesAreFoundThroughOtherHeaders) {
  Tree tree{{"tools/programs/gpu/device.h", "#include \"gpu/state.h\"\n"},
            {"tools/programs/gpu/state.h", "#include <vulkan/vulkan.h>\n"},
            {"tools/programs/gpu/device.cpp", "#include \"gpu/device.h\"\n"},
            {"tests/gpu/device_test.cpp", "#include \"gpu/state.h\"\n"}};
  EXPECT_THAT(public_headers_stay_light(tree), IsEmpty()) << "a room's own affair";
  tree["tools/measurement/scene/frame.cpp"] = "#include \"gpu/device.h\"\n";
  EXPECT_THAT(
      public_headers_stay_light(tree),
      ElementsAre(
          "tools/programs/gpu/state.h:1: <vulkan/vulkan.h> reaches every room that includes gpu/device.h"));
}

TEST(PublicHeaders, LocatedJsonAloneMayOfferJson) {
  const Tree tree{{"tools/base/input/located_json.h", "#include <nlohmann/json.hpp>\n"},
                  {"tools/base/input/other.h", "#include <nlohmann/json.hpp>\n"},
                  {"tools/cli/a.cpp", "#include \"input/located_json.h\"\n#include \"input/other.h\"\n"}};
  EXPECT_THAT(
      public_headers_stay_light(tree),
      ElementsAre(
          "tools/base/input/other.h:1: <nlohmann/json.hpp> reaches every room that includes input/other.h"));
}

TEST(PublicHeaders, OfSpirvAloneMayOfferItsEnumerations) {
  const Tree tree{{"tools/programs/spirv/words.h", "#include <glslang/SPIRV/spirv.hpp>\n"},
                  {"tools/programs/shaders/module.h", "#include \"spirv/words.h\"\n"},
                  {"tools/programs/shaders/a.cpp", "#include \"spirv/words.h\"\n"},
                  {"tools/checking/cost/a.cpp", "#include \"shaders/module.h\"\n"}};
  EXPECT_THAT(
      public_headers_stay_light(tree),
      ElementsAre(
          "tools/programs/spirv/words.h:1: <glslang/SPIRV/spirv.hpp> reaches every room that includes "
          "shaders/module.h"));
}

TEST(Words, OfUnfinishedWorkAreFound) {
  const std::string mark = std::string("TO") + "DO";
  EXPECT_THAT(nothing_is_unfinished({{"a.md", "fine\n// " + mark + ": later\n"}}),
              ElementsAre("a.md:2: unfinished: " + mark));
  EXPECT_THAT(nothing_is_unfinished({{"a.md", "MA" + mark + "R, todo list\n"}}), IsEmpty());
}

TEST(Words, OfMachinesAreFound) {
  const std::string home = std::string("/ho") + "me/";
  EXPECT_THAT(nothing_names_a_machine({{"a.sh", "cd " + home + "someone\n"}}), testing::SizeIs(1));
  EXPECT_THAT(nothing_names_a_machine(
                  {{"a.json", "\"resolved\": \"https://registry.npm" + std::string("js.org/x\"\n")}}),
              testing::SizeIs(1));
  EXPECT_THAT(nothing_names_a_machine({{"a.md", "see ../" + home.substr(1) + " and docs/work/x\n"}}),
              IsEmpty());
}

}  // namespace
}  // namespace penumbra::architecture
