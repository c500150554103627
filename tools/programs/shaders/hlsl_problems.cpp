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

}  // namespace

std::vector<hlsl::Diagnostic> hlsl_problems(const CompileRequest& request, const glslang::TIntermediate& tree,
                                            const SpirvModule& optimised) {
  std::vector<hlsl::Diagnostic> problems = lost_resources(optimised);
  std::vector<hlsl::Diagnostic> derivatives;
  if (request.stage != hlsl::Stage::fragment)
    derivatives = derivative_reads(tree, hlsl::stage_name(request.stage));
  if (problems.empty() && derivatives.empty()) return {};
  const SpirvModule lined = words_with_lines(tree, true, request.vulkan);
  if (std::vector<hlsl::Diagnostic> placed = lost_resources(lined); !placed.empty())
    problems = std::move(placed);
  append(problems, remaining(std::move(derivatives), lined));
  return problems;
}

}  // namespace penumbra::shaders
