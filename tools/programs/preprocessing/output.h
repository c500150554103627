// The text that glslang's preprocessor produces from tokens and their lines (DoPreprocessing and
// SourceLineSynchronizer in its ShaderLang.cpp). Internal to this folder.
#pragma once

#include <string>

#include "preprocessing/cut_source.h"

namespace penumbra::preprocessing {

class Output {
 public:
  explicit Output(const Spellings& spellings) : spellings_(spellings) {}

  // `place.column` may be 0 for a token that begins no line.
  void token(const Token& token, int line, int column);
  // Copies tokens of one run, in which no macro is called.
  void copy(const CutSource& source, std::size_t first, std::size_t last);
  // Emits a directive on `line`: the next line is line `next` of the file.
  void line_directive(int line, int next, const std::string& file);

  std::string take();

 private:
  bool sync_to(int line);
  void begin(const Token& token, int line, int column);

  const Spellings& spellings_;
  std::string text_;
  int line_ = -1;  // the current line of the text
  Token before_;
};

}  // namespace penumbra::preprocessing
