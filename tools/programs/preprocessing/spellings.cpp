#include "preprocessing/spellings.h"

#include <array>

namespace penumbra::preprocessing {

namespace {

constexpr std::array<std::string_view, known::count> known_texts{
    "(",      ")",       "[",    "]",       "{",       "}",       ",",
    ";",      "#",       "||",   "&&",      "|",       "^",       "&",
    "==",     "!=",      ">",    ">=",      "<",       "<=",      "<<",
    ">>",     "+",       "-",    "*",       "/",       "%",       "~",
    "!",      "?",       ":",    "defined", "define",  "undef",   "if",
    "ifdef",  "ifndef",  "elif", "else",    "endif",   "include", "include_with_pragmas",
    "pragma", "warning", "line", "error",   "__LINE__"};

}  // namespace

Spellings::Spellings() {
  for (const std::string_view text : known_texts) number(text);
}

Spelling Spellings::number(std::string_view text) {
  const Spelling number = numbers_.find(text);
  return number != hlsl::StringInterner::none ? number : numbers_.add(texts_.emplace_back(text));
}

}  // namespace penumbra::preprocessing
