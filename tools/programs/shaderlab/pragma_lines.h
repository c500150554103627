// The #pragma lines of a shader text before preprocessing. Internal to this folder.
//
// Comments are white space, a backslash at the end of a line joins the next; #if is not evaluated.
#pragma once

#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

struct PragmaLine {
  Place place;              // place of '#'
  Place end;                // place after the last token
  std::vector<Name> words;  // the words after #pragma, with their locations
  bool has_line_comment = false;
};

std::vector<PragmaLine> pragma_lines(std::string_view text);

}  // namespace penumbra::shaderlab
