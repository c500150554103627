// Files shared by many compilations: every file is searched for, read and normalised once, and all
// compilations see the same state of the disk. Not thread-safe.
#pragma once

#include <optional>
#include <unordered_map>

#include "hlsl/source_text.h"
#include "preprocessing/preprocessor.h"
#include "project/include_search.h"

namespace penumbra::shaders {

// A file's text, or the reason why there is none, as in hlsl::SourceRead.
struct KnownSource {
  hlsl::SourceFiles::Text text;
  std::string problem;
};

class SourceMemory {
 public:
  const KnownSource& read(const std::string& name);
  // Splits a file that can be read; if `prepared`, its literals and pragmas are rewritten first
  // (preparation/source_directives.h).
  const preprocessing::CutSource& cut(const std::string& name, bool prepared);
  // Splits another text. The result is valid until the next call.
  const preprocessing::CutSource& cut_text(const std::string& text, bool prepared);
  preprocessing::Preprocessor& preprocessor() { return preprocessor_; }
  // Returns the result of project::find_include(). `roots_key` must differ for different roots.
  const project::IncludeSearch& find(const project::IncludeRoots& roots, const std::string& roots_key,
                                     std::string_view asked, const std::string& includer);

 private:
  struct File {
    KnownSource source;
    std::optional<preprocessing::CutSource> cut;
    std::optional<preprocessing::CutSource> prepared;
  };

  File& file(const std::string& name);

  preprocessing::Preprocessor preprocessor_;
  std::optional<std::pair<std::string, bool>> text_;  // the last arguments of cut_text()
  preprocessing::CutSource cut_text_;
  std::unordered_map<std::string, File> files_;
  std::unordered_map<std::string, project::IncludeSearch> searches_;
};

// Returns a key that differs for different roots.
std::string key_of(const project::IncludeRoots& roots);

}  // namespace penumbra::shaders
