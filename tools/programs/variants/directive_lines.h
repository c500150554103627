// The preprocessor directives of a text, one by one, as a C preprocessor sees them: comments are blanks,
// backslashes join lines, and every word keeps its place. Internal to this room.
//
// The text has LF line ends (hlsl/source_text.h); a stray CR counts as a blank. Linear in the text's length.
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
  std::string rest;  // what follows the name, without blanks at its ends
  int line = 0;      // of the '#'
  int column = 0;
  std::vector<Word> words;  // of rest, split at blanks
};

std::vector<DirectiveLine> directive_lines(std::string_view text);

}  // namespace penumbra::variants
