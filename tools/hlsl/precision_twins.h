// Overloads that differ in precision alone, made one.
//
// HLSL tells f(half) and f(float) apart; a front end that computes half as float sees one function defined
// twice. Shader libraries write both on purpose, so the text is rewritten between preprocessor and parser:
// of definitions whose name and parameter types agree once half, min16float and min10float are read as float
// (min16int and min12int as int, min16uint as uint) the one with the most full-precision parameters keeps its
// body, the first of equals; the others become declarations. Definitions spelled alike stay: they are an
// error in every compiler. Names are never looked at beyond being the same.
//
// Guarantees: a body turns into ';' and blanks, newlines stay, so every line keeps its number.
#pragma once

#include <string>
#include <vector>

#include "hlsl/diagnostic.h"

namespace penumbra::hlsl {

struct MergedTwins {
  std::string text;
  std::vector<Diagnostic> notes;  // one per body that went: where it was, and where the one kept is
};

// `preprocessed`: no comments, no macros, #line directives for places. Main-file lines before the first
// #line with a name are said to be in `main_file`.
MergedTwins merge_precision_twins(const std::string& preprocessed, const std::string& main_file);

}  // namespace penumbra::hlsl
