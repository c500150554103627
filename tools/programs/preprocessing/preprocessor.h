// The preprocessor: a source with its includes, conditions and macros becomes one text with #line directives,
// character by character what glslang's preprocessor makes of it, in a tenth of the time. Sources are cut
// into directives and runs of text once; where no macro's name stands in a run, its text is copied.
//
// glslang's preprocessor remains the authority. This one reads what it has nothing to say of: whatever is an
// error or a warning there, and all that is rare (#pragma, #line, __LINE__, ## of anything but names and
// numbers), ends the reading without a text, for glslang to read the source and to tell of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "preprocessing/cut_source.h"
#include "preprocessing/expansion.h"
#include "preprocessing/macros.h"
#include "preprocessing/spellings.h"

namespace penumbra::preprocessing {

// A file that #include has found. What there is to read of it lives until it is left; none: it is skipped.
struct IncludedFile {
  std::string name;
  const CutSource* source = nullptr;
};

class Includes {
 public:
  virtual ~Includes() = default;
  // Nothing: the reading ends. `includer` is the name of the file that asks.
  virtual std::optional<IncludedFile> enter(const std::string& asked, const std::string& includer) = 0;
  virtual void leave() = 0;  // the file that was entered last
};

// Cuts and reads many sources, one after the other. Not for several threads at once.
class Preprocessor {
 public:
  // To be read by this preprocessor only.
  CutSource cut(std::string_view text) { return cut_source(text, spellings_); }

  // `definitions` stand before the source and count as no lines. Nothing: glslang is to read it.
  std::optional<std::string> run(const CutSource& definitions, const CutSource& source,
                                 const std::string& name, Includes& includes);

 private:
  Spellings spellings_;
  Macros macros_;
  Expansion expansion_{spellings_, macros_};
};

}  // namespace penumbra::preprocessing
