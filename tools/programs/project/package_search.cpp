#include "project/package_search.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <queue>
#include <set>
#include <system_error>
#include <utility>

#include "input/input_error.h"
#include "project/json_diagnostic.h"
#include "project/outside_package.h"
#include "project/package_manifest.h"
#include "project/package_version.h"

namespace penumbra::project {

namespace fs = std::filesystem;

namespace {

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

}  // namespace

std::vector<PackageRoot> find_packages(const PackageSources& sources,
                                       std::vector<hlsl::Diagnostic>& problems) {
  return PackageSearch(sources, problems).run();
}

}  // namespace penumbra::project
