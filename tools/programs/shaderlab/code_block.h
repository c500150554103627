// Where a block of shader code ends. Internal to this room.
//
// A block ends at ENDHLSL, ENDCG or ENDGLSL as a word of its own outside comments and strings of the code: in
// published shaders such words stand in comments of programs that go on after them, and of programs that end
// with another word. Unity documents no rule for that.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

// The language and kind of an opening word (HLSLPROGRAM, CGINCLUDE, ...), case ignored.
struct BlockKeyword {
  Language language;
  bool is_include;
};
std::optional<BlockKeyword> block_keyword(std::string_view word);

struct BlockEnd {
  Place end;            // of the closing word
  std::size_t after{};  // offset just behind it
  // When there is no such word, why, and where to say it:
  std::string problem;
  Place problem_place;
};

// `block` has its language, keyword and begin.
BlockEnd find_block_end(std::string_view text, const CodeBlock& block);

}  // namespace penumbra::shaderlab
