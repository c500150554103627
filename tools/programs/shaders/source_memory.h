// What many compilations read, kept between them: every file is read, normalised and looked for once, and all
// see one state of the disk. Not for several threads at once.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>

#include "hlsl/source_text.h"
#include "preprocessing/preprocessor.h"
#include "project/include_search.h"

namespace penumbra::shaders {

// A source as the preprocessor is to see it, and what decides whether it sees it again.
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
  // `glslang_alone`: the room's own preprocessor is not asked first.
  explicit SourceMemory(bool glslang_alone = false) : glslang_alone_(glslang_alone) {}

  const KnownSource& read(const std::string& name);
  const SourceToExpand& prepared(const std::string& name);  // of a file that can be read

  const preprocessing::CutSource& cut(const std::string& name);  // of the text that prepared() has
  // Of another text. It lives until the next call.
  const preprocessing::CutSource& cut_text(const std::string& text);
  preprocessing::Preprocessor& preprocessor() { return preprocessor_; }
  bool glslang_alone() const { return glslang_alone_; }

  // How many readings glslang's preprocessor had to do.
  std::size_t left_to_glslang() const { return left_to_glslang_; }
  void count_left_to_glslang() { ++left_to_glslang_; }

  // As project::find_include(). `roots_key` is equal for equal roots only.
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
  std::optional<std::string> text_;  // that was cut last
  preprocessing::CutSource cut_text_;
  std::unordered_map<std::string, File> files_;
  std::unordered_map<std::string, project::IncludeSearch> searches_;
};

SourceToExpand prepared_source(const std::string& text);

// Equal for equal roots only.
std::string key_of(const project::IncludeRoots& roots);

}  // namespace penumbra::shaders
