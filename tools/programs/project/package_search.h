// Determines one root for each package, from a project's requirements and the contents of its folders.
// Internal to this folder.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "project/include_bounds.h"
#include "project/package_cache.h"
#include "project/package_root.h"
#include "project/project_manifest.h"

namespace penumbra::project {

struct PackageSources {
  std::map<std::string, PackageRoot> by_hand;
  std::map<std::string, PackageRoot> embedded;
  ProjectManifest manifest;
  PackageCache cache;
  IncludeBounds bounds;  // the project and its repository; roots given by hand may lie elsewhere
};

// Returns the roots by name. A package of manifest.json that is not found is a warning at its line there; if
// the whole cache is missing, there is one warning for all.
std::vector<PackageRoot> find_packages(const PackageSources& sources,
                                       std::vector<hlsl::Diagnostic>& problems);

}  // namespace penumbra::project
