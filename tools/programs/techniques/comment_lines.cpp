#include "techniques/comment_lines.h"

#include <sstream>
#include <utility>

namespace penumbra::techniques {

std::string comment_lines(const std::string& text, std::string_view first, std::string_view next) {
  constexpr std::size_t kColumns = 120;
  std::string lines, line(first);
  std::istringstream words(text);
  bool has_word = false;
  for (std::string word; words >> word; has_word = true) {
    if (has_word && line.size() + 1 + word.size() > kColumns)
      lines += std::exchange(line, std::string(next)) + "\n";
    line += (line.ends_with(' ') ? "" : " ") + word;
  }
  return lines + line + "\n";
}

}  // namespace penumbra::techniques
