#include "shaders/matrix_operators.h"

#include <array>

namespace penumbra::shaders {

using glslang::TOperator;
using glslang::TType;

bool is_float(const TType& type) {
  return type.getBasicType() == glslang::EbtFloat || type.getBasicType() == glslang::EbtDouble ||
         type.getBasicType() == glslang::EbtFloat16;
}

bool is_comparison(TOperator op) {
  switch (op) {
    case glslang::EOpEqual:
    case glslang::EOpNotEqual:
    case glslang::EOpVectorEqual:
    case glslang::EOpVectorNotEqual:
    case glslang::EOpLessThan:
    case glslang::EOpGreaterThan:
    case glslang::EOpLessThanEqual:
    case glslang::EOpGreaterThanEqual:
      return true;
    default:
      return false;
  }
}

// A binary node is componentwise except where the back end does it: + - * of float matrices, and m / s as m *
// (1 / s).
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

TOperator plain_operator(TOperator assignment) {
  switch (assignment) {
    case glslang::EOpAddAssign:
      return glslang::EOpAdd;
    case glslang::EOpSubAssign:
      return glslang::EOpSub;
    case glslang::EOpMatrixTimesScalarAssign:
      return glslang::EOpMatrixTimesScalar;
    case glslang::EOpDivAssign:
      return glslang::EOpDiv;
    case glslang::EOpModAssign:
      return glslang::EOpMod;
    case glslang::EOpAndAssign:
      return glslang::EOpAnd;
    case glslang::EOpInclusiveOrAssign:
      return glslang::EOpInclusiveOr;
    case glslang::EOpExclusiveOrAssign:
      return glslang::EOpExclusiveOr;
    case glslang::EOpLeftShiftAssign:
      return glslang::EOpLeftShift;
    case glslang::EOpRightShiftAssign:
      return glslang::EOpRightShift;
    default:
      return glslang::EOpNull;
  }
}

TOperator by_rows_operator(TOperator op) {
  return op == glslang::EOpMatrixTimesScalar ? glslang::EOpMul : op;
}

bool is_product(TOperator op) {
  switch (op) {
    case glslang::EOpMatrixTimesMatrix:
    case glslang::EOpMatrixTimesVector:
    case glslang::EOpVectorTimesMatrix:
    case glslang::EOpMatrixTimesMatrixAssign:
    case glslang::EOpVectorTimesMatrixAssign:
      return true;
    default:
      return false;
  }
}

bool is_step(TOperator op) {
  return op == glslang::EOpPreIncrement || op == glslang::EOpPreDecrement ||
         op == glslang::EOpPostIncrement || op == glslang::EOpPostDecrement;
}

bool takes_whole(TOperator op) {
  return op == glslang::EOpTranspose || op == glslang::EOpDeterminant || op == glslang::EOpMatrixInverse ||
         op == glslang::EOpArrayLength;
}

bool is_componentwise_function(TOperator op) {
  switch (op) {
    case glslang::EOpMin:
    case glslang::EOpMax:
    case glslang::EOpClamp:
    case glslang::EOpMix:
    case glslang::EOpStep:
    case glslang::EOpSmoothStep:
    case glslang::EOpPow:
    case glslang::EOpAtan:
    case glslang::EOpMod:
      return true;
    default:
      return false;
  }
}

bool writes_an_argument(TOperator op) {
  return op == glslang::EOpModf || op == glslang::EOpFrexp;
}

TOperator constructor(const TType& matrix) {
  static constexpr std::array<std::array<TOperator, 3>, 3> of_floats{
      {{glslang::EOpConstructMat2x2, glslang::EOpConstructMat2x3, glslang::EOpConstructMat2x4},
       {glslang::EOpConstructMat3x2, glslang::EOpConstructMat3x3, glslang::EOpConstructMat3x4},
       {glslang::EOpConstructMat4x2, glslang::EOpConstructMat4x3, glslang::EOpConstructMat4x4}}};
  static constexpr std::array<std::array<TOperator, 3>, 3> of_ints{
      {{glslang::EOpConstructIMat2x2, glslang::EOpConstructIMat2x3, glslang::EOpConstructIMat2x4},
       {glslang::EOpConstructIMat3x2, glslang::EOpConstructIMat3x3, glslang::EOpConstructIMat3x4},
       {glslang::EOpConstructIMat4x2, glslang::EOpConstructIMat4x3, glslang::EOpConstructIMat4x4}}};
  static constexpr std::array<std::array<TOperator, 3>, 3> of_uints{
      {{glslang::EOpConstructUMat2x2, glslang::EOpConstructUMat2x3, glslang::EOpConstructUMat2x4},
       {glslang::EOpConstructUMat3x2, glslang::EOpConstructUMat3x3, glslang::EOpConstructUMat3x4},
       {glslang::EOpConstructUMat4x2, glslang::EOpConstructUMat4x3, glslang::EOpConstructUMat4x4}}};
  static constexpr std::array<std::array<TOperator, 3>, 3> of_bools{
      {{glslang::EOpConstructBMat2x2, glslang::EOpConstructBMat2x3, glslang::EOpConstructBMat2x4},
       {glslang::EOpConstructBMat3x2, glslang::EOpConstructBMat3x3, glslang::EOpConstructBMat3x4},
       {glslang::EOpConstructBMat4x2, glslang::EOpConstructBMat4x3, glslang::EOpConstructBMat4x4}}};
  const auto& all = matrix.getBasicType() == glslang::EbtInt    ? of_ints
                    : matrix.getBasicType() == glslang::EbtUint ? of_uints
                    : matrix.getBasicType() == glslang::EbtBool ? of_bools
                                                                : of_floats;
  return all.at(static_cast<std::size_t>(matrix.getMatrixCols() - 2))
      .at(static_cast<std::size_t>(matrix.getMatrixRows() - 2));
}

}  // namespace penumbra::shaders
