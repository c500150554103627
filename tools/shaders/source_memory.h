// What many compilations read, kept between them: every file is read, normalised and looked for once, and all
// see one state of the disk. Not for several threads at once.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>

#include "hlsl/source_text.h"
#include "project/include_search.h"

namespace penumbra::shaders {

// A source as the preprocessor is to see it, and what decides whether it sees it again.
struct SourceToExpand {
  std::string text;
  bool once = false;                // preparation::PreparedSource
  std::string guard;                // preparation::include_guard()
  std::set<std::string> undefined;  // preparation::undefined_macros()
};

class SourceMemory {
 public:
  const hlsl::SourceRead& read(const std::string& name);
  const SourceToExpand& prepared(const std::string& name);  // of a file that can be read

  // As project::find_include(). `roots_key` is equal for equal roots only.
  const project::IncludeSearch& find(const project::IncludeRoots& roots, const std::string& roots_key,
                                     std::string_view asked, const std::string& includer);

 private:
  struct File {
    hlsl::SourceRead read;
    std::optional<SourceToExpand> prepared;
  };

  File& file(const std::string& name);

  std::unordered_map<std::string, File> files_;
  std::unordered_map<std::string, project::IncludeSearch> searches_;
};

SourceToExpand prepared_source(const std::string& text);

// Equal for equal roots only.
std::string key_of(const project::IncludeRoots& roots);

}  // namespace penumbra::shaders
