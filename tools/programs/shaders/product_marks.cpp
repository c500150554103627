#include "shaders/product_marks.h"

#include "hlsl/tokens.h"

namespace penumbra::shaders {

bool ProductMarks::stands_at(const glslang::TSourceLoc& place) {
  if (!read_) read();
  const std::string file = place.getFilename() == nullptr ? main_file_ : place.getFilename();
  return marks_.contains({file, place.line, place.column});
}

void ProductMarks::read() {
  read_ = true;
  for (const hlsl::Token& token : hlsl::lex(text_)) {
    if (token.spelling != "*") continue;
    const auto at = static_cast<std::size_t>(token.spelling.data() - text_.data());
    const std::size_t line = text_.rfind('\n', at) + 1;
    const std::string file = token.file.empty() ? main_file_ : std::string(token.file);
    marks_.insert({file, token.line, static_cast<int>(at - line) + 1});
  }
}

}  // namespace penumbra::shaders
