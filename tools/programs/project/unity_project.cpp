#include "project/unity_project.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <queue>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "hlsl/diagnostic.h"
#include "input/input_error.h"
#include "input/text_file.h"
#include "project/folder_entries.h"
#include "project/include_bounds.h"
#include "project/json_diagnostic.h"
#include "project/outside_package.h"
#include "project/package_cache.h"
#include "project/package_manifest.h"
#include "project/package_root.h"
#include "project/package_version.h"
#include "project/project_manifest.h"

namespace penumbra::project {

namespace {

// Determines one root for each package, from a project's requirements and the contents of its folders.

struct PackageSources {
  std::map<std::string, PackageRoot> by_hand;
  std::map<std::string, PackageRoot> embedded;
  ProjectManifest manifest;
  PackageCache cache;
  IncludeBounds bounds;  // the project and its repository; roots given by hand may lie elsewhere
};

namespace fs = std::filesystem;

constexpr std::string_view file_scheme = "file:";
constexpr std::string_view engine_module = "com.unity.modules.";

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

// Returns the folder that a "file:" version names; nothing for every other version and for a tarball, which
// Unity unpacks into the cache.
std::optional<fs::path> local_folder(const std::string& version, const fs::path& packages) {
  if (!starts_with(version, file_scheme) || ends_with(version, ".tgz") || ends_with(version, ".tar.gz"))
    return std::nullopt;
  std::string path = version.substr(file_scheme.size());
  std::replace(path.begin(), path.end(), '\\', '/');
  return (packages / path).lexically_normal();
}

class PackageSearch {
 public:
  PackageSearch(const PackageSources& sources, std::vector<hlsl::Diagnostic>& problems)
      : sources_(sources), problems_(problems) {}

  std::vector<PackageRoot> run() {
    for (const auto& [name, root] : sources_.by_hand) want(name);
    for (const auto& [name, root] : sources_.embedded) want(name);
    for (const auto& [name, requested] : sources_.manifest.requested) want(name);
    for (const auto& [name, locked] : sources_.manifest.locked) want(name);
    if (!sources_.manifest.found)
      for (const auto& [name, cached] : sources_.cache.by_name) want(name);
    while (!waiting_.empty()) {
      const std::string name = std::move(waiting_.front());
      waiting_.pop();
      visit(name);
    }
    report_missing();
    std::vector<PackageRoot> roots;
    for (auto& [name, root] : found_)
      if (root) roots.push_back(std::move(*root));
    return roots;
  }

 private:
  void want(const std::string& name) {
    if (found_.emplace(name, std::nullopt).second) waiting_.push(name);
  }

  void visit(const std::string& name) {
    std::optional<PackageRoot> root = find(name);
    if (root) read_manifest(*root);
    const bool missing = !root && !starts_with(name, engine_module) && outside_.count(name) == 0;
    if (missing && sources_.manifest.requested.count(name) != 0) missing_.push_back(name);
    found_[name] = std::move(root);
  }

  void read_manifest(PackageRoot& root) {
    if (!has_package_manifest(root.directory)) return;
    try {
      const PackageManifest manifest = read_package_manifest(root.directory);
      if (root.version.empty()) root.version = manifest.version;
      if (root.origin == PackageOrigin::given) compare_with_project(root, manifest.version);
      for (const PackageDependency& dependency : manifest.dependencies) want(dependency.name);
    } catch (const InputError&) {
      // The problem was reported where the folder was found; version_problems() checks a root given by hand.
    }
  }

  // The required version is that of the lock file, or else the one that manifest.json requests.
  void compare_with_project(const PackageRoot& root, const std::string& version) {
    const auto requested = sources_.manifest.requested.find(root.name);
    const auto locked = sources_.manifest.locked.find(root.name);
    std::string wanted;
    if (requested != sources_.manifest.requested.end()) wanted = requested->second.version;
    if (locked != sources_.manifest.locked.end() && parse_package_version(locked->second.version))
      wanted = locked->second.version;
    const std::optional<PackageVersion> want = parse_package_version(wanted);
    const std::optional<PackageVersion> have = parse_package_version(version);
    if (!want || !have || *want == *have) return;
    const std::string where = requested != sources_.manifest.requested.end()
                                  ? requested->second.where
                                  : sources_.manifest.file.string();
    say(where, hlsl::Severity::warning,
        "the project uses " + root.name + " " + wanted + ", but --package-root gives " +
            root.directory.string() + " with version " + version +
            ": a shader that compiles with one may fail with the other; give the folder of " + wanted);
  }

  std::optional<PackageRoot> find(const std::string& name) {
    if (const auto given = sources_.by_hand.find(name); given != sources_.by_hand.end()) return given->second;
    if (const auto folder = sources_.embedded.find(name); folder != sources_.embedded.end())
      return folder->second;
    const auto requested = sources_.manifest.requested.find(name);
    if (requested == sources_.manifest.requested.end()) return find_cached(name);
    const auto& [version, where] = requested->second;
    const std::optional<fs::path> folder = local_folder(version, sources_.manifest.file.parent_path());
    return folder ? find_local(name, *folder, where) : find_cached(name);
  }

