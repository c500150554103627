// The preprocessor: a source with its includes, conditions and macros becomes one text with #line directives.
//
// It reads what Unity's compilers read, which is checked against FXC's own preprocessor and against GCC's
// (tests/preprocessing). Sources are split into directives and runs of text once; a run that mentions no
// macro's name is copied.
#pragma once

#include "hlsl/diagnostic.h"
#include "preprocessing/expansion.h"

namespace penumbra::preprocessing {

// A file that #include has found, or the problem with it. The source is valid until the file is left.
struct IncludedFile {
  std::string name;
  const CutSource* source = nullptr;
  std::string problem{};
};

class Includes {
 public:
  virtual ~Includes() = default;
  // `includer` is the name of the file with the #include.
  virtual IncludedFile enter(const std::string& asked, const std::string& includer) = 0;
  virtual void leave() = 0;  // the file that was entered last
};

// A text, or an error. The diagnostics have no text of their line yet.
struct Preprocessed {
  std::string text;
  std::vector<hlsl::Diagnostic> diagnostics;
};

// A preprocessor that splits and reads many sources in turn. Not thread-safe.
class Preprocessor {
 public:
  // The result may be read by this preprocessor only.
  CutSource cut(std::string_view text) { return cut_source(text, spellings_); }

  // `definitions` precede the source and count as no lines.
  Preprocessed run(const CutSource& definitions, const CutSource& source, const std::string& name,
                   Includes& includes);

 private:
  Spellings spellings_;
  Macros macros_;
  Expansion expansion_{spellings_, macros_};
};

}  // namespace penumbra::preprocessing
