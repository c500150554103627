#include "preparation/macro_own_names.h"

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "preparation/macro_text.h"

namespace penumbra::preparation {

namespace {

constexpr std::string_view mark = "penumbra_own_";

bool beside_paste(const std::vector<MacroToken>& tokens, std::size_t at, const MacroDefinition& of) {
  const bool before = at > of.body_begin && tokens[at - 1].spelling == "#";
  const bool after = at + 1 < of.body_end && tokens[at + 1].spelling == "#";
  return before || after;
}

}  // namespace

std::string with_own_names_marked(std::string text) {
  const MacroText read = read_macro_text(text);
  std::string out;
  std::size_t from = 0;
  for (const MacroDefinition& definition : read.definitions) {
    for (std::size_t at = definition.body_begin; at < definition.body_end; ++at) {
      const MacroToken& token = read.tokens[at];
      if (token.spelling != definition.name || beside_paste(read.tokens, at, definition)) continue;
      out.append(text, from, token.offset - from).append(mark);
      from = token.offset;
    }
  }
  if (from == 0) return text;
  return out.append(text, from, std::string::npos);
}

std::string without_marks(std::string text) {
  std::size_t at = text.find(mark);
  if (at == std::string::npos) return text;
  std::string out;
  std::size_t from = 0;
  for (; at != std::string::npos; at = text.find(mark, from)) {
    out.append(text, from, at - from);
    from = at + mark.size();
  }
  return out.append(text, from, std::string::npos);
}

}  // namespace penumbra::preparation
