// Errors in a source that Unity's compilers report and glslang does not: each finding is a note of the text.
//
// The checks run before the passes of prepare.h, on the original source. Errors that only an optimised module
// shows are found by shaders/hlsl_problems.h.
#pragma once

#include "hlsl/stage.h"
#include "preparation/semantic_names.h"
#include "preparation/token_text.h"

namespace penumbra::preparation {

// An entry point. `dxc`: compiled with Unity's `#pragma use_dxc`, whose compiler accepts more than FXC.
// `rasterized`: the output of a vertex program goes to the rasterizer, not to a hull or geometry program.
struct EntryPoint {
  std::string name;
  hlsl::Stage stage = hlsl::Stage::fragment;
  bool dxc = false;
  bool rasterized = true;
};

// Reports cases with code that end without break or return (FXC X3533, X3537), `continue` of an enclosing
// loop within a switch, and a switch that ends in a label. DXC accepts all but the last.
void check_switch_cases(TokenText& text);

// Reports `float a = 1 float b = 2;`, a declaration of a scalar that begins before the previous statement
// ends, and `int i = 3 j = 4;`, `float a b;`, a name or number where only an operator, ',' or ';' may follow.
void check_semicolons(TokenText& text);

// Reports a kernel without [numthreads(x, y, z)], or with another number of sizes.
void check_thread_group(TokenText& text, const EntryPoint& entry);

// Reports attributes that a geometry, hull or domain program needs and lacks, a patch constant function that
// does not exist, streams without `inout`, and more numbers than a geometry program may emit (FXC X4552).
// Reports nothing if there is no entry point of that name, or several.
void check_stage_attributes(TokenText& text, const EntryPoint& entry);

// Reports inputs and outputs of the entry point without a semantic, or with one that its stage does not have:
// FXC X3502, X4502. Reports nothing if there is no entry point of that name, or several. Returns the places
// of those with a semantic. Without DXC, Direct3D 9's names of system values are replaced (semantic_names.h),
// because glslang takes them for names of the user's own. The POSITION of a vertex program that is not
// rasterized is such a name: the hull or geometry program reads it under that name.
std::vector<SemanticPlace> check_entry_semantics(TokenText& text, const EntryPoint& entry);

// Reports an integer constant divided by a constant zero, which glslang's constant folding hides: FXC X4010.
void check_constant_divisions(TokenText& text);

// Reports an initialiser list with more or fewer numbers than its variable holds: FXC X3017. A list with
// expressions of unknown type is an error only if there are too many even with one number for each of these.
void check_initialiser_counts(TokenText& text);

// Reports a constructor of a vector or matrix with fewer numbers than it has: FXC X3014. Reports nothing if
// the type of an argument is unknown.
void check_constructor_counts(TokenText& text);

// Reports `S(1, 2)` for a struct S: FXC X3037.
void check_struct_constructors(TokenText& text);

// Reports casts of a vector or matrix to one with more rows or columns: FXC X3017. glslang fills the rest
// with zeros, and ones on the diagonal.
void check_larger_casts(TokenText& text);

// Reports groupshared variables in functions and structs.
void check_groupshared_values(TokenText& text);

// Reports `.stpq` swizzles, which HLSL does not have.
void check_letter_swizzles(TokenText& text);

// Warns of variables of type string, which FXC ignores. DXC accepts them only at file scope.
void check_string_values(TokenText& text, const EntryPoint& entry);

// Reports functions of HLSL that glslang does not have, on some of which it crashes; they are renamed. A
// check that reports columns must not run after this one.
void refuse_absent_intrinsics(TokenText& text);

// Reports methods that the resource's type does not have, or that glslang does not have for it
// (`.sample[][]`, the Load<T> of DXC), elements of buffers that have none, Direct3D 9's texture functions
// with a texture in place of a sampler, and textures and samplers as arguments of functions of numbers.
void check_resource_calls(TokenText& text);

// Reports static variables in structs, which glslang takes for members of each value.
void check_static_members(TokenText& text);

// Reports interfaces, which glslang does not have.
void check_interfaces(TokenText& text);

// Reports operators with operands that they do not accept: bitwise operators on floats, `==` of structs and
// arrays, and a condition vector with more components than the values of its '?' (FXC X3019), which is
// replaced by `true`. A check that reports columns must not run after this one.
void check_operand_kinds(TokenText& text);

// Reports case labels that are not constant integers, or duplicates, which are replaced by another number,
// and those outside of a switch, which are removed. A check that reports columns must not run after this one.
void check_case_labels(TokenText& text);

// Reports components that are repeated in a write: `c.xx = 1` (FXC X3025); and mixed subscripts: `m._m00_11`.
void check_repeated_components(TokenText& text);

// Reports register() with a letter that is not the type's, or that does not exist, or with a number that
// Direct3D 11 does not have. DXC accepts any number.
void check_register_classes(TokenText& text, const EntryPoint& entry);

// Reports arrays without a size and without an initialiser that implies it, and arrays of zero or negative
// size. DXC accepts arrays of resources without a size.
void check_array_sizes(TokenText& text, const EntryPoint& entry);

// Reports parentheses, unary operators and conditions nested too deeply for the stack of a recursive parser;
// it then returns false, and nothing else may process the text.
bool check_nesting(TokenText& text);

// Reports a struct that contains itself, or has so many members, including those of nested structs, that
// compilers run out of time or memory; it then returns false, and nothing else may process the text.
bool check_struct_sizes(TokenText& text);

// Reports members of a cbuffer whose packoffset() overlaps another's (FXC X4019), that straddle registers or
// are not aligned to one although they must be, and packoffset() outside of cbuffers.
void check_packed_members(TokenText& text);

// Reports `return;` in a function with a return type: FXC X3080. Reports a function that the entry point
// calls, or the entry point itself, with a return type and without any return statement: FXC X3507. It
// reports nothing for overloads, because the call's arguments decide which one is called.
void check_missing_values(TokenText& text, const EntryPoint& entry);

// Reports variables at file scope, members of cbuffers and members of structs that are declared twice (FXC
// X3003), except those declared extern. The later one is renamed, so that the rest can be parsed: a check
// that reports columns must not run after this one.
void check_repeated_globals(TokenText& text);

}  // namespace penumbra::preparation
