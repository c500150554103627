#include "shaders/hlsl_problems.h"

#include <set>

#include <glslang/Include/intermediate.h>
#include <glslang/MachineIndependent/localintermediate.h>

#include "hlsl/name_set.h"
#include "shaders/debug_lines.h"
#include "shaders/generated_words.h"
#include "shaders/module_problems.h"
#include "shaders/spirv_module.h"
#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {

namespace {

// Returns the operation's name in HLSL; nullptr if it needs no derivatives.
const char* name_of(glslang::TOperator op) {
  using namespace glslang;
  if (hlsl::is_one_of(op, {EOpTexture, EOpTextureOffset, EOpTextureProj, EOpTextureProjOffset,
                           EOpTextureClamp, EOpTextureOffsetClamp}))
    return "Sample";
  if (op == EOpTextureQueryLod) return "CalculateLevelOfDetail";
  if (hlsl::is_one_of(op, {EOpDPdx, EOpDPdxFine, EOpDPdxCoarse})) return "ddx";
  if (hlsl::is_one_of(op, {EOpDPdy, EOpDPdyFine, EOpDPdyCoarse})) return "ddy";
  return hlsl::is_one_of(op, {EOpFwidth, EOpFwidthFine, EOpFwidthCoarse}) ? "fwidth" : nullptr;
}

class DerivativeSearch final : public glslang::TIntermTraverser {
 public:
  explicit DerivativeSearch(std::string stage) : stage_(std::move(stage)) {}

  bool visitAggregate(glslang::TVisit /*when*/, glslang::TIntermAggregate* node) override {
    add(node->getOp(), *node);
    return true;
  }
  bool visitUnary(glslang::TVisit /*when*/, glslang::TIntermUnary* node) override {
    add(node->getOp(), *node);
    return true;
  }

  std::vector<hlsl::Diagnostic> found;

 private:
  void add(glslang::TOperator op, const TIntermNode& node) {
    const char* name = name_of(op);
    if (name == nullptr) return;
    const bool samples = op != glslang::EOpTextureQueryLod && name == std::string_view("Sample");
    // Some nodes that the front end creates have no location: their parent's is used.
    const bool has_place = node.getLoc().line > 0 || getParentNode() == nullptr;
    found.push_back(error_at(has_place ? node : *getParentNode(),
                             std::string(samples ? "a texture is sampled with" : name) +
                                 (samples ? " derivatives" : " needs derivatives") + ", which a " + stage_ +
                                 " program does not have" +
                                 (samples ? ": use SampleLevel or SampleGrad" : "")));
  }

  std::string stage_;
};

bool is_such_instruction(spv::Op op) {
  return hlsl::is_one_of(op, {spv::OpImageSampleImplicitLod, spv::OpImageSampleExplicitLod,
                              spv::OpImageSampleDrefImplicitLod, spv::OpImageSampleDrefExplicitLod,
                              spv::OpImageSampleProjImplicitLod, spv::OpImageSampleProjExplicitLod,
                              spv::OpImageSampleProjDrefImplicitLod, spv::OpImageSampleProjDrefExplicitLod,
                              spv::OpImageQueryLod}) ||
         (op >= spv::OpDPdx && op <= spv::OpFwidthCoarse);
}

// Operations that need derivatives (Sample, SampleBias, SampleCmp, CalculateLevelOfDetail, ddx, ddy, fwidth)
// in stages that have none.
//
// Direct3D accepts them only in fragment programs (X4532 "cannot map expression to vs_5_0 instruction set";
// in compute from shader model 6.6). glslang silently reads the largest mip level instead. Compilers report
// only what remains after optimisation, so the syntax tree gives the locations of such operations, and the
// optimised module those that remain.
//
// Finds them in the whole syntax tree, each with its location.
std::vector<hlsl::Diagnostic> derivative_reads(const glslang::TIntermediate& tree, const std::string& stage) {
  DerivativeSearch search(stage);
  if (tree.getTreeRoot() != nullptr) tree.getTreeRoot()->traverse(&search);
  return std::move(search.found);
}

// Returns those of `written` for which the module, which keeps its debug lines, has an instruction on the
// same line.
std::vector<hlsl::Diagnostic> remaining(std::vector<hlsl::Diagnostic> written, const SpirvModule& module) {
  std::set<std::pair<std::string, int>> lines;
  DebugLines debug_lines;
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    const SourcePlace& place = debug_lines.visit(instruction);
    if (is_such_instruction(spirv::opcode(instruction))) lines.emplace(place.file, place.line);
  });
  std::vector<hlsl::Diagnostic> kept;
  for (hlsl::Diagnostic& problem : written)
    if (lines.count({problem.file, problem.line}) != 0 &&
        std::find(kept.begin(), kept.end(), problem) == kept.end())
      kept.push_back(std::move(problem));
  return kept;
}

