// The text of a shader file as its preprocessor will see it, read without following a condition: what it
// defines, and the words, brackets and commas of its ordinary text and of its macros' bodies.
//
// Comments, texts in quotes and all directives but #define are left out. Linear; any bytes are read.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::preparation {

struct MacroToken {
  std::size_t offset = 0;
  std::string_view spelling;  // a word or number, or one character of punctuation
  std::size_t region = 0;     // one for each macro's body and each stretch of text between two directives
};

struct MacroDefinition {
  std::string_view name;
  int line = 0;
  std::optional<std::size_t> parameters;  // none: a macro without a list of them
  std::size_t body_begin = 0;             // among the tokens: its body, to before body_end
  std::size_t body_end = 0;
};

struct MacroText {
  std::vector<MacroToken> tokens;  // the bodies of #define among them, without name and parameters
  std::vector<MacroDefinition> definitions;
};

// The views live as long as `text` does.
MacroText read_macro_text(const std::string& text);

}  // namespace penumbra::preparation
