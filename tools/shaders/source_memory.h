// What many compilations read, kept between them: every file is read, normalised and looked for once, and all
// see one state of the disk. Not for several threads at once.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "hlsl/source_text.h"
#include "preparation/source_directives.h"
#include "project/include_search.h"

namespace penumbra::shaders {

class SourceMemory {
 public:
  const hlsl::SourceRead& read(const std::string& name);
  const preparation::PreparedSource& prepared(const std::string& name);  // of a file that can be read

  // As project::find_include(). `roots_key` is equal for equal roots only.
  const project::IncludeSearch& find(const project::IncludeRoots& roots, const std::string& roots_key,
                                     std::string_view asked, const std::string& includer);

 private:
  struct File {
    hlsl::SourceRead read;
    std::optional<preparation::PreparedSource> prepared;
  };

  File& file(const std::string& name);

  std::unordered_map<std::string, File> files_;
  std::unordered_map<std::string, project::IncludeSearch> searches_;
};

// A source as the preprocessor is to see it.
preparation::PreparedSource prepared_source(const std::string& text);

// Equal for equal roots only.
std::string key_of(const project::IncludeRoots& roots);

}  // namespace penumbra::shaders
