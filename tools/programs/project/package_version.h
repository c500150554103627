// The version of a Unity package, "MAJOR.MINOR.PATCH[-PRERELEASE][+BUILD]", and its order as Semantic
// Versioning 2.0.0 defines it (semver.org, sections 9 to 11): a pre-release is older than its release,
// numbers in it compare as numbers, and build data does not count.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

#include "hlsl/diagnostic.h"
#include "project/package_root.h"

namespace penumbra::project {

struct PackageVersion {
  std::uint32_t major = 0;
  std::uint32_t minor = 0;
  std::uint32_t patch = 0;
  std::string prerelease{};  // the text without its '-'; empty for a release

  bool same_release_as(const PackageVersion& other) const {
    return major == other.major && minor == other.minor && patch == other.patch;
  }
};

// Returns nothing when the text is no version: "file:../x", a git address, "latest".
std::optional<PackageVersion> parse_package_version(std::string_view text);

std::strong_ordering operator<=>(const PackageVersion& a, const PackageVersion& b);
bool operator==(const PackageVersion& a, const PackageVersion& b);

// A check whether the available packages are compatible, made before compilation: a wrong version otherwise
// shows as a compiler error ("redefinition", an unknown 'Pow2').
//
// Unity ships the packages of its render pipelines together and each declares the release of the others with
// which it was built. So between those (com.unity.render-pipelines.*, com.unity.shadergraph,
// com.unity.visualeffectgraph) major, minor and patch must be equal; for a *-config package, which is meant
// to be embedded and changed, only major and minor. Every other dependency is a minimum version (Unity
// manual, "Package dependency and resolution").
//
// Returns warnings at the lines of package.json files: a render-pipeline dependency that has no root, one at
// another release, any other dependency that is too old, a root given by hand whose package.json is broken, a
// root that names another package. A root without package.json is not judged.
std::vector<hlsl::Diagnostic> version_problems(const std::vector<PackageRoot>& roots);

}  // namespace penumbra::project
