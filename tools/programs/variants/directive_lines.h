// The preprocessor directives of a text, one by one, as a C preprocessor sees them: comments are white space,
// backslashes join lines, and every token keeps its location. Internal to this folder.
//
// The text has LF line ends (hlsl/source_text.h); a stray CR counts as white space. Linear in the text's
// length.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra::variants {

struct Word {
  std::string text;
  int line = 0;
  int column = 0;
};

struct DirectiveLine {
  std::string name;  // "pragma", "if", ...; empty for a lone '#'
  std::string rest;  // the text behind the name, trimmed
  int line = 0;      // line of the '#'
  int column = 0;
  std::vector<Word> words;  // `rest`, split at white space
};

std::vector<DirectiveLine> directive_lines(std::string_view text);

}  // namespace penumbra::variants
