// The spaces that glslang's preprocessor prints between two tokens (DoPreprocessing in its ShaderLang.cpp).
// Internal to this folder.
#pragma once

#include "preprocessing/token.h"

namespace penumbra::preprocessing {

constexpr bool is_tight(Kind kind, Spelling spelling) {
  return kind == Kind::punctuation &&
         (spelling == known::semicolon || spelling == known::open || spelling == known::close ||
          spelling == known::open_square || spelling == known::close_square);
}

constexpr bool blank_between(const Token& before, const Token& after) {
  return before.kind != Kind::end && !is_tight(before.kind, before.spelling) &&
         !is_tight(after.kind, after.spelling) && !after.is(known::comma);
}

}  // namespace penumbra::preprocessing
