#include "shaders/matrix_operations.h"

#include <map>
#include <utility>

#include <glslang/Include/intermediate.h>
#include <glslang/MachineIndependent/localintermediate.h>

#include "hlsl/name_set.h"
#include "hlsl/tokens.h"

namespace penumbra::shaders {

namespace {

using glslang::TOperator;
using glslang::TType;

bool is_float(const TType& type) {
  return type.getBasicType() == glslang::EbtFloat || type.getBasicType() == glslang::EbtDouble ||
         type.getBasicType() == glslang::EbtFloat16;
}

bool is_comparison(TOperator op) {
  return hlsl::is_one_of(op, {glslang::EOpEqual, glslang::EOpNotEqual, glslang::EOpVectorEqual,
                              glslang::EOpVectorNotEqual, glslang::EOpLessThan, glslang::EOpGreaterThan,
                              glslang::EOpLessThanEqual, glslang::EOpGreaterThanEqual});
}

// Returns whether a binary node with that result is componentwise and must be expanded. The back end supports
// + - * % of float matrices, and m / s as m * (1 / s).
bool is_componentwise(TOperator op, const TType& result) {
  switch (op) {
    case glslang::EOpDiv:
    case glslang::EOpMul:
      return true;
    case glslang::EOpAdd:
    case glslang::EOpSub:
    case glslang::EOpMod:
    case glslang::EOpMatrixTimesScalar:
    case glslang::EOpAnd:
    case glslang::EOpInclusiveOr:
    case glslang::EOpExclusiveOr:
    case glslang::EOpLeftShift:
    case glslang::EOpRightShift:
      return !is_float(result);
    default:
      return false;
  }
}

// Returns the + of +=; EOpNull for others.
TOperator plain_operator(TOperator assignment) {
  using namespace glslang;
  static const std::map<TOperator, TOperator> plain{{EOpAddAssign, EOpAdd},
                                                    {EOpSubAssign, EOpSub},
                                                    {EOpMatrixTimesScalarAssign, EOpMatrixTimesScalar},
                                                    {EOpDivAssign, EOpDiv},
                                                    {EOpModAssign, EOpMod},
                                                    {EOpAndAssign, EOpAnd},
                                                    {EOpInclusiveOrAssign, EOpInclusiveOr},
                                                    {EOpExclusiveOrAssign, EOpExclusiveOr},
                                                    {EOpLeftShiftAssign, EOpLeftShift},
                                                    {EOpRightShiftAssign, EOpRightShift}};
  const auto found = plain.find(assignment);
  return found == plain.end() ? EOpNull : found->second;
}

// Returns the operator for the rows of matrices.
TOperator by_rows_operator(TOperator op) {
  return op == glslang::EOpMatrixTimesScalar ? glslang::EOpMul : op;
}

// Returns whether it is the product of linear algebra.
bool is_product(TOperator op) {
  return hlsl::is_one_of(
      op, {glslang::EOpMatrixTimesMatrix, glslang::EOpMatrixTimesVector, glslang::EOpVectorTimesMatrix,
           glslang::EOpMatrixTimesMatrixAssign, glslang::EOpVectorTimesMatrixAssign});
}

// Returns whether it is ++ or --.
bool is_step(TOperator op) {
  return hlsl::is_one_of(op, {glslang::EOpPreIncrement, glslang::EOpPreDecrement, glslang::EOpPostIncrement,
                              glslang::EOpPostDecrement});
}

// Returns whether it is a function of one argument that the back end supports on whole matrices.
bool takes_whole(TOperator op) {
  return hlsl::is_one_of(op, {glslang::EOpTranspose, glslang::EOpDeterminant, glslang::EOpMatrixInverse,
                              glslang::EOpArrayLength});
}

// Returns whether it is a function of several arguments.
bool is_componentwise_function(TOperator op) {
  return hlsl::is_one_of(
      op, {glslang::EOpMin, glslang::EOpMax, glslang::EOpClamp, glslang::EOpMix, glslang::EOpStep,
           glslang::EOpSmoothStep, glslang::EOpPow, glslang::EOpAtan, glslang::EOpMod});
}

bool writes_an_argument(TOperator op) {
  return op == glslang::EOpModf || op == glslang::EOpFrexp;
}

using glslang::TIntermAggregate;
using glslang::TIntermBinary;
using glslang::TIntermTyped;
using glslang::TIntermUnary;

// A row of a matrix in HLSL is a column in glslang.
int rows(const TType& matrix) {
  return matrix.getMatrixCols();
}

TType row_type(const TType& matrix, glslang::TBasicType base) {
  return TType(base, glslang::EvqTemporary, matrix.getMatrixRows());
}

bool is_matrix(const TIntermNode* node) {
  return node != nullptr && node->getAsTyped() != nullptr && node->getAsTyped()->isMatrix() &&
         !node->getAsTyped()->isArray();
}

// SPIR-V has no matrices with one column.
bool has_rows(const TType& matrix) {
  return matrix.getMatrixCols() > 1 && matrix.getMatrixRows() > 1;
}

class MatrixOperations final : public TreeRewrite {
 public:
  MatrixOperations(const glslang::TIntermediate& tree, ProductMarks marks)
      : tree_(tree), marks_(std::move(marks)) {}

