// Library/PackageCache of a project: folders NAME@VERSION, NAME@HASH for a git package, and since Unity 6
// NAME@HASH for all, so that only the package.json inside tells name and version. Internal to this folder.
#pragma once

#include <map>

#include "hlsl/diagnostic.h"
#include "project/include_bounds.h"

namespace penumbra::project {

struct CachedPackage {
  std::filesystem::path directory;
  std::string version;  // package.json's, else the folder's; possibly not a valid version
  std::string suffix;   // suffix of the folder's name, after '@'
};

struct PackageCache {
  bool found = false;                                         // the folder exists
  std::map<std::string, std::vector<CachedPackage>> by_name;  // each sorted by folder
};

// Throws InputError if the folder exists and cannot be read; a package with an invalid package.json gets its
// folder's name, with a warning.
PackageCache read_package_cache(const std::filesystem::path& folder, const IncludeBounds& bounds,
                                std::vector<hlsl::Diagnostic>& problems);

// The facts that a project's files state about the package it requires; each may be empty.
struct WantedPackage {
  std::string name;
  std::string locked_version;
  std::string locked_hash;
  std::string requested_version;
};

struct CacheChoice {
  CachedPackage package;
  std::string note;     // there were several, and nothing determines which
  std::string warning;  // the required one does not exist
};

// `cached` must not be empty. The lock's commit or version decides, then the manifest's version, else the
// highest.
CacheChoice choose_cached(const std::vector<CachedPackage>& cached, const WantedPackage& wanted);

}  // namespace penumbra::project
