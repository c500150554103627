// The text of a shader file before preprocessing, read without evaluating conditions: its macro definitions,
// and the tokens of its ordinary text and of its macros' bodies.
//
// Comments, string literals and all directives but #define are skipped. Linear; accepts any bytes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::preparation {

struct MacroToken {
  std::size_t offset = 0;
  std::string_view spelling;  // an identifier or number, or one character of punctuation
  std::size_t region = 0;     // a number for each macro's body and each run of text between two directives
};

struct MacroDefinition {
  std::string_view name;
  int line = 0;
  std::optional<std::size_t> parameters;  // none: an object-like macro
  std::size_t body_begin = 0;             // index of the first token of its body; the last is before body_end
  std::size_t body_end = 0;
};

struct MacroText {
  std::vector<MacroToken> tokens;  // the bodies of #define among them, without name and parameters
  std::vector<MacroDefinition> definitions;
};

// The views are valid as long as `text`.
MacroText read_macro_text(const std::string& text);

}  // namespace penumbra::preparation
