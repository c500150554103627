#include "shaders/target_problems.h"

#include <glslang/SPIRV/GLSL.std.450.h>
#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "hlsl/tokens.h"
#include "shaders/module_search.h"

namespace penumbra::shaders {

namespace {

template <typename Condition>
std::vector<Target> targets_of(Condition condition) {
  std::vector<Target> targets;
  std::copy_if(std::begin(all_targets), std::end(all_targets), std::back_inserter(targets), condition);
  return targets;
}

std::vector<Target> all_but_metal() {
  return targets_of([](Target target) { return target_language(target) != TargetLanguage::msl; });
}

std::vector<Target> of_language(TargetLanguage language) {
  return targets_of([=](Target target) { return target_language(target) == language; });
}

bool is_wave_operation(spv::Op op) {
  return (op >= spv::OpGroupNonUniformElect && op <= spv::OpGroupNonUniformQuadSwap) ||
         (op >= spv::OpSubgroupBallotKHR && op <= spv::OpSubgroupReadInvocationKHR);
}

class WaveOperations final : public ModuleSearch {
 public:
  using ModuleSearch::ModuleSearch;

 private:
  void visit(spirv::Words instruction) override {
    if (is_wave_operation(spirv::opcode(instruction)))
      report(
          "wave functions need shader model 6.0, which neither Direct3D 11 nor OpenGL has: leave these APIs "
          "out with #pragma exclude_renderers, or call them only under Vulkan and Metal");
  }
};

class Interpolations final : public ModuleSearch {
 public:
  using ModuleSearch::ModuleSearch;

 private:
  void visit(spirv::Words instruction) override {
    if (spirv::opcode(instruction) != spv::OpExtInst) return;
    const std::uint32_t operation = spirv::operand(instruction, 4);
    if (operation >= GLSLstd450InterpolateAtCentroid && operation <= GLSLstd450InterpolateAtOffset)
      report(
          "the EvaluateAttribute functions need OpenGL ES 3.2: leave gles3 out with "
          "#pragma exclude_renderers, or declare the input 'centroid' or 'sample'");
  }
};

class DerivativeKinds final : public ModuleSearch {
 public:
  using ModuleSearch::ModuleSearch;

 private:
  void visit(spirv::Words instruction) override {
    const spv::Op op = spirv::opcode(instruction);
    if (op >= spv::OpDPdxFine && op <= spv::OpFwidthCoarse)
      report(
          "OpenGL ES has no fine and coarse derivatives: write ddx and ddy, or leave gles3 out with "
          "#pragma exclude_renderers");
  }
};

// Collects the names of the uniform buffers that are arrays.
class BufferArrays {
 public:
  std::set<std::string> run(const SpirvModule& module) {
    spirv::for_each_instruction(module, [this](spirv::Words instruction) { visit(instruction); });
    return std::move(found_);
  }

 private:
  void visit(spirv::Words words) {
    if (words.size() < 3) return;
    switch (spirv::opcode(words)) {
      case spv::OpName:
        names_[words[1]] = spirv::literal_text(words.subspan(2));
        break;
      case spv::OpDecorate:
        if (words[2] == spv::DecorationBlock) blocks_.insert(words[1]);
        break;
      case spv::OpTypeArray:
        if (blocks_.contains(words[2])) arrays_.insert(words[1]);
        break;
      case spv::OpTypePointer:
        if (words[2] == spv::StorageClassUniform && arrays_.contains(spirv::operand(words, 3)))
          pointers_.insert(words[1]);
        break;
      case spv::OpVariable:
        if (pointers_.contains(words[1])) found_.insert(names_[words[2]]);
        break;
      default:
        break;
    }
  }

  std::map<std::uint32_t, std::string> names_;
  std::set<std::uint32_t> blocks_;
  std::set<std::uint32_t> arrays_;
  std::set<std::uint32_t> pointers_;
  std::set<std::string> found_;
};

// Finds the first `> name[`.
SourcePlace declaration_of(const std::string& name, const std::string& text, const std::string& file) {
  const std::vector<hlsl::Token> tokens = hlsl::lex(text);
  for (std::size_t at = 1; at + 1 < tokens.size(); ++at)
    if (tokens[at].spelling == name && tokens[at - 1].spelling == ">" && tokens[at + 1].spelling == "[")
      return {tokens[at].file.empty() ? file : std::string(tokens[at].file), tokens[at].line};
  return {};
}

}  // namespace

std::vector<TargetProblem> target_problems(const SpirvModule& module, const std::string& text,
                                           const std::string& file) {
  std::vector<TargetProblem> problems;
  for (hlsl::Diagnostic& problem : WaveOperations(module).run())
    problems.push_back({all_but_metal(), std::move(problem)});
  for (hlsl::Diagnostic& problem : Interpolations(module).run())
    problems.push_back({of_language(TargetLanguage::essl), std::move(problem)});
  for (hlsl::Diagnostic& problem : DerivativeKinds(module).run())
    problems.push_back({of_language(TargetLanguage::essl), std::move(problem)});
  for (const std::string& name : BufferArrays().run(module))
    problems.push_back(
        {{Target::hlsl50},
         error_at(
             declaration_of(name, text, file),
             "'" + name +
                 "' is an array of constant buffers, which needs shader model 5.1, and Direct3D 11 has 5.0: "
                 "declare one cbuffer with an array in it")});
  return problems;
}

}  // namespace penumbra::shaders
