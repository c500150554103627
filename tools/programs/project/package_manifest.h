// package.json of a Unity package: its name, its version and what it depends on (Unity manual, "Package
// manifest file"). Other keys are left alone.
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
  std::string name;                             // empty when the file does not say
  std::string version;                          // likewise
  std::string where;                            // of the version, or of the file
  std::vector<PackageDependency> dependencies;  // by name
};

bool has_package_manifest(const std::filesystem::path& package);

// Throws InputError when DIRECTORY/package.json is missing, cannot be read, or is not what it should be.
PackageManifest read_package_manifest(const std::filesystem::path& package);

}  // namespace penumbra::project
