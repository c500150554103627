#include "shaders/tree_problems.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include <glslang/MachineIndependent/localintermediate.h>

#include "hlsl/name_set.h"
#include "hlsl/tokens.h"
#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {

namespace {

bool gathers(glslang::TOperator op) {
  return hlsl::is_one_of(
      op, {glslang::EOpTextureGather, glslang::EOpTextureGatherOffset, glslang::EOpTextureGatherOffsets});
}

bool samples(glslang::TOperator op) {
  return hlsl::is_one_of(
      op, {glslang::EOpTexture, glslang::EOpTextureLod, glslang::EOpTextureOffset,
           glslang::EOpTextureLodOffset, glslang::EOpTextureGrad, glslang::EOpTextureGradOffset});
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

class ComparisonSearch final : public glslang::TIntermTraverser {
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

bool is_written(glslang::TStorageQualifier qualifier) {
  return qualifier == glslang::EvqOut || qualifier == glslang::EvqInOut;
}

// HLSL converts an inout argument of another type in both directions, glslang only on input.
bool is_converted(glslang::TIntermTyped& argument) {
  const glslang::TIntermUnary* made = argument.getAsUnaryNode();
  return made != nullptr && made->getOperand()->getBasicType() != argument.getBasicType();
}

class ArgumentSearch final : public glslang::TIntermTraverser {
 public:
  bool visitAggregate(glslang::TVisit /*when*/, glslang::TIntermAggregate* node) override {
    if (node->getOp() != glslang::EOpFunctionCall) return true;
    const glslang::TIntermSequence& arguments = node->getSequence();
    const glslang::TQualifierList& qualifiers = node->getQualifierList();
    for (std::size_t i = 0; i < std::min(arguments.size(), qualifiers.size()); ++i) {
      glslang::TIntermTyped* argument = arguments[i]->getAsTyped();
      if (argument != nullptr && is_written(qualifiers[i]) && is_converted(*argument)) tell(*node, i);
    }
    return true;
  }

  std::vector<hlsl::Diagnostic> found;

 private:
  void tell(const glslang::TIntermAggregate& call, std::size_t argument) {
    const std::string name(call.getName().c_str());
    found.push_back(error_at(call, "'" + name.substr(0, name.find('(')) + "' writes to its argument " +
                                       std::to_string(argument + 1) +
                                       ", which has another type: pass a variable of the parameter's type"));
  }
};

bool is_matrix(const TIntermNode* node) {
  const glslang::TIntermTyped* typed = node == nullptr ? nullptr : node->getAsTyped();
  return typed != nullptr && typed->isMatrix() && !typed->isArray();
}

bool is_matrix_of_floats(const glslang::TIntermTyped& node) {
  return is_matrix(&node) && node.getType().isFloatingDomain();
}

bool is_function_of_matrices(glslang::TOperator op) {
  return hlsl::is_one_of(op, {glslang::EOpTranspose, glslang::EOpDeterminant, glslang::EOpMatrixInverse,
                              glslang::EOpMatrixTimesMatrix});
}

// Returns whether it is a function or a comparison that the back end does not have for matrices.
bool is_of_numbers(glslang::TOperator op) {
  return (op >= glslang::EOpEqual && op <= glslang::EOpGreaterThanEqual) ||
         (op >= glslang::EOpRadians && op < glslang::EOpKill && !is_function_of_matrices(op));
}

class MatrixSearch final : public glslang::TIntermTraverser {
 public:
  MatrixSearch(const std::string& text, const std::string& main_file) : main_file_(main_file) {
    for (const hlsl::Token& token : hlsl::lex(text)) {
      if (token.spelling != "*") continue;
      const auto at = static_cast<std::size_t>(token.spelling.data() - text.data());
      products_.emplace(token.file.empty() ? main_file : std::string(token.file), token.line,
                        static_cast<int>(at - (text.rfind('\n', at) + 1)) + 1);
    }
  }

  bool visitUnary(glslang::TVisit /*when*/, glslang::TIntermUnary* node) override {
    const glslang::TIntermTyped& operand = *node->getOperand();
    const bool of_floats = is_matrix_of_floats(operand) && (!node->isMatrix() || is_matrix_of_floats(*node));
    if (is_matrix(&operand) && !node->isConstructor() && !is_function_of_matrices(node->getOp()) &&
        (is_of_numbers(node->getOp()) || !of_floats))
      tell(*node);
    return true;
  }

  bool visitBinary(glslang::TVisit /*when*/, glslang::TIntermBinary* node) override {
    const glslang::TOperator op = node->getOp();
    if (!is_matrix(node->getLeft()) && !is_matrix(node->getRight())) return true;
    if (hlsl::is_one_of(op, {glslang::EOpAssign, glslang::EOpIndexDirect, glslang::EOpIndexIndirect}))
      return true;
    const bool is_product = hlsl::is_one_of(
        op, {glslang::EOpMatrixTimesMatrix, glslang::EOpMatrixTimesVector, glslang::EOpVectorTimesMatrix,
             glslang::EOpMatrixTimesMatrixAssign, glslang::EOpVectorTimesMatrixAssign});
    if (is_product && stands_at(node->getLoc()))
      found.push_back(error_at(*node,
                               "not supported here: '*' of two matrices, or of a vector and a matrix, which "
                               "glslang multiplies as mul() does; multiply their rows"));
    else if (is_of_numbers(op) || !node->getType().isFloatingDomain())
      tell(*node);
    return true;
  }

  bool visitAggregate(glslang::TVisit /*when*/, glslang::TIntermAggregate* node) override {
    bool takes_matrix = false;
    for (const TIntermNode* child : node->getSequence()) takes_matrix = takes_matrix || is_matrix(child);
    const bool is_made_of_bools =
        node->isConstructor() && node->isMatrix() && node->getBasicType() == glslang::EbtBool;
    const bool is_function = is_of_numbers(node->getOp()) || node->getOp() == glslang::EOpMod;
    if (is_made_of_bools || (takes_matrix && is_function)) tell(*node);
    return true;
  }

  std::vector<hlsl::Diagnostic> found;

 private:
  // Returns whether a '*' is there: mul() gives the same nodes.
  bool stands_at(const glslang::TSourceLoc& place) const {
    const std::string file = place.getFilename() == nullptr ? main_file_ : place.getFilename();
    return products_.contains({file, place.line, place.column});
  }

  void tell(const TIntermNode& node) {
    found.push_back(error_at(node,
                             "not supported here: functions and comparisons of whole matrices, and operators "
                             "of matrices of whole numbers or bools; use their rows, as in abs(m[0])"));
  }

  std::string main_file_;
  std::set<std::tuple<std::string, int, int>> products_;  // file, line and column of each '*'
};

constexpr int register_words = 4;
constexpr int word_bytes = 4;

int rounded_up(int words) {
  return (words + register_words - 1) / register_words * register_words;
}

// More words than any constant buffer of Direct3D may have (4096 registers). Sizes are cut off here, so that
// those of hostile arrays do not overflow; the limits of registers are checked elsewhere.
constexpr std::int64_t most_words = 1 << 20;

// The words that a value takes in a constant buffer.
struct Extent {
  int words = 0;
  bool of_registers = false;  // it begins at a register, as a matrix, an array or a struct does
};

int cut_off(std::int64_t words) {
  return static_cast<int>(std::min(words, most_words));
}

// Places the members of cbuffers by HLSL's rules
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-packing-rules).
class CbufferLayouts final : public glslang::TIntermTraverser {
 public:
  void visitSymbol(glslang::TIntermSymbol* node) override {
    const glslang::TType& type = node->getType();
    const bool is_cbuffer = type.getBasicType() == glslang::EbtBlock &&
                            type.getQualifier().storage == glslang::EvqUniform &&
                            type.getTypeName() != "$Global";
    if (is_cbuffer && seen_.insert(node->getId()).second)
      extent_of_members(type, type.getQualifier().layoutMatrix, glslang::IsAnonymous(node->getName()));
  }

  std::vector<hlsl::Diagnostic> found;

 private:
  // `owns`: no buffer has elements of these members, as it may have of a struct.
  int extent_of_members(const glslang::TType& of, glslang::TLayoutMatrix layout, bool owns) {
    int next = 0;
    bool behind_registers = false;
    for (const glslang::TTypeLoc& member : *of.getStruct()) {
      glslang::TQualifier& qualifier = member.type->getQualifier();
      const Extent extent = extent_of(*member.type, layout);
      const bool fits = !extent.of_registers && next % register_words + extent.words <= register_words;
      next = qualifier.hasOffset() ? qualifier.layoutOffset / word_bytes : fits ? next : rounded_up(next);
      if (behind_registers && next % register_words != 0) {
        if (!owns) tell(member);
        qualifier.layoutOffset = next * word_bytes;
      }
      next = cut_off(next + extent.words);
      behind_registers = extent.of_registers;
    }
    return next;
  }

  Extent extent_of(const glslang::TType& type, glslang::TLayoutMatrix layout) {
    if (type.getQualifier().layoutMatrix != glslang::ElmNone) layout = type.getQualifier().layoutMatrix;
    if (type.isArray()) {
      const int words = extent_of(glslang::TType(type, 0), layout).words;
      return {cut_off(std::int64_t{rounded_up(words)} * (type.getOuterArraySize() - 1) + words), true};
    }
    if (type.isStruct()) return {extent_of_members(type, layout, false), true};
    const int words = type.computeNumComponents() * (type.getBasicType() == glslang::EbtDouble ? 2 : 1);
    if (!type.isMatrix()) return {words, false};
    const int vectors = layout == glslang::ElmRowMajor ? type.getMatrixRows() : type.getMatrixCols();
    return {register_words * (vectors - 1) + words / vectors, true};
  }

  void tell(const glslang::TTypeLoc& member) {
    const char* file = member.loc.getFilename();
    found.push_back(error_at(SourcePlace{file == nullptr ? "" : file, member.loc.line},
                             "not supported here: '" + std::string(member.type->getFieldName()) +
                                 "' shares the last register of the member before it, in a struct of a "
                                 "cbuffer; put a float4 or a larger member after that one"));
  }

  std::set<long long> seen_;  // symbols
};

template <typename Search>
std::vector<hlsl::Diagnostic> found_by(const glslang::TIntermediate& tree) {
  Search search;
  if (tree.getTreeRoot() != nullptr) tree.getTreeRoot()->traverse(&search);
  return std::move(search.found);
}

using glslang::TIntermTyped;

class OperationMeanings final : public TreeRewrite {
 private:
  TIntermTyped* of_unary(glslang::TIntermUnary& node) override {
    TIntermTyped* operand = node.getOperand();
    const bool is_number = !operand->isMatrix() && !operand->isArray();
    if (operand->getBasicType() != glslang::EbtUint || !is_number) return &node;
    if (node.getOp() == glslang::EOpAbs) return operand;
    if (node.getOp() != glslang::EOpNegative) return &node;
    return binary_node(node, glslang::EOpSub, zero(operand->getVectorSize()), operand, node.getType());
  }

  static TIntermTyped* zero(int size) {
    glslang::TConstUnionArray values(size);
    for (int i = 0; i < size; ++i) values[i].setUConst(0);
    return new glslang::TIntermConstantUnion(values,
                                             glslang::TType(glslang::EbtUint, glslang::EvqConst, size));
  }

  // The sample number is a uint in HLSL, and an int in GLSL, where it is not converted implicitly.
  static TIntermTyped* with_int_sample(glslang::TIntermAggregate& node) {
    TIntermTyped* sample = node.getSequence()[1]->getAsTyped();
    if (sample->getBasicType() == glslang::EbtUint)
      node.getSequence()[1] = unary_node(node, glslang::EOpConvUintToInt, sample,
                                         glslang::TType(glslang::EbtInt, glslang::EvqTemporary));
    return &node;
  }

  TIntermTyped* of_aggregate(glslang::TIntermAggregate& node) override {
    const glslang::TIntermSequence& given = node.getSequence();
    const glslang::TType& type = node.getType();
    const auto argument = [&](std::size_t i) { return given[i]->getAsTyped(); };
    if (node.getOp() == glslang::EOpFma && given.size() == 3) {
      TIntermTyped* product = binary_node(node, glslang::EOpMul, argument(0), argument(1), type);
      return binary_node(node, glslang::EOpAdd, product, argument(2), type);
    }
    if (node.getOp() == glslang::EOpInterpolateAtSample && given.size() == 2) return with_int_sample(node);
    if (node.getOp() == glslang::EOpLdexp && given.size() == 2) {
      TIntermTyped* scale = unary_node(node, glslang::EOpExp2, argument(1), argument(1)->getType());
      return binary_node(node, glslang::EOpMul, argument(0), scale, type);
    }
    return &node;
  }
};

class BufferLayouts final : public glslang::TIntermTraverser {
 public:
  void visitSymbol(glslang::TIntermSymbol* node) override {
    glslang::TQualifier& qualifier = node->getWritableType().getQualifier();
    if (node->getBasicType() == glslang::EbtBlock && qualifier.storage == glslang::EvqBuffer)
      qualifier.layoutPacking = glslang::ElpScalar;
  }
};

}  // namespace

void lay_out_buffers(glslang::TIntermediate& tree) {
  BufferLayouts layouts;
  if (tree.getTreeRoot() != nullptr) tree.getTreeRoot()->traverse(&layouts);
}

std::vector<hlsl::Diagnostic> reads_without_comparing(const glslang::TIntermediate& tree) {
  return found_by<ComparisonSearch>(tree);
}

std::vector<hlsl::Diagnostic> converted_arguments(const glslang::TIntermediate& tree) {
  return found_by<ArgumentSearch>(tree);
}

std::vector<hlsl::Diagnostic> lay_out_cbuffers(glslang::TIntermediate& tree) {
  return found_by<CbufferLayouts>(tree);
}

std::vector<hlsl::Diagnostic> operations_on_matrices(const glslang::TIntermediate& tree,
                                                     const std::string& text, const std::string& main_file) {
  MatrixSearch search(text, main_file);
  if (tree.getTreeRoot() != nullptr) tree.getTreeRoot()->traverse(&search);
  return std::move(search.found);
}

void correct_operations(glslang::TIntermediate& tree) {
  OperationMeanings().run(tree);
}

}  // namespace penumbra::shaders
