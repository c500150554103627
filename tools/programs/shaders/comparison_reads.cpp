#include "shaders/comparison_reads.h"

#include <glslang/MachineIndependent/localintermediate.h>

#include <string>

#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {
namespace {

bool gathers(glslang::TOperator op) {
  return op == glslang::EOpTextureGather || op == glslang::EOpTextureGatherOffset ||
         op == glslang::EOpTextureGatherOffsets;
}

bool samples(glslang::TOperator op) {
  switch (op) {
    case glslang::EOpTexture:
    case glslang::EOpTextureLod:
    case glslang::EOpTextureOffset:
    case glslang::EOpTextureLodOffset:
    case glslang::EOpTextureGrad:
    case glslang::EOpTextureGradOffset:
      return true;
    default:
      return false;
  }
}

int coordinates(const glslang::TSampler& texture) {
  const bool of_three = texture.dim == glslang::Esd3D || texture.dim == glslang::EsdCube;
  const int plain = texture.dim == glslang::Esd1D ? 1 : of_three ? 3 : 2;
  return plain + (texture.arrayed ? 1 : 0);
}

// A sample has its reference as the last coordinate; cube arrays and gathers have it as a separate argument.
bool has_reference(const glslang::TIntermAggregate& read, const glslang::TSampler& texture) {
  const glslang::TIntermSequence& arguments = read.getSequence();
  const bool is_cube_array = texture.dim == glslang::EsdCube && texture.arrayed;
  if (is_cube_array && !gathers(read.getOp())) return read.isScalar();  // the result type of a comparison
  if (!gathers(read.getOp()))
    return arguments[1]->getAsTyped()->getType().getVectorSize() > coordinates(texture);
  if (arguments.size() < 3) return false;
  const glslang::TType& third = arguments[2]->getAsTyped()->getType();
  return third.isFloatingDomain() && third.getVectorSize() == 1;
}

class Search final : public glslang::TIntermTraverser {
 public:
  bool visitAggregate(glslang::TVisit /*when*/, glslang::TIntermAggregate* node) override {
    const glslang::TOperator op = node->getOp();
    const glslang::TIntermSequence& arguments = node->getSequence();
    if ((!samples(op) && !gathers(op)) || arguments.size() < 2) return true;
    const glslang::TIntermTyped* texture = arguments[0]->getAsTyped();
    if (texture == nullptr || texture->getBasicType() != glslang::EbtSampler) return true;
    const glslang::TSampler& type = texture->getType().getSampler();
    if (type.shadow && !has_reference(*node, type)) found.push_back(problem(*texture, *node));
    return true;
  }

  std::vector<hlsl::Diagnostic> found;

 private:
  // Returns an empty name if it is not a variable.
  static std::string sampler_of(const glslang::TIntermTyped& pair) {
    const glslang::TIntermAggregate* made = pair.getAsAggregate();
    if (made == nullptr || made->getSequence().size() < 2) return "";
    const glslang::TIntermSymbol* symbol = made->getSequence()[1]->getAsSymbolNode();
    return symbol == nullptr ? "" : symbol->getName().c_str();
  }

  static hlsl::Diagnostic problem(const glslang::TIntermTyped& texture, const TIntermNode& read) {
    const std::string name = sampler_of(texture);
    const std::string sampler = name.empty() ? "this" : "'" + name + "'";
    return error_at(read, sampler +
                              " is a comparison sampler and this read does not compare; use a sampler like "
                              "sampler_LinearClamp, or SAMPLE_TEXTURE2D_SHADOW");
  }
};

}  // namespace

std::vector<hlsl::Diagnostic> reads_without_comparing(const glslang::TIntermediate& tree) {
  Search search;
  if (tree.getTreeRoot() != nullptr) tree.getTreeRoot()->traverse(&search);
  return std::move(search.found);
}

}  // namespace penumbra::shaders
