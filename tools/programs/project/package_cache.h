// Library/PackageCache of a project: folders NAME@VERSION, NAME@HASH for a git package, and since Unity 6
// NAME@HASH for all, so that only the package.json inside tells name and version. Internal to this room.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "project/include_bounds.h"

namespace penumbra::project {

struct CachedPackage {
  std::filesystem::path directory;
  std::string version;  // package.json's, else the folder's; may be no version at all
  std::string suffix;   // of the folder, behind '@'
};

struct PackageCache {
  bool found = false;                                         // the folder is there
  std::map<std::string, std::vector<CachedPackage>> by_name;  // each sorted by folder
};

// Throws InputError when the folder is there and cannot be read; a package whose package.json is broken goes
// by its folder's name, with a warning.
PackageCache read_package_cache(const std::filesystem::path& folder, const IncludeBounds& bounds,
                                std::vector<hlsl::Diagnostic>& problems);

// What a project says of the package it wants; each may be empty.
struct WantedPackage {
  std::string name;
  std::string locked_version;
  std::string locked_hash;
  std::string requested_version;
};

struct CacheChoice {
  CachedPackage package;
  std::string note;     // several were there, and nothing said which
  std::string warning;  // the one the project wants is not there
};

// `cached` is not empty. The lock's commit or version decides, then the manifest's version, else the highest.
CacheChoice choose_cached(const std::vector<CachedPackage>& cached, const WantedPackage& wanted);

}  // namespace penumbra::project