  std::vector<hlsl::Diagnostic> problems;

 private:
  // An operand's rows before they are combined.
  struct Rows {
    std::vector<TIntermTyped*> rows;         // one for each row, or one scalar for all
    std::vector<TIntermTyped*> assignments;  // assignments that are evaluated first
  };

  TIntermTyped* of_aggregate(TIntermAggregate& node) override {
    bool takes_matrix = false;
    for (const TIntermNode* child : node.getSequence()) takes_matrix = takes_matrix || is_matrix(child);
    const TOperator op = node.getOp();
    if (!takes_matrix) return &node;
    if (is_comparison(op)) return refuse_comparison(node);
    if (writes_an_argument(op))
      return refuse(node, "modf() and frexp() of a matrix; use its rows, as in modf(m[0], whole)");
    if (!is_componentwise_function(op) || !node.isMatrix() || !has_rows(node.getType())) return &node;
    std::vector<TIntermTyped*> operands;
    for (TIntermNode* child : node.getSequence()) operands.push_back(child->getAsTyped());
    return by_rows(node, operands,
                   [&](const std::vector<TIntermTyped*>& of_row, const TType& type) -> TIntermTyped* {
                     auto* made = new TIntermAggregate(op);
                     for (TIntermTyped* operand : of_row) made->getSequence().push_back(operand);
                     made->setType(type);
                     made->setLoc(node.getLoc());
                     return made;
                   });
  }

  TIntermTyped* of_binary(TIntermBinary& node) override {
    if (!is_matrix(node.getLeft()) && !is_matrix(node.getRight())) return &node;
    const TOperator op = node.getOp();
    if (is_comparison(op)) return refuse_comparison(node);
    if (is_product(op) && marks_.stands_at(node.getLoc())) return of_product(node);
    const TOperator plain = plain_operator(op);
    if (plain != glslang::EOpNull && is_componentwise(plain, node.getType()) && is_matrix(node.getLeft()))
      return of_assignment(node, plain);
    if (!node.isMatrix() || !has_rows(node.getType()) || !is_componentwise(op, node.getType())) return &node;
    return combined(node, by_rows_operator(op), node.getLeft(), node.getRight());
  }

  // Expands m * n whose operand types were unknown to the preparation.
  TIntermTyped* of_product(TIntermBinary& node) {
    const TType& left = node.getLeft()->getType();
    const TType& right = node.getRight()->getType();
    const bool alike = left.isMatrix() && right.isMatrix() && left.getMatrixCols() == right.getMatrixCols() &&
                       left.getMatrixRows() == right.getMatrixRows() && has_rows(left);
    if (!alike)
      return refuse(node,
                    "'*' of a vector and a matrix, or of matrices of two sizes; mul() is the product of "
                    "linear algebra");
    if (node.getOp() == glslang::EOpMatrixTimesMatrixAssign) return of_assignment(node, glslang::EOpMul);
    return combined(node, glslang::EOpMul, node.getLeft(), node.getRight());
  }

  TIntermTyped* combined(TIntermTyped& node, TOperator op, TIntermTyped* left, TIntermTyped* right) {
    return by_rows(node, {left, right},
                   [&](const std::vector<TIntermTyped*>& of_row, const TType& type) -> TIntermTyped* {
                     return binary_node(node, op, of_row[0], of_row[1], type);
                   });
  }

  // Expands m /= s to m = m / s.
  TIntermTyped* of_assignment(TIntermBinary& node, TOperator plain) {
    if (!may_be_repeated(node.getLeft()))
      return refuse(node,
                    "compound assignment to a matrix selected by an expression with side effects; assign its "
                    "index to a variable first");
    TIntermTyped* value = combined(node, by_rows_operator(plain), node.getLeft(), node.getRight());
    return binary_node(node, glslang::EOpAssign, node.getLeft(), value, node.getType());
  }

