// The package.json of a Unity package: its name, its version and its dependencies (Unity manual, "Package
// manifest file"). Other keys are ignored.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra::project {

struct PackageDependency {
  std::string name;
  std::string version;
  std::string where;  // "file:line:column"
};

struct PackageManifest {
  std::string name;                             // empty when the file has none
  std::string version;                          // empty when the file has none
  std::string where;                            // place of the version, or the file
  std::vector<PackageDependency> dependencies;  // sorted by name
};

bool has_package_manifest(const std::filesystem::path& package);

// Throws InputError when DIRECTORY/package.json is missing, cannot be read, or is invalid.
PackageManifest read_package_manifest(const std::filesystem::path& package);

}  // namespace penumbra::project
