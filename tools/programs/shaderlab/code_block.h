// Finds the end of a block of shader code. Internal to this folder.
//
// A block ends at ENDHLSL, ENDCG or ENDGLSL as a whole identifier outside of the code's comments and strings:
// published shaders have such words in comments of programs that continue after them, and of programs that
// end with another one. Unity documents no rule for that.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

// Returns the language and kind of an opening keyword (HLSLPROGRAM, CGINCLUDE, ...), case-insensitive.
struct BlockKeyword {
  Language language;
  bool is_include;
};
std::optional<BlockKeyword> block_keyword(std::string_view word);

struct BlockEnd {
  Place end;            // place of the closing keyword
  std::size_t after{};  // offset right after the closing keyword
  // The message and its location if there is no closing keyword.
  std::string problem;
  Place problem_place;
};

// `block` has its language, keyword and begin.
BlockEnd find_block_end(std::string_view text, const CodeBlock& block);

}  // namespace penumbra::shaderlab