void append(std::vector<hlsl::Diagnostic>& all, std::vector<hlsl::Diagnostic> more) {
  for (hlsl::Diagnostic& problem : more) all.push_back(std::move(problem));
}

std::vector<hlsl::Diagnostic> shown_by(const SpirvModule& module, hlsl::Stage stage) {
  std::vector<hlsl::Diagnostic> problems = lost_resources(module);
  append(problems, misread_textures(module));
  append(problems, refused_offsets(module));
  append(problems, refused_memory(module, stage));
  append(problems, refused_instructions(module, stage));
  return problems;
}

// Finds reachable divisions by a constant zero; a division x / x in the source itself looks like a mark and
// is excluded.
std::vector<hlsl::Diagnostic> divisions_by_zero(const glslang::TIntermediate& tree, VulkanVersion vulkan) {
  spv::SpvBuildLogger messages;
  SpirvModule marked = generated_words(tree, true, messages);
  SpirvModule plain = marked;
  mark_zero_divisions(marked);
  std::vector<std::string> ignored;
  if (!optimise(marked, vulkan, ignored) || !optimise(plain, vulkan, ignored)) return {};
  std::vector<hlsl::Diagnostic> found = marked_divisions(marked);
  const std::vector<hlsl::Diagnostic> own = marked_divisions(plain);
  std::erase_if(found, [&](const hlsl::Diagnostic& problem) {
    return std::find(own.begin(), own.end(), problem) != own.end();
  });
  return found;
}

bool divides_integers(spirv::Words instruction) {
  const spv::Op op = spirv::opcode(instruction);
  const bool divides = hlsl::is_one_of(op, {spv::OpUDiv, spv::OpSDiv, spv::OpUMod, spv::OpSRem, spv::OpSMod});
  return divides && instruction.size() == 5;
}

// Constants that are zero in one component at least.
class Zeros {
 public:
  void visit(spirv::Words instruction) {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpConstant && instruction.size() == 4 && instruction[3] == 0) ids_.insert(instruction[2]);
    if (op == spv::OpConstantNull && instruction.size() == 3) ids_.insert(instruction[2]);
    if (op == spv::OpConstantComposite && instruction.size() > 3 &&
        std::any_of(instruction.begin() + 3, instruction.end(),
                    [this](std::uint32_t id) { return contain(id); }))
      ids_.insert(instruction[2]);
  }
  bool contain(std::uint32_t id) const { return ids_.count(id) != 0; }

 private:
  std::set<std::uint32_t> ids_;
};

// Returns the words at which divisions by zero begin.
std::vector<std::size_t> zero_divisions(const SpirvModule& module) {
  std::vector<std::size_t> found;
  Zeros zeros;
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    zeros.visit(instruction);
    if (divides_integers(instruction) && zeros.contain(instruction[4]))
      found.push_back(static_cast<std::size_t>(instruction.data() - module.data()));
  });
  return found;
}

}  // namespace

std::vector<hlsl::Diagnostic> hlsl_problems(const CompileRequest& request, const glslang::TIntermediate& tree,
                                            const SpirvModule& optimised, bool divides) {
  std::vector<hlsl::Diagnostic> problems = shown_by(optimised, request.stage);
  std::vector<hlsl::Diagnostic> derivatives;
  if (request.stage != hlsl::Stage::fragment)
    derivatives = derivative_reads(tree, hlsl::stage_name(request.stage));
  if (problems.empty() && derivatives.empty() && !divides) return {};
  const SpirvModule lined = words_with_lines(tree, true, request.vulkan);
  if (std::vector<hlsl::Diagnostic> placed = shown_by(lined, request.stage); !placed.empty())
    problems = std::move(placed);
  append(problems, remaining(std::move(derivatives), lined));
  if (divides) append(problems, divisions_by_zero(tree, request.vulkan));
  return problems;
}

bool divides_by_zero(const SpirvModule& unoptimised) {
  return !zero_divisions(unoptimised).empty();
}

void mark_zero_divisions(SpirvModule& unoptimised) {
  for (const std::size_t at : zero_divisions(unoptimised)) unoptimised[at + 4] = unoptimised[at + 3];
}

std::vector<hlsl::Diagnostic> marked_divisions(const SpirvModule& optimised) {
  std::vector<hlsl::Diagnostic> problems;
  DebugLines lines;
  spirv::for_each_instruction(optimised, [&](spirv::Words instruction) {
    const SourcePlace& place = lines.visit(instruction);
    if (!divides_integers(instruction) || instruction[3] != instruction[4]) return;
    hlsl::Diagnostic problem = error_at(place, "an integer is divided by zero");
    if (std::find(problems.begin(), problems.end(), problem) == problems.end())
      problems.push_back(std::move(problem));
  });
  return problems;
}

}  // namespace penumbra::shaders
