#include "project/unity_project.h"

#include <map>
#include <sstream>
#include <system_error>
#include <utility>

#include "input/input_error.h"
#include "input/text_file.h"
#include "project/folder_entries.h"
#include "project/include_bounds.h"
#include "project/json_diagnostic.h"
#include "project/outside_package.h"
#include "project/package_cache.h"
#include "project/package_manifest.h"
#include "project/package_search.h"
#include "project/project_manifest.h"

namespace penumbra::project {

namespace fs = std::filesystem;

namespace {

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

void check_is_project(const fs::path& directory) {
  std::error_code ignored;
  if (!fs::exists(directory, ignored)) throw InputError(directory.string(), "no such folder");
  if (!is_folder(directory)) throw InputError(directory.string(), "is a file, not the folder of a project");
  if (!is_folder(directory / "Assets") && !is_folder(directory / "Packages"))
    throw InputError(directory.string(), "is not a Unity project: it contains neither Assets/ nor Packages/",
                     "name the folder that contains Assets/");
}

std::optional<EditorVersion> read_editor_version(const fs::path& file,
                                                 std::vector<hlsl::Diagnostic>& problems) {
  constexpr std::string_view key = "m_EditorVersion:";
  constexpr std::size_t largest = std::size_t{1} << 20U;
  std::error_code ignored;
  std::istringstream stream(fs::exists(file, ignored) ? read_found_text_file(file, largest) : "");
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.compare(0, key.size(), key) != 0) continue;
    const std::size_t start = line.find_first_not_of(" \t", key.size());
    const std::size_t end = line.find_last_not_of(" \t\r");
    const std::string text =
        start == std::string::npos || end < start ? "" : line.substr(start, end + 1 - start);
    std::optional<EditorVersion> version = parse_editor_version(text);
    if (!version)
      problems.push_back(
          {file.string(), number, 0, hlsl::Severity::warning,
           "'" + text + "' is not an editor version like 2022.3.20f1; UNITY_VERSION is not known", line});
    return version;
  }
  problems.push_back(
      diagnostic_of(file, hlsl::Severity::note,
                    std::string(number == 0 ? "is missing or empty" : "has no m_EditorVersion") +
                        "; the project's UNITY_VERSION is not known"));
  return std::nullopt;
}

// Returns the packages with a Packages/FOLDER/package.json; the first by folder where two have one name.
std::map<std::string, PackageRoot> embedded_packages(const fs::path& packages, const IncludeBounds& bounds,
                                                     std::vector<hlsl::Diagnostic>& problems) {
  std::map<std::string, PackageRoot> embedded;
  std::error_code ignored;
  if (!fs::exists(packages, ignored)) return embedded;
  for (const fs::path& folder : folders_in(packages)) {
    if (!has_package_manifest(folder)) continue;
    const fs::path file = folder / "package.json";
    if (!bounds.contain_package(folder)) {
      problems.push_back(diagnostic_of(folder, hlsl::Severity::warning,
                                       outside_package(folder.filename().string(), folder)));
      continue;
    }
    try {
      const PackageManifest manifest = read_package_manifest(folder);
      if (manifest.name.empty())
        throw InputError(file.string(), "has no 'name', so Unity does not load the package");
      PackageRoot root{manifest.name, folder, manifest.version, PackageOrigin::embedded};
      const auto [first, is_new] = embedded.emplace(manifest.name, std::move(root));
      if (!is_new)
        problems.push_back(diagnostic_of(
            file, hlsl::Severity::warning,
            "'" + manifest.name + "' is embedded twice; " + first->second.directory.string() + " is used"));
    } catch (const InputError& error) {
      problems.push_back(diagnostic_from(error, file, hlsl::Severity::error));
    }
  }
  return embedded;
}

}  // namespace

UnityProject read_project(const fs::path& directory, const std::vector<PackageRoot>& given) {
  check_is_project(directory);
  UnityProject project;
  project.directory = directory;
  const fs::path packages = directory / "Packages";
  const fs::path version = directory / "ProjectSettings" / "ProjectVersion.txt";
  PackageSources sources;
  sources.bounds.add(directory);
  sources.bounds.add(own_tree(directory / "Assets"));
  for (const fs::path& file : {version, packages / "manifest.json", packages / "packages-lock.json"})
    sources.bounds.require(file);
  project.editor = read_editor_version(version, project.problems);
  for (const PackageRoot& root : given) sources.by_hand.emplace(root.name, root);
  sources.embedded = embedded_packages(packages, sources.bounds, project.problems);
  sources.manifest = read_project_manifest(packages);
  sources.cache =
      read_package_cache(directory / "Library" / "PackageCache", sources.bounds, project.problems);
  project.packages = find_packages(sources, project.problems);
  return project;
}

}  // namespace penumbra::project
