#include "project/package_cache.h"

#include <algorithm>
#include <system_error>

#include "input/input_error.h"
#include "project/folder_entries.h"
#include "project/json_diagnostic.h"
#include "project/outside_package.h"
#include "project/package_manifest.h"
#include "project/package_version.h"

namespace penumbra::project {

namespace fs = std::filesystem;

namespace {

// Unity names a git package's folder by the first 10 (Unity 6: 12) digits of its commit.
constexpr std::size_t shortest_hash = 7;

bool is_commit(const std::string& suffix, const std::string& hash) {
  return suffix.size() >= shortest_hash && hash.compare(0, suffix.size(), suffix) == 0;
}

// Returns whether `a` is an older version than `b`; an invalid version is older than every valid one.
bool older(const CachedPackage& a, const CachedPackage& b) {
  const std::optional<PackageVersion> x = parse_package_version(a.version);
  const std::optional<PackageVersion> y = parse_package_version(b.version);
  return x && y ? *x < *y : !x && y;
}

const CachedPackage* with_version(const std::vector<CachedPackage>& cached, const std::string& version) {
  const auto found = std::find_if(cached.begin(), cached.end(), [&](const CachedPackage& package) {
    return !version.empty() && package.version == version;
  });
  return found == cached.end() ? nullptr : &*found;
}

const CachedPackage* wanted_of(const std::vector<CachedPackage>& cached, const WantedPackage& wanted) {
  const auto commit = std::find_if(cached.begin(), cached.end(), [&](const CachedPackage& package) {
    return is_commit(package.suffix, wanted.locked_hash);
  });
  if (commit != cached.end()) return &*commit;
  if (const CachedPackage* locked = with_version(cached, wanted.locked_version)) return locked;
  return wanted.locked_version.empty() ? with_version(cached, wanted.requested_version) : nullptr;
}

std::string folder_name(const CachedPackage& package) {
  return package.directory.filename().string();
}

}  // namespace

PackageCache read_package_cache(const fs::path& folder, const IncludeBounds& bounds,
                                std::vector<hlsl::Diagnostic>& problems) {
  PackageCache cache;
  std::error_code ignored;
  cache.found = fs::exists(folder, ignored);
  if (!cache.found) return cache;
  for (const fs::path& directory : folders_in(folder)) {
    const std::string file_name = directory.filename().string();
    const std::size_t at = file_name.find('@', 1);
    if (at == std::string::npos && !has_package_manifest(directory)) continue;
    if (!bounds.contain_package(directory)) {
      problems.push_back(diagnostic_of(directory, hlsl::Severity::warning,
                                       outside_package(file_name.substr(0, at), directory)));
      continue;
    }
    const std::string suffix = at == std::string::npos ? "" : file_name.substr(at + 1);
    PackageManifest manifest;
    try {
      manifest = read_package_manifest(directory);
    } catch (const InputError& error) {
      problems.push_back(diagnostic_from(error, directory / "package.json", hlsl::Severity::warning));
    }
    const std::string name = manifest.name.empty() ? file_name.substr(0, at) : manifest.name;
    const std::string version = manifest.version.empty() ? suffix : manifest.version;
    cache.by_name[name].push_back({directory, version, suffix});
  }
  return cache;
}

CacheChoice choose_cached(const std::vector<CachedPackage>& cached, const WantedPackage& wanted) {
  if (const CachedPackage* exact = wanted_of(cached, wanted)) return {*exact, {}, {}};
  const CachedPackage& highest = *std::max_element(cached.begin(), cached.end(), older);
  const bool version_is_locked = parse_package_version(wanted.locked_version).has_value();
  if (version_is_locked || !wanted.locked_hash.empty()) {
    const std::string what = version_is_locked ? wanted.locked_version : wanted.locked_hash;
    return {highest,
            {},
            "packages-lock.json says '" + wanted.name + "' " + what +
                ", which Library/PackageCache does not hold; " + folder_name(highest) +
                " is used; open the project once in the Unity editor that it is for"};
  }
  if (cached.size() == 1) return {highest, {}, {}};
  std::string list;
  for (const CachedPackage& package : cached) list += (list.empty() ? "" : ", ") + folder_name(package);
  return {highest,
          "Library/PackageCache holds '" + wanted.name + "' " + std::to_string(cached.size()) + " times (" +
              list + ") and nothing says which is meant; the highest version is used, " +
              folder_name(highest),
          {}};
}

}  // namespace penumbra::project
