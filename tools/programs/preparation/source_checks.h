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

// Returns the places of the entry point's semantics; none if there is no entry point of that name, or
// several. Reports clip and cull distances that glslang crashes on. Without DXC, Direct3D 9's names of system
// values are replaced (semantic_names.h), because glslang takes them for names of the user's own. The
// POSITION of a vertex program that is not rasterized is such a name: the hull or geometry program reads it
// under that name.
std::vector<SemanticPlace> read_entry_semantics(TokenText& text, const EntryPoint& entry);

// Reports parentheses, unary operators and conditions nested too deeply for the stack of a recursive parser;
// it then returns false, and nothing else may process the text.
bool check_nesting(TokenText& text);

// Reports a struct that contains itself, or has so many members, including those of nested structs, that
// compilers run out of time or memory; it then returns false, and nothing else may process the text.
bool check_struct_sizes(TokenText& text);

}  // namespace penumbra::preparation
