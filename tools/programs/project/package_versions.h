// A check whether the available packages are compatible, made before compilation: a wrong version otherwise
// shows as a compiler error ("redefinition", an unknown 'Pow2').
//
// Unity ships the packages of its render pipelines together and each declares the release of the others with
// which it was built. So between those (com.unity.render-pipelines.*, com.unity.shadergraph,
// com.unity.visualeffectgraph) major, minor and patch must be equal; for a *-config package, which is meant
// to be embedded and changed, only major and minor. Every other dependency is a minimum version (Unity
// manual, "Package dependency and resolution").
#pragma once

#include <vector>

#include "hlsl/diagnostic.h"
#include "project/package_root.h"

namespace penumbra::project {

// Returns warnings at the lines of package.json files: a render-pipeline dependency that has no root, one at
// another release, any other dependency that is too old, a root given by hand whose package.json is broken, a
// root that names another package. A root without package.json is not judged.
std::vector<hlsl::Diagnostic> version_problems(const std::vector<PackageRoot>& roots);

}  // namespace penumbra::project
