#include "platform/data_directory.h"

#include <cstdlib>
#include <string>
#include <vector>

#include "input/input_error.h"
#include "platform/terminal.h"

namespace penumbra::platform {

// If PENUMBRA_ROOT is set, it alone counts: another folder's shaders are not the requested ones.
std::filesystem::path data_directory() {
  std::vector<std::filesystem::path> candidates{program_directory().parent_path() / "share" / "penumbra",
                                                PENUMBRA_SOURCE_DIR};
  const char* given = std::getenv("PENUMBRA_ROOT");  // NOLINT(concurrency-mt-unsafe)
  if (given != nullptr && *given != '\0') candidates = {given};

  std::string tried;
  for (const std::filesystem::path& candidate : candidates) {
    std::error_code error;
    if (std::filesystem::exists(candidate / "ShaderLibrary" / "Shadows.hlsl", error)) return candidate;
    tried += " " + candidate.string();
  }
  throw EnvironmentError("the shader library was not found; tried:" + tried +
                         "\n  set PENUMBRA_ROOT to the folder that holds ShaderLibrary/Shadows.hlsl");
}

}  // namespace penumbra::platform
