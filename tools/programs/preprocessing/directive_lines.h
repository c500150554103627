// The preprocessor directives of a text, one by one: comments are white space, backslashes join lines, and
// every word keeps its place. No condition is evaluated.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::preprocessing {

struct Word {
  std::string text;
  int line = 0;
  int column = 0;
  std::size_t offset = 0;  // in the text
};

struct DirectiveLine {
  std::string name;  // "pragma", "if", ...; empty for a lone '#'
  int line = 0;      // place of the '#'
  int column = 0;
  std::size_t offset = 0;
  std::vector<Word> words;    // the text behind the name, split at white space
  std::string rest;           // the words with a blank between them
  Word end;                   // an empty word behind the last one
  bool line_comment = false;  // a // comment follows
};

// The text has LF line ends (hlsl/source_text.h).
std::vector<DirectiveLine> directive_lines(std::string_view text);

}  // namespace penumbra::preprocessing
