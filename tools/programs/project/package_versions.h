// Whether the packages at hand fit each other, asked before anything is compiled: a wrong version looks like
// a compiler error later ("redefinition", an unknown 'Pow2').
//
// Unity ships the packages of its render pipelines together and each says which release of the others it was
// made with, so between those (com.unity.render-pipelines.*, com.unity.shadergraph,
// com.unity.visualeffectgraph) major, minor and patch must be equal; of a *-config package, which is made to
// be embedded and changed, major and minor. Every other dependency is the lowest version that will do (Unity
// manual, "Package dependency and resolution").
#pragma once

#include <vector>

#include "hlsl/diagnostic.h"
#include "project/package_root.h"

namespace penumbra::project {

// Warnings at the lines of package.json files: a render-pipeline dependency that has no root, one at another
// release, any other dependency that is too old, a root given by hand whose package.json is broken, a root
// that names another package. A root without package.json is not judged.
std::vector<hlsl::Diagnostic> version_problems(const std::vector<PackageRoot>& roots);

}  // namespace penumbra::project
