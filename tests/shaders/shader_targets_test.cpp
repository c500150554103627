// Tests what the package's passes ask of Unity's #pragma target: below 4.5 Unity compiles them for Shader
// Model 4, which has neither gathers nor searches for bits.
#include <gmock/gmock.h>

#include <glslang/SPIRV/GLSL.std.450.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "shaders/package_shader.h"
#include "spirv/words.h"

namespace penumbra::shaders {
namespace {

namespace fs = std::filesystem;

using Keywords = std::vector<std::string>;

// The text of the pass's program, by the file's own text.
std::string program_text(const fs::path& file, const std::string& pass) {
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t begin = text.find("Name \"" + pass + "\"");
  return text.substr(begin, text.find("ENDHLSL", begin) - begin);
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

// The sets are no keyword, and each keyword alone.
std::set<Keywords> keyword_sets(const std::string& text) {
  std::set<Keywords> sets{{}};
  const std::regex line("#pragma multi_compile_local_fragment ([^\n]*)");
  for (std::sregex_iterator match(text.begin(), text.end(), line); match != std::sregex_iterator(); ++match)
    for (const std::string& word : words_of((*match)[1]))
      if (word != "_") sets.insert({word});
  return sets;
}

// The highest target of the lines that hold for these keywords; Unity's default is 2.5.
double target_of(const std::string& text, const Keywords& keywords) {
  double highest = 2.5;
  const std::regex line("#pragma target ([0-9.]+)([^\n]*)");
  for (std::sregex_iterator match(text.begin(), text.end(), line); match != std::sregex_iterator(); ++match) {
    const std::vector<std::string> of = words_of((*match)[2]);
    const bool holds = of.empty() || std::any_of(of.begin(), of.end(), [&](const std::string& word) {
                         return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
                       });
    if (holds) highest = std::max(highest, std::stod((*match)[1]));
  }
  return highest;
}

bool needs_shader_model_5(const std::vector<std::uint32_t>& module) {
  bool needs = false;
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    const spv::Op op = spirv::opcode(instruction);
    needs = needs || op == spv::OpImageGather || op == spv::OpImageDrefGather;
    if (op != spv::OpExtInst) return;
    const std::uint32_t function = spirv::operand(instruction, 4);
    needs = needs || function == GLSLstd450FindILsb || function == GLSLstd450FindSMsb ||
            function == GLSLstd450FindUMsb;
  });
  return needs;
}

TEST(ShaderTargets, AreThoseThatTheProgramsNeed) {
  int needing = 0;
  for (const char* name : {"PenumbraShadows.shader", "PenumbraMaps.shader", "PenumbraDebugViews.shader"}) {
    const fs::path file = package_shader_file().parent_path() / name;
    const PackageShader shader(file);
    for (const std::string& pass : shader.pass_names()) {
      const std::string text = program_text(file, pass);
      for (const Keywords& keywords : keyword_sets(text)) {
        CompileRequest request = shader.request(pass, hlsl::Stage::fragment, keywords, true);
        const CompileResult result = compile(request);
        ASSERT_FALSE(result.spirv.empty()) << name << ", " << pass;
        if (!needs_shader_model_5(result.spirv)) continue;
        ++needing;
        EXPECT_GE(target_of(text, keywords), 4.5)
            << name << ", " << pass << " " << testing::PrintToString(keywords);
      }
    }
  }
  EXPECT_GE(needing, 7);
}

}  // namespace
}  // namespace penumbra::shaders
