// Words, numbers, strings and blocks of code of a .shader file. Internal to this room.
//
// - // and /* */ are comments. A /* inside a comment asks for its own */ (whole passes are commented out that
//   way) unless the comment then never ends: in that case, and from there on, the first */ ends it.
// - Strings have no escapes and end on their line.
// - [ ... ] is one token, read as it stands: an attribute or a property's name.
// - HLSLPROGRAM, CGPROGRAM and GLSLPROGRAM with all their code are one token. HLSLINCLUDE and its kin may
// stand
//   between any two tokens, so they are set apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

struct Token {
  enum class Kind { word, number, text, bracket, mark, program, end, broken };
  Kind kind = Kind::end;
  std::string_view spelling;  // of a text what the quotes hold, of a bracket what it holds, trimmed
  Place place;
  std::size_t program = 0;  // index into Lexed::programs
};

struct Remark {
  Place place;
  std::string message;
};

struct Lexed {
  std::vector<Token> tokens;  // the last is end or broken
  std::vector<CodeBlock> programs;
  std::vector<CodeBlock> includes;
  std::string broken_message;  // of the broken token
  std::vector<Remark> warnings;
};

// The views live as long as `text` does. Linear in its length.
Lexed lex(std::string_view text);

}  // namespace penumbra::shaderlab
