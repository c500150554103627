// glslang's messages in the words of HLSL's writers. Internal to this room.
//
// glslang puts the token first and then what is wrong with it, in terms of its own tree ("assign", "temp
// 2-component vector of float"). Messages it has that are not known here keep their words.
#pragma once

#include <string>
#include <string_view>

#include "hlsl/token_place.h"

namespace penumbra::shaders {

struct LogLine;

// What stands where the parser stopped; all empty when that is not known.
struct Surroundings {
  std::string_view found;  // the token it stopped at
  std::string_view next;   // the one after
  bool found_is_word = false;
  bool next_is_word = false;
  bool same_line_as_before = false;  // the token before stands in the same source line
};

std::string sentence(const LogLine& line, const Surroundings& around);

// "in 3-component vector of float" as "float3".
std::string with_hlsl_types(const std::string& message);

// "; did you mean 'x'?", of the words in the text and HLSL's own, or empty.
std::string nearest_word(std::string_view unknown, const hlsl::TokenPlaces& text);

// The same among the functions that the text defines.
std::string nearest_function(const std::string& unknown, const hlsl::TokenPlaces& text);

// The same among HLSL's texture and buffer methods.
std::string nearest_method(const std::string& unknown);

bool is_intrinsic(const std::string& name);  // a function that HLSL itself has

}  // namespace penumbra::shaders
