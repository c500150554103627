// Merges overloads that differ only in precision.
//
// HLSL distinguishes f(half) from f(float); a front end that treats half as float reports a redefinition.
// Shader libraries define both on purpose. Definitions count as equal if their name and parameter types agree
// once half, min16float and min10float are read as float (min16int and min12int as int, min16uint as uint).
// The one with the most full-precision parameters keeps its body, the first of several; one that calls its
// own name, and so may forward to another overload, only if all do. The others become declarations, each with
// a note. If the two bodies differ in more than the spelling of types (HALF_EPS against FLT_EPS), the choice
// matters: the kept body is the one that overload resolution selects for the calls that the entry point
// reaches, and the note is a warning if it reaches any of them. Definitions with identical parameter types
// are not merged: every compiler rejects them.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void merge_precision_overloads(TokenText& text);

}  // namespace penumbra::preparation
