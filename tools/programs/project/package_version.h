// The version of a Unity package, "MAJOR.MINOR.PATCH[-PRERELEASE][+BUILD]", and its order as Semantic
// Versioning 2.0.0 defines it (semver.org, sections 9 to 11): a pre-release is older than its release,
// numbers in it compare as numbers, and build data does not count.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

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

}  // namespace penumbra::project
