// What Unity's compilers refuse in a source and glslang takes without a word. Nothing is changed: each
// finding is a note of the text.
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
void check_semicolons(TokenText& text);

// A kernel without [numthreads(x, y, z)].
void check_thread_group(TokenText& text, const EntryPoint& entry);

// Inputs and outputs of the entry point without a semantic, and with one that its stage does not have: FXC
// X3502, X4502. No entry point of that name, or several: nothing is said.
void check_entry_semantics(TokenText& text, const EntryPoint& entry);

// An integer constant divided by a constant zero, which the front end computes away: FXC X4010.
void check_constant_divisions(TokenText& text);

}  // namespace penumbra::preparation
