// The text that glslang's preprocessor makes of tokens and the lines that they are on (DoPreprocessing and
// SourceLineSynchronizer in its ShaderLang.cpp). Internal to this room.
#pragma once

#include <string>

#include "preprocessing/cut_source.h"

namespace penumbra::preprocessing {

class Output {
 public:
  explicit Output(const Spellings& spellings) : spellings_(spellings) {}

  // `place.column` may be 0 for a token that begins no line.
  void token(const Token& token, int line, int column);
  // Tokens of one run, in which no macro is called.
  void copy(const CutSource& source, std::size_t first, std::size_t last);
  // On that line: the next one is line `next` of the file.
  void line_directive(int line, int next, const std::string& file);

  std::string take();

 private:
  bool sync_to(int line);
  void begin(const Token& token, int line, int column);

  const Spellings& spellings_;
  std::string text_;
  int line_ = -1;  // that the text has come to
  Token before_;
};

}  // namespace penumbra::preprocessing
