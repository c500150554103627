#include "platform/source_commit.h"

namespace penumbra::platform {

extern const char* const source_commit_text;  // written anew at each build, by cmake/SourceCommit.cmake

std::optional<std::string> source_commit() {
  const std::string text = source_commit_text;
  return text.empty() ? std::nullopt : std::optional(text);
}

}  // namespace penumbra::platform
