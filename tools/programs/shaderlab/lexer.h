// Identifiers, numbers, strings and blocks of code of a .shader file. Internal to this folder.
//
// - // and /* */ are comments. A /* inside a comment needs its own */ (whole passes are commented out that
//   way), unless the comment would then never end: in that case, from there on, the first */ ends it.
// - Strings have no escapes and end on their line.
// - [ ... ] is one token, taken verbatim: an attribute or a property's name.
// - HLSLPROGRAM, CGPROGRAM and GLSLPROGRAM with all their code are one token. HLSLINCLUDE and similar blocks
//   may be between any two tokens, so they are stored separately.
#pragma once

#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

struct Token {
  enum class Kind { identifier, number, string, bracket, punctuation, program, end, broken };
  Kind kind = Kind::end;
  std::string_view spelling;  // the contents of a string or a bracket, trimmed
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
  std::string broken_message;  // message of the broken token
  std::vector<Remark> warnings;
};

// The views are valid as long as `text`. Linear in its length.
Lexed lex(std::string_view text);

}  // namespace penumbra::shaderlab