  std::optional<PackageRoot> find_local(const std::string& name, const fs::path& folder,
                                        const std::string& where) {
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) return std::nullopt;
    if (!sources_.bounds.contain_package(folder)) {
      say(where, hlsl::Severity::warning, outside_package(name, folder));
      outside_.insert(name);
      return std::nullopt;
    }
    try {
      const PackageManifest manifest = read_package_manifest(folder);
      if (!manifest.name.empty() && manifest.name != name)
        say(where, hlsl::Severity::warning,
            "'" + name + "' is required, but " + folder.string() + " holds the package '" + manifest.name +
                "'; correct the name or the path");
    } catch (const InputError& error) {
      problems_.push_back(diagnostic_from(error, folder / "package.json", hlsl::Severity::warning));
    }
    return PackageRoot{name, folder, {}, PackageOrigin::local};
  }

  std::optional<PackageRoot> find_cached(const std::string& name) {
    const auto cached = sources_.cache.by_name.find(name);
    if (cached == sources_.cache.by_name.end()) return std::nullopt;
    WantedPackage wanted{name, {}, {}, {}};
    std::string where = sources_.manifest.file.string();
    if (const auto locked = sources_.manifest.locked.find(name); locked != sources_.manifest.locked.end()) {
      wanted.locked_version = locked->second.version;
      wanted.locked_hash = locked->second.hash;
    }
    if (const auto request = sources_.manifest.requested.find(name);
        request != sources_.manifest.requested.end()) {
      wanted.requested_version = request->second.version;
      where = request->second.where;
    }
    const CacheChoice choice = choose_cached(cached->second, wanted);
    if (!choice.note.empty()) say(where, hlsl::Severity::note, choice.note);
    if (!choice.warning.empty()) say(where, hlsl::Severity::warning, choice.warning);
    return PackageRoot{name, choice.package.directory, choice.package.version, PackageOrigin::cache};
  }

  void report_missing() {
    std::sort(missing_.begin(), missing_.end());
    if (!sources_.cache.found && missing_.size() > 1) {
      report_missing_cache();
      return;
    }
    for (const std::string& name : missing_) report_missing(name, sources_.manifest.requested.at(name));
  }

  void report_missing(const std::string& name, const RequestedPackage& request) {
    const std::optional<fs::path> folder =
        local_folder(request.version, sources_.manifest.file.parent_path());
    const std::string tried = folder ? "there is no folder " + folder->string()
                                     : "it is neither embedded in Packages/ nor in Library/PackageCache";
    say(request.where, hlsl::Severity::warning,
        "'" + name + "' (" + request.version + ") was not found: " + tried +
            "; open the project once in the Unity editor, or give --package-root " + name + "=DIR");
  }

  void report_missing_cache() {
    constexpr std::size_t shown = 6;
    std::string list;
    for (std::size_t i = 0; i < std::min(shown, missing_.size()); ++i)
      list.append(i == 0 ? "" : ", ").append(missing_[i]);
    if (missing_.size() > shown) list += " and " + std::to_string(missing_.size() - shown) + " more";
    say(sources_.manifest.requested.at(missing_.front()).where, hlsl::Severity::warning,
        std::to_string(missing_.size()) + " packages were not found, because the project has no " +
            "Library/PackageCache: " + list + "; open the project once in the Unity editor, or give " +
            "--package-root NAME=FOLDER for each that the shaders include");
  }

  void say(const std::string& where, hlsl::Severity severity, std::string message) {
    problems_.push_back(diagnostic_at(where, severity, std::move(message)));
  }

  const PackageSources& sources_;
  std::vector<hlsl::Diagnostic>& problems_;
  std::map<std::string, std::optional<PackageRoot>> found_;
  std::queue<std::string> waiting_;
  std::vector<std::string> missing_;
  std::set<std::string> outside_;  // already reported
};

// Returns the roots by name. A package of manifest.json that is not found is a warning at its line there; if
// the whole cache is missing, there is one warning for all.
std::vector<PackageRoot> find_packages(const PackageSources& sources,
                                       std::vector<hlsl::Diagnostic>& problems) {
  return PackageSearch(sources, problems).run();
}

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

std::optional<EditorVersion> parse_editor_version(std::string_view text) {
  std::array<int, 3> numbers{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) {
      if (rest.empty() || rest.front() != '.') return std::nullopt;
      rest.remove_prefix(1);
    }
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), numbers[i]);
    if (error != std::errc() || numbers[i] < 0 || numbers[i] > 9999) return std::nullopt;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  }
  return EditorVersion{numbers[0], numbers[1], numbers[2], std::string(text)};
}

int unity_version_number(const EditorVersion& version) {
  if (version.major >= 6000)
    return version.major / 1000 * 10'000'000 + version.minor * 10'000 + version.patch;
  return version.major * 100 + version.minor * 10 + version.patch;
}

}  // namespace penumbra::project
