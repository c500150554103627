// Takes what stands around an error out of a text, so that the rest can be parsed again (error_recovery.h).
// Internal to this room.
//
// Blanks and line breaks stay: every other token keeps its place, but for those behind the '}' of an emptied
// body, which may move along their line.
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace penumbra::shaders {

class ErrorRemoval {
 public:
  explicit ErrorRemoval(std::string text);  // preprocessed HLSL

  // Around that token of the text as it is now: the initialiser or the statement it stands in, or else the
  // whole body of its function, in which a return statement takes its place. False when the token is in no
  // function, or its function was emptied before; the text is then unchanged. `lacks_semicolon`: the token is
  // the first of what follows the statement.
  bool remove_part(std::size_t token, bool lacks_semicolon);
  bool remove_body(std::size_t token);  // the whole body at once

  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::set<std::string> emptied_;  // functions
};

}  // namespace penumbra::shaders
