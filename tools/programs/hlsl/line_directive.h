// `#line N "file"`, as a preprocessor emits it. Internal to this folder.
#pragma once

#include <charconv>
#include <string_view>
#include <system_error>

namespace penumbra::hlsl {

struct LinePlace {
  std::string_view file;  // the file's spelling in its directive; empty before the first that names one
  int line = 1;
};

// Reads the location of the line after the directive; a directive without a file changes only the line
// number. Returns false for every other line.
inline bool take_line_directive(std::string_view line, LinePlace& next) {
  if (!line.starts_with("#line ")) return false;
  int number = 0;
  if (std::from_chars(line.data() + 6, line.data() + line.size(), number).ec != std::errc()) return false;
  next.line = number;
  const std::size_t open = line.find('"');
  const std::size_t close = line.rfind('"');
  if (open != std::string_view::npos && close > open) next.file = line.substr(open + 1, close - open - 1);
  return true;
}

}  // namespace penumbra::hlsl
