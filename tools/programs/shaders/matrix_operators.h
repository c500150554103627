// Classifies the operators of glslang's syntax tree on matrices. Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>

namespace penumbra::shaders {

bool is_float(const glslang::TType& type);
bool is_comparison(glslang::TOperator op);
bool is_product(glslang::TOperator op);  // the product of linear algebra
bool is_step(glslang::TOperator op);     // ++ or --

// Returns whether a binary node with that result is componentwise and must be expanded. The back end supports
// + - * % of float matrices, and m / s as m * (1 / s).
bool is_componentwise(glslang::TOperator op, const glslang::TType& result);

glslang::TOperator plain_operator(glslang::TOperator assignment);  // the + of +=; EOpNull for others
glslang::TOperator by_rows_operator(glslang::TOperator op);        // the operator for the rows of matrices

bool takes_whole(glslang::TOperator op);  // a function of one argument, supported on whole matrices
bool is_componentwise_function(glslang::TOperator op);  // a function of several arguments
bool writes_an_argument(glslang::TOperator op);

glslang::TOperator constructor(const glslang::TType& matrix);  // constructor of 2 to 4 rows and columns

}  // namespace penumbra::shaders
