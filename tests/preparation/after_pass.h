// Applies a pass to a text.
#pragma once

#include <string>

#include "preparation/token_text.h"

namespace penumbra::preparation {

template <void (*Pass)(TokenText&)>
std::string after(const std::string& text) {
  TokenText tokens(text, "m");
  Pass(tokens);
  return tokens.spelled(0, tokens.size());
}

}  // namespace penumbra::preparation
