// Packages/manifest.json and Packages/packages-lock.json of a project: which packages it asks for, and which
// versions the Package Manager settled on (Unity manual, "Project manifest file", "Lock files"). Internal to
// this room.
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
  std::string hash;  // of the git commit; empty for every other source
};

struct ProjectManifest {
  std::filesystem::path file;  // manifest.json, whether it is there or not
  bool found = false;          // manifest.json or packages-lock.json
  std::map<std::string, RequestedPackage> requested;
  std::map<std::string, LockedPackage> locked;
};

// `packages`: the project's Packages folder. Throws InputError for a file that is not what it should be.
ProjectManifest read_project_manifest(const std::filesystem::path& packages);

}  // namespace penumbra::project
