// Overloads that differ in precision alone, made one.
//
// HLSL tells f(half) and f(float) apart; a front end that computes half as float sees one function defined
// twice. Shader libraries write both on purpose, so: of definitions whose name and parameter types agree once
// half, min16float and min10float are read as float (min16int and min12int as int, min16uint as uint) the one
// with the most full-precision parameters keeps its body, the first of equals; but one that calls its own
// name, and so hands on to a twin, only if all do. The others become declarations. Each body that goes is a
// note. Where the two bodies differ in more than the spelling of types (HALF_EPS against FLT_EPS) it matters
// which one is kept: that is the one which the arguments of the calls choose, the note is a warning, and
// calls of both are an error. Definitions spelled alike stay: they are an error in every compiler. Names are
// never looked at beyond being the same.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void merge_precision_twins(TokenText& text);

}  // namespace penumbra::preparation
