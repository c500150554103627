#include "platform/source_commit.h"

#include "platform/child_process.h"
#include "platform/data_directory.h"

namespace penumbra::platform {

extern const char* const source_commit_text;  // replaced at each build, by cmake/SourceCommit.cmake

namespace {

constexpr int kDiffers = 1;  // exit code of git diff --quiet

}  // namespace

std::optional<std::string> source_commit_in(const std::string& built, const std::filesystem::path& folder) {
  if (built.empty()) return std::nullopt;
  if (built.ends_with("-dirty") || !find_program("git") || !std::filesystem::exists(folder / ".git"))
    return built;
  const ChildResult result = run_child({"git",
                                        {"-C", folder.string(), "diff", "--quiet", built, "--", "tools",
                                         "ShaderLibrary", "Shaders", "cmake", "CMakeLists.txt"},
                                        ""});
  return result.exit_code == kDiffers ? built + "-dirty" : built;
}

std::optional<std::string> source_commit() {
  return source_commit_in(source_commit_text, data_directory());
}

}  // namespace penumbra::platform
