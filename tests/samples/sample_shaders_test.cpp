// The samples' shaders, and README's example of one, compile for every target and keyword, without a finding
// of the lint rules: the custom pipeline's as it is, which needs nothing of Unity's, those of URP with
// stand-ins for the URP files that they include.
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/program.h"

namespace penumbra {
namespace {

using testing::IsEmpty;

const std::string kSource = PENUMBRA_SOURCE_DIR;
const std::string kSunLit = kSource + "/Samples~/CustomPipeline/Shaders/SunLit.shader";
const std::string kForwardLit = kSource + "/Samples~/ForwardShader/Shaders/ForwardLit.shader";

class SampleShaders : public ProgramTest {
 protected:
  nlohmann::json validate(const std::string& shader, const std::vector<std::string>& more = {}) const {
    const std::string unity = kSource + "/tests/samples/unity/com.unity.render-pipelines.";
    std::vector<std::string> command{"validate", shader, "--no-cache", "--format", "json"};
    command.insert(command.end(), {"-o", path("report.json").string()});
    command.insert(command.end(), {"--package-root", "com.penumbra.shadows=" + kSource});
    for (const char* part : {"core", "universal"}) {
      command.insert(command.end(), {"--package-root",
                                     std::string("com.unity.render-pipelines.") + part + "=" + unity + part});
    }
    command.insert(command.end(), more.begin(), more.end());
    const platform::ChildResult result = run(command);
    EXPECT_EQ(result.exit_code, 0) << result.output << result.errors;
    return nlohmann::json::parse(read("report.json"));
  }
};

// Errors, and warnings of the lint rules, each once. A driver warns of emitted GLSL's own temporaries, and
// only where it has not compiled the same text before.
std::set<std::string> findings(const nlohmann::json& report) {
  std::set<std::string> messages;
  for (const nlohmann::json& variant : report["variants"]) {
    for (const nlohmann::json& message : variant.value("diagnostics", nlohmann::json::array())) {
      if (message.at("severity") == "error" || message.contains("rule")) messages.insert(message.dump());
    }
  }
  return messages;
}

std::set<std::string> passes(const nlohmann::json& report) {
  std::set<std::string> names;
  for (const nlohmann::json& variant : report["variants"]) {
    if (variant.contains("pass")) names.insert(variant["pass"]);
  }
  return names;
}

TEST_F(SampleShaders, TheCustomPipelinesCompileForEveryTarget) {
  const nlohmann::json report = validate(kSunLit);
  EXPECT_EQ(passes(report), (std::set<std::string>{"SunLit", "ShadowCaster"}));
  EXPECT_EQ(report["summary"]["variants"], 2 * 2 * 5);
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_THAT(findings(report), IsEmpty());
}

TEST_F(SampleShaders, TheForwardShaderCompilesForEveryTechniqueShadowAndLight) {
  // What the stand-ins do not tell apart is left out.
  const nlohmann::json report = validate(
      kForwardLit,
      {"--keywords=-FOG_EXP", "--keywords=-FOG_EXP2", "--keywords=-FOG_LINEAR", "--keywords=-INSTANCING_ON"});
  EXPECT_EQ(passes(report),
            (std::set<std::string>{"ForwardLit", "ShadowCaster", "DepthOnly", "DepthNormals"}));
  const int forward = 1 + 6 * 4 * 2 * 2 * 2, caster = 2 + 1, depth = 1 + 1, normals = 1 + 2;
  EXPECT_EQ(report["summary"]["variants"], (forward + caster + depth + normals) * 5);
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_THAT(findings(report), IsEmpty());
}

// README's first block of HLSL, as what its reader pastes it into.
std::string readme_shader() {
  std::ifstream file(kSource + "/README.md", std::ios::binary);
  const std::string page((std::istreambuf_iterator<char>(file)), {});
  const std::string start = "```hlsl\n";
  const std::size_t begin = page.find(start) + start.size();
  return "Shader \"Readme\" { SubShader { Pass {\nHLSLPROGRAM\n" +
         page.substr(begin, page.find("```", begin) - begin) + "ENDHLSL\n} } }\n";
}

// Each keyword that it lists changes the shader: one that does not is a finding.
TEST_F(SampleShaders, ReadmesCompilesWithAndWithoutAShadowMap) {
  write("Readme.shader", readme_shader());
  const nlohmann::json report = validate(path("Readme.shader").string());
  EXPECT_EQ(report["summary"]["variants"], (1 + 4) * 5);
  EXPECT_EQ(report["summary"]["failed"], 0);
  EXPECT_THAT(findings(report), IsEmpty());
}

}  // namespace
}  // namespace penumbra
