// A Unity package on disk, under which "#include "Packages/NAME/..."" resolves.
#pragma once

#include <filesystem>
#include <string>

namespace penumbra::project {

enum class PackageOrigin {
  given,     // named by hand, --package-root NAME=FOLDER
  embedded,  // a folder of the project's Packages/
  local,     // "file:" in Packages/manifest.json
  cache,     // Library/PackageCache/NAME@VERSION
};

struct PackageRoot {
  std::string name;  // the package's name, for example com.unity.render-pipelines.core
  std::filesystem::path directory;
  std::string version{};  // package.json's; empty when it is not known
  PackageOrigin origin = PackageOrigin::given;
};

}  // namespace penumbra::project