  TIntermTyped* of_unary(TIntermUnary& node) override {
    TIntermTyped* operand = node.getOperand();
    const TOperator op = node.getOp();
    if (!is_matrix(operand) || takes_whole(op) || !has_rows(operand->getType())) return &node;
    if (op == glslang::EOpAny || op == glslang::EOpAll) return of_condition(node);
    if (is_step(op))
      return is_float(operand->getType()) ? &node
                                          : refuse(node, "++ and -- of an integer matrix; write m += 1");
    if (!node.isMatrix() || node.isArray() || node.isConstructor()) return &node;
    return by_rows(
        node, {operand}, [&](const std::vector<TIntermTyped*>& of_row, const TType& type) -> TIntermTyped* {
          const TOperator vector_op = op == glslang::EOpLogicalNot ? glslang::EOpVectorLogicalNot : op;
          return unary_node(node, vector_op, of_row[0], type);
        });
  }

  // Expands any(m) to any(m[0]) || any(m[1]).
  TIntermTyped* of_condition(TIntermUnary& node) {
    Rows of = rows_of(node.getOperand(), false);
    TIntermTyped* all = nullptr;
    for (TIntermTyped* row : of.rows) {
      TIntermTyped* one = unary_node(node, node.getOp(), row, node.getType());
      if (all != nullptr) {
        const TOperator both =
            node.getOp() == glslang::EOpAny ? glslang::EOpLogicalOr : glslang::EOpLogicalAnd;
        one = binary_node(node, both, all, one, node.getType());
      }
      all = one;
    }
    return after(of.assignments, all);
  }

  template <typename Combine>
  TIntermTyped* by_rows(TIntermTyped& node, const std::vector<TIntermTyped*>& operands, Combine combine) {
    std::vector<Rows> of;
    std::vector<TIntermTyped*> assignments;
    for (TIntermTyped* operand : operands) {
      of.push_back(rows_of(operand, operands.size() > 1));
      assignments.insert(assignments.end(), of.back().assignments.begin(), of.back().assignments.end());
    }
    auto* made = new TIntermAggregate(tree_.mapTypeToConstructorOp(node.getType()));
    for (int row = 0; row < rows(node.getType()); ++row) {
      std::vector<TIntermTyped*> of_row;
      for (const Rows& operand : of)
        of_row.push_back(operand.rows.size() == 1 ? operand.rows[0]
                                                  : operand.rows.at(static_cast<std::size_t>(row)));
      TType type = row_type(node.getType(), node.getBasicType());
      type.getQualifier().noContraction = node.getQualifier().noContraction;  // it is precise
      made->getSequence().push_back(combine(of_row, type));
    }
    TType type;
    type.shallowCopy(node.getType());
    type.getQualifier().makeTemporary();
    made->setType(type);
    made->setLoc(node.getLoc());
    return after(assignments, made);
  }

  static TIntermTyped* after(const std::vector<TIntermTyped*>& assignments, TIntermTyped* value) {
    if (assignments.empty()) return value;
    auto* made = new TIntermAggregate(glslang::EOpComma);
    for (TIntermTyped* assignment : assignments) made->getSequence().push_back(assignment);
    made->getSequence().push_back(value);
    made->setType(value->getType());
    made->setLoc(value->getLoc());
    return made;
  }

  // `beside_others` says whether evaluating another operand might change what this one names.
  Rows rows_of(TIntermTyped* operand, bool beside_others) {
    Rows of;
    if (const glslang::TIntermConstantUnion* constant = operand->getAsConstantUnion()) {
      of.rows = rows_of_constant(*constant);
      return of;
    }
    TIntermAggregate* made = operand->getAsAggregate();
    if (made != nullptr && made->getOp() == glslang::EOpComma &&
        is_made_of_rows(made->getSequence().back())) {
      for (std::size_t i = 0; i + 1 < made->getSequence().size(); ++i)
        of.assignments.push_back(made->getSequence()[i]->getAsTyped());
      made = made->getSequence().back()->getAsAggregate();
    }
    if (!beside_others && made != nullptr && is_made_of_rows(made)) {
      for (TIntermNode* row : made->getSequence()) of.rows.push_back(row->getAsTyped());
      return of;
    }
    TIntermTyped* named = made != nullptr ? made : operand;
    if (beside_others || named->getAsSymbolNode() == nullptr) named = in_variable(named, of.assignments);
    if (!named->isMatrix()) {
      of.rows.push_back(named);
      return of;
    }
    for (int row = 0; row < rows(operand->getType()); ++row) of.rows.push_back(row_of(named, row));
    return of;
  }

  static bool is_made_of_rows(const TIntermNode* node) {
    const TIntermAggregate* made = node->getAsAggregate();
    if (made == nullptr || !made->isMatrix() || made->isArray() || !made->isConstructor()) return false;
    if (static_cast<int>(made->getSequence().size()) != rows(made->getType())) return false;
    for (const TIntermNode* row : made->getSequence()) {
      const TType& type = row->getAsTyped()->getType();
      if (!type.isVector() || type.getVectorSize() != made->getType().getMatrixRows() ||
          type.getBasicType() != made->getBasicType())
        return false;
    }
    return true;
  }

