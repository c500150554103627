#include "shaders/refused_operands.h"

#include <glslang/MachineIndependent/localintermediate.h>

#include <string>
#include <string_view>

#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {
namespace {

// Returns an empty name for other operators.
std::string_view bit_operator(glslang::TOperator op) {
  switch (op) {
    case glslang::EOpAnd:
    case glslang::EOpAndAssign:
      return "&";
    case glslang::EOpInclusiveOr:
    case glslang::EOpInclusiveOrAssign:
      return "|";
    case glslang::EOpExclusiveOr:
    case glslang::EOpExclusiveOrAssign:
      return "^";
    case glslang::EOpLeftShift:
    case glslang::EOpLeftShiftAssign:
      return "<<";
    case glslang::EOpRightShift:
    case glslang::EOpRightShiftAssign:
      return ">>";
    default:
      return "";
  }
}

std::string int_of(int components) {
  return components == 1 ? "int" : "int" + std::to_string(components);
}

class Search final : public glslang::TIntermTraverser {
 public:
  bool visitBinary(glslang::TVisit /*when*/, glslang::TIntermBinary* node) override {
    const std::string_view name = bit_operator(node->getOp());
    const bool of_floats =
        node->getLeft()->getType().isFloatingDomain() || node->getRight()->getType().isFloatingDomain();
    if (!name.empty() && of_floats)
      found.push_back(error_at(*node, "'" + std::string(name) +
                                          "' takes integers, and an operand is a float: convert it "
                                          "with (int), or read its bits with asuint()"));
    return true;
  }

  bool visitAggregate(glslang::TVisit /*when*/, glslang::TIntermAggregate* node) override {
    const glslang::TIntermSequence& arguments = node->getSequence();
    if (node->getOp() != glslang::EOpTextureFetch || arguments.size() < 2) return true;
    const glslang::TIntermTyped* texture = arguments[0]->getAsTyped();
    const glslang::TIntermTyped* place = arguments[1]->getAsTyped();
    if (texture == nullptr || place == nullptr || texture->getBasicType() != glslang::EbtSampler) return true;
    const glslang::TSampler& type = texture->getType().getSampler();
    const int wanted = coordinates(type);
    const bool has_level = !type.isMultiSample() && !type.isBuffer();
    const int given = place->getType().getVectorSize();
    if (wanted == 0 || given == wanted || (!has_level && given > wanted)) return true;
    const int level = has_level ? 1 : 0;
    found.push_back(error_at(*node, "this Load takes an " + int_of(wanted + level) +
                                        (has_level ? ", the last for the mip level" : "") +
                                        ", and its argument has " + std::to_string(given + level) +
                                        (given + level == 1 ? " component" : " components")));
    return true;
  }

  std::vector<hlsl::Diagnostic> found;

 private:
  // Returns 0 if it is not known.
  static int coordinates(const glslang::TSampler& type) {
    const int layer = type.isArrayed() ? 1 : 0;
    switch (type.dim) {
      case glslang::EsdBuffer:
      case glslang::Esd1D:
        return 1 + layer;
      case glslang::Esd2D:
        return 2 + layer;
      case glslang::Esd3D:
        return 3;
      default:
        return 0;
    }
  }
};

}  // namespace

std::vector<hlsl::Diagnostic> refused_operands(const glslang::TIntermediate& tree) {
  Search search;
  if (tree.getTreeRoot() != nullptr) tree.getTreeRoot()->traverse(&search);
  return std::move(search.found);
}

}  // namespace penumbra::shaders
