// Removes the code around an error from a text, so that the rest can be parsed again (error_recovery.h).
// Internal to this folder.
//
// White space and line breaks are kept: every other token keeps its location, except those after the '}' of
// an emptied body, which may move along their line.
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace penumbra::shaders {

class ErrorRemoval {
 public:
  explicit ErrorRemoval(std::string text);  // preprocessed HLSL

  // Removes the code around the token that begins at `offset` of the current text: the initialiser or the
  // statement that contains it, or else the whole body of its function, which is replaced by a return
  // statement. Returns false if the token is in no function, or its function was already emptied; the text is
  // then unchanged. `lacks_semicolon` means that the token is the first one after the statement.
  bool remove_part(std::size_t offset, bool lacks_semicolon);
  bool remove_body(std::size_t offset);  // removes the whole body at once

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::set<std::string> emptied_;  // functions
};

}  // namespace penumbra::shaders
