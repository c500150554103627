#include "project/package_version.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "input/input_error.h"
#include "project/json_diagnostic.h"
#include "project/package_manifest.h"

namespace penumbra::project {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_identifier_character(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '.';
}

// Takes a number of at most nine digits off the front.
std::optional<std::uint32_t> take_number(std::string_view& text) {
  std::size_t digits = 0;
  while (digits < text.size() && is_digit(text[digits])) ++digits;
  if (digits == 0 || digits > 9) return std::nullopt;
  std::uint32_t number = 0;
  std::from_chars(text.data(), text.data() + digits, number);
  text.remove_prefix(digits);
  return number;
}

bool take(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

std::string_view take_identifier(std::string_view& text) {
  const std::string_view identifier = text.substr(0, text.find('.'));
  text.remove_prefix(std::min(text.size(), identifier.size() + 1));
  return identifier;
}

std::string_view without_leading_zeros(std::string_view number) {
  while (number.size() > 1 && number.front() == '0') number.remove_prefix(1);
  return number;
}

std::strong_ordering compare_identifiers(std::string_view a, std::string_view b) {
  const bool a_is_number = !a.empty() && std::all_of(a.begin(), a.end(), is_digit);
  const bool b_is_number = !b.empty() && std::all_of(b.begin(), b.end(), is_digit);
  if (a_is_number != b_is_number)
    return a_is_number ? std::strong_ordering::less : std::strong_ordering::greater;
  if (!a_is_number) return a <=> b;
  a = without_leading_zeros(a);
  b = without_leading_zeros(b);
  return a.size() != b.size() ? a.size() <=> b.size() : a <=> b;
}

std::strong_ordering compare_prereleases(std::string_view a, std::string_view b) {
  // A release is newer than its pre-releases.
  if (a.empty() || b.empty()) return a.empty() <=> b.empty();
  while (!a.empty() && !b.empty()) {
    const std::strong_ordering order = compare_identifiers(take_identifier(a), take_identifier(b));
    if (order != std::strong_ordering::equal) return order;
  }
  return b.empty() <=> a.empty();  // the one with more identifiers is newer
}

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

std::optional<PackageVersion> parse_package_version(std::string_view text) {
  const auto major = take_number(text);
  if (!major || !take(text, '.')) return std::nullopt;
  const auto minor = take_number(text);
  if (!minor || !take(text, '.')) return std::nullopt;
  const auto patch = take_number(text);
  if (!patch) return std::nullopt;
  PackageVersion version{*major, *minor, *patch};
  const std::string_view rest = text.substr(0, text.find('+'));
  if (rest.empty()) return version;
  if (rest.front() != '-' || rest.size() == 1) return std::nullopt;
  if (!std::all_of(rest.begin(), rest.end(), is_identifier_character)) return std::nullopt;
  version.prerelease = rest.substr(1);
  return version;
}

std::strong_ordering operator<=>(const PackageVersion& a, const PackageVersion& b) {
  if (a.major != b.major) return a.major <=> b.major;
  if (a.minor != b.minor) return a.minor <=> b.minor;
  if (a.patch != b.patch) return a.patch <=> b.patch;
  return compare_prereleases(a.prerelease, b.prerelease);
}

bool operator==(const PackageVersion& a, const PackageVersion& b) {
  return (a <=> b) == std::strong_ordering::equal;
}

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
