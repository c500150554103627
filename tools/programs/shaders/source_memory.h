// Files shared by many compilations: every file is searched for, read and normalised once, and all
// compilations see the same state of the disk. Not thread-safe.
#pragma once

#include <set>
#include <unordered_map>

#include "hlsl/source_text.h"
#include "preprocessing/preprocessor.h"
#include "project/include_search.h"

namespace penumbra::shaders {

// A source as the preprocessor reads it, and the properties that decide whether it is read again.
struct SourceToExpand {
  std::string text;
  bool once = false;                // preparation::PreparedSource
  std::string guard;                // preparation::include_guard()
  std::set<std::string> undefined;  // preparation::undefined_macros()
};

// A file's text, or the reason why there is none, as in hlsl::SourceRead.
struct KnownSource {
  hlsl::SourceFiles::Text text;
  std::string problem;
};

class SourceMemory {
 public:
  // With `glslang_alone`, only glslang's preprocessor is used, not the project's own.
  explicit SourceMemory(bool glslang_alone = false) : glslang_alone_(glslang_alone) {}

  const KnownSource& read(const std::string& name);
  const SourceToExpand& prepared(const std::string& name);  // only for a file that can be read

  const preprocessing::CutSource& cut(const std::string& name);  // only for the text of prepared()
  // Cuts another text. The result is valid until the next call.
  const preprocessing::CutSource& cut_text(const std::string& text);
  preprocessing::Preprocessor& preprocessor() { return preprocessor_; }
  bool glslang_alone() const { return glslang_alone_; }

  // The number of sources that fell back to glslang's preprocessor.
  std::size_t left_to_glslang() const { return left_to_glslang_; }
  void count_left_to_glslang() { ++left_to_glslang_; }

  // Returns the result of project::find_include(). `roots_key` must differ for different roots.
  const project::IncludeSearch& find(const project::IncludeRoots& roots, const std::string& roots_key,
                                     std::string_view asked, const std::string& includer);

 private:
  struct File {
    KnownSource source;
    std::optional<SourceToExpand> prepared;
    std::optional<preprocessing::CutSource> cut;
  };

  File& file(const std::string& name);

  bool glslang_alone_;
  std::size_t left_to_glslang_ = 0;
  preprocessing::Preprocessor preprocessor_;
  std::optional<std::string> text_;  // the last argument of cut_text()
  preprocessing::CutSource cut_text_;
  std::unordered_map<std::string, File> files_;
  std::unordered_map<std::string, project::IncludeSearch> searches_;
};

SourceToExpand prepared_source(const std::string& text);

// Returns a key that differs for different roots.
std::string key_of(const project::IncludeRoots& roots);

}  // namespace penumbra::shaders
