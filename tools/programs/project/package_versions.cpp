#include "project/package_versions.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "input/input_error.h"
#include "project/json_diagnostic.h"
#include "project/package_manifest.h"
#include "project/package_version.h"

namespace penumbra::project {

namespace {

struct Package {
  PackageRoot root;
  PackageManifest manifest;
};
using Packages = std::map<std::string, Package>;

bool is_render_pipeline(std::string_view name) {
  constexpr std::string_view prefix = "com.unity.render-pipelines.";
  return name.substr(0, prefix.size()) == prefix;
}

bool ships_with_pipelines(std::string_view name) {
  return is_render_pipeline(name) || name == "com.unity.shadergraph" || name == "com.unity.visualeffectgraph";
}

bool is_config(std::string_view name) {
  constexpr std::string_view suffix = "-config";
  return name.size() > suffix.size() && name.substr(name.size() - suffix.size()) == suffix;
}

std::string title(const std::string& name, const std::string& version) {
  return version.empty() ? name : name + " " + version;
}

Packages read_packages(const std::vector<PackageRoot>& roots, std::vector<hlsl::Diagnostic>& problems) {
  Packages packages;
  for (const PackageRoot& root : roots) {
    if (packages.count(root.name) != 0) continue;
    PackageManifest manifest;
    if (has_package_manifest(root.directory)) {
      try {
        manifest = read_package_manifest(root.directory);
      } catch (const InputError& error) {  // read_project has reported it for a project's packages
        if (root.origin == PackageOrigin::given)
          problems.push_back(
              diagnostic_from(error, root.directory / "package.json", hlsl::Severity::warning));
      }
    }
    packages.emplace(root.name, Package{root, std::move(manifest)});
  }
  return packages;
}

// Describes the incompatibility between a package and one of its dependencies; empty if there is none.
std::string problem_with(const Package& package, const PackageDependency& dependency,
                         const Packages& packages) {
  const std::string needs = title(package.root.name, package.manifest.version) + " needs " +
                            title(dependency.name, dependency.version);
  const std::string remedy = "give --package-root " + dependency.name + "=DIR with version ";
  const auto found = packages.find(dependency.name);
  if (found == packages.end())
    return is_render_pipeline(dependency.name)
               ? needs + ", but no package root is given for it; " + remedy + dependency.version
               : std::string();
  const std::string& actual = found->second.manifest.version;
  const std::optional<PackageVersion> have = parse_package_version(actual);
  const std::optional<PackageVersion> want = parse_package_version(dependency.version);
  if (!have || !want) return {};
  const std::string but = needs + ", but " + found->second.root.directory.string() + " is " + actual;
  if (!ships_with_pipelines(package.root.name) || !ships_with_pipelines(dependency.name))
    return *have < *want ? but + "; " + remedy + dependency.version + " or newer" : std::string();
  const bool fits = is_config(dependency.name) ? have->major == want->major && have->minor == want->minor
                                               : have->same_release_as(*want);
  if (fits) return {};
  return but + "; packages of Unity's render pipelines fit only at the same release, and errors such as " +
         "\"redefinition\" or an unknown 'Pow2' may follow from this; " + remedy + dependency.version;
}

}  // namespace

std::vector<hlsl::Diagnostic> version_problems(const std::vector<PackageRoot>& roots) {
  std::vector<hlsl::Diagnostic> problems;
  const Packages packages = read_packages(roots, problems);
  for (const auto& [name, package] : packages) {
    if (!package.manifest.name.empty() && package.manifest.name != name)
      problems.push_back(diagnostic_of(
          package.root.directory / "package.json", hlsl::Severity::warning,
          "the package is '" + package.manifest.name + "', but its folder is given as '" + name + "'"));
    for (const PackageDependency& dependency : package.manifest.dependencies)
      if (std::string problem = problem_with(package, dependency, packages); !problem.empty())
        problems.push_back(diagnostic_at(dependency.where, hlsl::Severity::warning, std::move(problem)));
  }
  return problems;
}

}  // namespace penumbra::project
