#include <filesystem>
#include <optional>

#include "architecture/rules.h"
#include "architecture/source_lines.h"

namespace penumbra::architecture {
namespace {

constexpr std::string_view kPackage = "Packages/com.penumbra.shadows/";

struct Layer {
  int height;
  std::string folder;
};

// The layer of a path; nothing for a path that is none of the package's.
std::optional<Layer> layer_of(std::string_view path) {
  static const std::map<std::string, int, std::less<>> heights{
      {"Platform", 0}, {"Core", 1},   {"Map", 2},         {"Filters", 3},  {"Screen", 3},
      {"Far", 3},      {"Fields", 3}, {"ScreenTiles", 4}, {"Pipelines", 4}};
  if (path.starts_with("Shaders/")) return Layer{6, "Shaders"};
  if (!path.starts_with("ShaderLibrary/")) return std::nullopt;
  const std::string folder = folder_below(path, "ShaderLibrary/");
  if (folder.empty()) return Layer{5, folder};
  const auto known = heights.find(folder);
  // A folder without a place may be included by none and include none.
  return Layer{known == heights.end() ? -1 : known->second, folder};
}

std::string resolved(const Include& include) {
  if (include.target.starts_with(kPackage)) return include.target.substr(kPackage.size());
  if (include.target.starts_with("Packages/")) return include.target;
  const std::filesystem::path folder = std::filesystem::path(include.path).parent_path();
  return (folder / include.target).lexically_normal().generic_string();
}

}  // namespace

Violations shader_includes_point_down(const Tree& tree) {
  Violations found;
  for (const std::string_view root : {"ShaderLibrary/", "Shaders/"}) {
    for (const Include& include : includes_of(tree, root)) {
      const std::string target = resolved(include);
      const std::optional<Layer> user = layer_of(include.path), used = layer_of(target);
      if (!used) {
        if (!target.starts_with("Packages/")) {
          found.push_back(
              violation(include.path, include.line, "includes " + target + ", outside the library"));
        }
        continue;
      }
      const bool same = user->folder == used->folder && user->height == used->height && user->height >= 0;
      if (!same && (used->height < 0 || user->height <= used->height)) {
        found.push_back(violation(include.path, include.line, "must not include " + target));
      }
    }
  }
  return found;
}

}  // namespace penumbra::architecture
