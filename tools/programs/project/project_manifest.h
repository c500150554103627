// Packages/manifest.json and Packages/packages-lock.json of a project: the packages that it requires, and the
// versions that the Package Manager selected (Unity manual, "Project manifest file", "Lock files"). Internal
// to this folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace penumbra::project {

struct RequestedPackage {
  std::string version;  // "14.0.9", "file:../x", a git address
  std::string where;    // "manifest.json:line:column"
};

struct LockedPackage {
  std::string version;
  std::string hash;  // hash of the git commit; empty for other sources
};

struct ProjectManifest {
  std::filesystem::path file;  // manifest.json, whether it exists or not
  bool found = false;          // manifest.json or packages-lock.json
  std::map<std::string, RequestedPackage> requested;
  std::map<std::string, LockedPackage> locked;
};

// `packages` is the project's Packages folder. Throws InputError for an invalid file.
ProjectManifest read_project_manifest(const std::filesystem::path& packages);

}  // namespace penumbra::project
