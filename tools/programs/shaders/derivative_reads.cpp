#include "shaders/derivative_reads.h"

#include <glslang/MachineIndependent/localintermediate.h>

#include <algorithm>
#include <set>
#include <utility>

#include "shaders/debug_lines.h"
#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {

namespace {

// Returns the operation's name in HLSL; nullptr if it needs no derivatives.
const char* name_of(glslang::TOperator op) {
  switch (op) {
    case glslang::EOpTexture:
    case glslang::EOpTextureOffset:
    case glslang::EOpTextureProj:
    case glslang::EOpTextureProjOffset:
    case glslang::EOpTextureClamp:
    case glslang::EOpTextureOffsetClamp:
      return "Sample";
    case glslang::EOpTextureQueryLod:
      return "CalculateLevelOfDetail";
    case glslang::EOpDPdx:
    case glslang::EOpDPdxFine:
    case glslang::EOpDPdxCoarse:
      return "ddx";
    case glslang::EOpDPdy:
    case glslang::EOpDPdyFine:
    case glslang::EOpDPdyCoarse:
      return "ddy";
    case glslang::EOpFwidth:
    case glslang::EOpFwidthFine:
    case glslang::EOpFwidthCoarse:
      return "fwidth";
    default:
      return nullptr;
  }
}

class Search final : public glslang::TIntermTraverser {
 public:
  explicit Search(std::string stage) : stage_(std::move(stage)) {}

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
  switch (op) {
    case spv::OpImageSampleImplicitLod:
    case spv::OpImageSampleExplicitLod:
    case spv::OpImageSampleDrefImplicitLod:
    case spv::OpImageSampleDrefExplicitLod:
    case spv::OpImageSampleProjImplicitLod:
    case spv::OpImageSampleProjExplicitLod:
    case spv::OpImageSampleProjDrefImplicitLod:
    case spv::OpImageSampleProjDrefExplicitLod:
    case spv::OpImageQueryLod:
      return true;
    default:
      return op >= spv::OpDPdx && op <= spv::OpFwidthCoarse;
  }
}

}  // namespace

std::vector<hlsl::Diagnostic> derivative_reads(const glslang::TIntermediate& tree, const std::string& stage) {
  Search search(stage);
  if (tree.getTreeRoot() != nullptr) tree.getTreeRoot()->traverse(&search);
  return std::move(search.found);
}

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

}  // namespace penumbra::shaders
