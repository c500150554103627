// What Unity's compilers refuse in a source and glslang takes without a word: each finding is a note of
// the text.
//
// Read before the passes of prepare.h, from the source as its author wrote it. What only an optimised module
// shows is not here (shaders/hlsl_problems.h).
#pragma once

#include <string>

#include "hlsl/stage.h"
#include "preparation/token_text.h"

namespace penumbra::preparation {

// How a program is entered. `dxc`: by Unity's `#pragma use_dxc`, whose compiler takes more than FXC.
struct EntryPoint {
  std::string name;
  hlsl::Stage stage = hlsl::Stage::fragment;
  bool dxc = false;
};

// Cases with code that end without break or return (FXC X3533, X3537), `continue` in a switch, of a loop
// around it, and a switch that ends in a label. DXC takes all but the last.
void check_switch_cases(TokenText& text);

// `float a = 1 float b = 2;`: a declaration of a scalar that begins before the statement before it ends.
// `int i = 3 j = 4;`, `float a b;`: a name or number where only an operator, ',' or ';' can stand.
void check_semicolons(TokenText& text);

// A kernel without [numthreads(x, y, z)].
void check_thread_group(TokenText& text, const EntryPoint& entry);

// Inputs and outputs of the entry point without a semantic, and with one that its stage does not have: FXC
// X3502, X4502. No entry point of that name, or several: nothing is said.
void check_entry_semantics(TokenText& text, const EntryPoint& entry);

// An integer constant divided by a constant zero, which the front end computes away: FXC X4010.
void check_constant_divisions(TokenText& text);

// An initialiser list with more or fewer numbers than its variable holds: FXC X3017. What has expressions
// that are not understood is an error only where each of them, taken for one number, is too much.
void check_initialiser_counts(TokenText& text);

// A constructor of a vector or matrix with fewer numbers than it has: FXC X3014. Nothing is said where an
// argument is not understood.
void check_constructor_counts(TokenText& text);

// `.stpq`, of which HLSL has none.
void check_letter_swizzles(TokenText& text);

// Variables of type string, which FXC ignores: warnings. DXC takes them at file scope alone.
void check_string_values(TokenText& text, const EntryPoint& entry);

// Interfaces, which glslang does not have.
void check_interfaces(TokenText& text);

// Operators on what they do not take: bits of floats, `==` of structs and arrays, and a condition vector with
// more components than the values of its '?' (FXC X3019), for which `true` is put in. No check that tells
// columns may follow.
void check_operand_kinds(TokenText& text);

// Labels that are no constant integer, or are there twice; another number is put in. No check that tells
// columns may follow.
void check_case_labels(TokenText& text);

// Components that are there twice where they are written: `c.xx = 1` (FXC X3025); `m._m00_11`.
void check_repeated_components(TokenText& text);

// register() of a letter that is not the type's, or that does not exist, or of a number that Direct3D 11 does
// not have. DXC takes any number.
void check_register_classes(TokenText& text, const EntryPoint& entry);

// Arrays without a size where no initialiser says it, of none and of fewer elements. DXC takes arrays of
// resources without a size.
void check_array_sizes(TokenText& text, const EntryPoint& entry);

// Parentheses, signs and conditions nested deeper than a recursive compiler has stack for: false, and nothing
// else should be asked of the text.
bool check_nesting(TokenText& text);

// A struct that contains itself, or has so many members, those of the structs in it included, that compilers
// run out of time or memory: false, and nothing else should be asked of the text.
bool check_struct_sizes(TokenText& text);

// Members of a cbuffer whose packoffset() lies in another one's (FXC X4019), who cross the end of a register
// or need the beginning of one; packoffset() outside of cbuffers.
void check_packed_members(TokenText& text);

// A function that the entry point calls, or the entry point itself, with a type and without any return
// statement: FXC X3507. Nothing is said of overloads, of which it depends on the arguments who is called.
void check_missing_values(TokenText& text, const EntryPoint& entry);

// Variables at file scope, members of cbuffers and of structs that are declared twice (FXC X3003), but for
// those that are declared extern. The later one gets another name, so that the rest can be read: no check
// that tells columns may follow.
void check_repeated_globals(TokenText& text);

}  // namespace penumbra::preparation
