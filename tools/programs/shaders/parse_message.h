// Rewrites glslang's messages in HLSL's terms. Internal to this folder.
//
// glslang reports the token first and then the problem, in terms of its own syntax tree ("assign", "temp
// 2-component vector of float"). Unknown messages are not changed.
#pragma once

#include "hlsl/token_place.h"

namespace penumbra::shaders {

struct LogLine;

// The tokens around the one at which the parser stopped; all empty if it is unknown.
struct Surroundings {
  std::string_view found;  // the token it stopped at
  std::string_view next;   // the one after
  bool found_is_identifier = false;
  bool next_is_identifier = false;
  bool same_line_as_before = false;  // the previous token is on the same source line
};

std::string sentence(const LogLine& line, const Surroundings& around);

// Turns "in 3-component vector of float" into "float3".
std::string with_hlsl_types(const std::string& message);

// Returns "; did you mean 'x'?", from the identifiers in the text and HLSL's own, "; HLSL has 'x'" for a name
// of GLSL, or empty.
std::string nearest_word(std::string_view unknown, const hlsl::TokenPlaces& text);

// Returns the same among the functions that the text defines.
std::string nearest_function(const std::string& unknown, const hlsl::TokenPlaces& text);

// Returns the same among HLSL's texture and buffer methods.
std::string nearest_method(const std::string& unknown);

bool is_intrinsic(const std::string& name);  // a function that HLSL itself has

}  // namespace penumbra::shaders