  static std::vector<TIntermTyped*> rows_of_constant(const glslang::TIntermConstantUnion& constant) {
    const TType& type = constant.getType();
    std::vector<TIntermTyped*> all;
    const int size = type.isMatrix() ? type.getMatrixRows() : std::max(type.getVectorSize(), 1);
    for (int row = 0; row < (type.isMatrix() ? rows(type) : 1); ++row) {
      glslang::TConstUnionArray values(size);
      for (int i = 0; i < size; ++i) values[i] = constant.getConstArray()[row * size + i];
      all.push_back(
          new glslang::TIntermConstantUnion(values, TType(type.getBasicType(), glslang::EvqConst, size)));
      all.back()->setLoc(constant.getLoc());
    }
    return all;
  }

  // Puts the operand's value into a variable of its own, assigned first.
  TIntermTyped* in_variable(TIntermTyped* value, std::vector<TIntermTyped*>& assignments) {
    TType type;
    type.shallowCopy(value->getType());
    type.getQualifier().makeTemporary();
    const long long id = next_variable_++;
    auto* variable = new glslang::TIntermSymbol(id, "penumbra_matrix", type);
    assignments.push_back(binary_node(*value, glslang::EOpAssign, variable, value, type));
    return new glslang::TIntermSymbol(id, "penumbra_matrix", type);
  }

  static TIntermTyped* row_of(TIntermTyped* matrix, int row) {
    glslang::TConstUnionArray number(1);
    number[0].setIConst(row);
    auto* index = new glslang::TIntermConstantUnion(number, TType(glslang::EbtInt, glslang::EvqConst));
    return binary_node(*matrix, glslang::EOpIndexDirect, matrix, index,
                       row_type(matrix->getType(), matrix->getBasicType()));
  }

  static bool may_be_repeated(const TIntermTyped* place) {
    if (place->getAsSymbolNode() != nullptr || place->getAsConstantUnion() != nullptr) return true;
    const TIntermBinary* part = place->getAsBinaryNode();
    const bool selects = part != nullptr && (part->getOp() == glslang::EOpIndexDirect ||
                                             part->getOp() == glslang::EOpIndexDirectStruct ||
                                             part->getOp() == glslang::EOpIndexIndirect);
    return selects && may_be_repeated(part->getLeft()) && may_be_repeated(part->getRight());
  }

  TIntermTyped* refuse(TIntermTyped& node, const std::string& what) {
    problems.push_back(error_at(node, "not supported here: " + what));
    return &node;
  }

  TIntermTyped* refuse_comparison(TIntermTyped& node) {
    return refuse(
        node,
        "comparing matrices, which gives a matrix of bools in HLSL; compare their rows, as in a[0] == b[0]");
  }

  const glslang::TIntermediate& tree_;
  ProductMarks marks_;
  long long next_variable_ =
      100LL << 56;  // above those of the front end, which begin with the depth of their block
};

// A matrix of bools that is not decomposed crashes glslang's back end.
class BoolMatrices final : public glslang::TIntermTraverser {
 public:
  bool visitAggregate(glslang::TVisit /*when*/, TIntermAggregate* node) override {
    if (node->isConstructor() && node->isMatrix() && node->getBasicType() == glslang::EbtBool)
      problems.push_back(
          error_at(*node, "not supported here: a matrix of bools; use a vector of bools for each row"));
    return true;
  }

  std::vector<hlsl::Diagnostic> problems;
};

}  // namespace

std::vector<hlsl::Diagnostic> write_out_matrix_operations(glslang::TIntermediate& tree, ProductMarks marks) {
  MatrixOperations operations(tree, std::move(marks));
  operations.run(tree);
  BoolMatrices bools;
  if (operations.problems.empty() && tree.getTreeRoot() != nullptr) tree.getTreeRoot()->traverse(&bools);
  return operations.problems.empty() ? std::move(bools.problems) : std::move(operations.problems);
}

bool ProductMarks::stands_at(const glslang::TSourceLoc& place) {
  if (!read_) read();
  const std::string file = place.getFilename() == nullptr ? main_file_ : place.getFilename();
  return marks_.contains({file, place.line, place.column});
}

void ProductMarks::read() {
  read_ = true;
  for (const hlsl::Token& token : hlsl::lex(text_)) {
    if (token.spelling != "*") continue;
    const auto at = static_cast<std::size_t>(token.spelling.data() - text_.data());
    const std::size_t line = text_.rfind('\n', at) + 1;
    const std::string file = token.file.empty() ? main_file_ : std::string(token.file);
    marks_.insert({file, token.line, static_cast<int>(at - line) + 1});
  }
}

}  // namespace penumbra::shaders
