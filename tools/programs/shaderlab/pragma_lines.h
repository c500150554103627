// The #pragma lines of a shader text as it stands in its file, before any preprocessor. Internal to this
// room.
//
// Comments are blanks, a backslash at the end of a line joins the next; #if is not evaluated.
#pragma once

#include <string_view>
#include <vector>

#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

struct PragmaLine {
  Place place;              // of '#'
  Place end;                // behind the last word
  std::vector<Name> words;  // behind #pragma, with their places
  bool has_line_comment = false;
};

std::vector<PragmaLine> pragma_lines(std::string_view text);

}  // namespace penumbra::shaderlab
