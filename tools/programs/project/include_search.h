// What a Unity shader's #include names, in Unity's order: package roots and the project's Assets/, then
// beside the including file, then the include directories, then the editor's CGIncludes (Unity manual,
// "include and include_with_pragmas directives in HLSL").
//
// Unity's own forgiveness is kept: backslashes, doubled slashes, "./" and "../", a version behind a package's
// name (Packages/NAME@1.2.3/...). Files outside of the roots are not read (include_bounds.h). Case counts;
// when nothing has exactly that name, one file that differs only in case is taken, as disks of Windows and
// macOS do, with a warning that names the right spelling.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "project/package_root.h"

namespace penumbra::project {

struct IncludeRoots {
  std::vector<PackageRoot> packages;
  std::vector<std::filesystem::path> directories;
  std::filesystem::path project;  // holds Assets/; empty when there is none
  std::filesystem::path cginc;    // the editor's CGIncludes; empty when there is none
  std::vector<std::filesystem::path>
      own;  // own_tree() of what is compiled: not searched, but includes may lead there
};

struct IncludeSearch {
  std::optional<std::filesystem::path> file;  // lexically normal
  std::vector<std::filesystem::path> absent;  // places before it in the order, where there is nothing
  std::string warning;                        // the file was found, but not by its own spelling
  std::string problem;                        // why there is none, places tried and way out
  std::string missing_editor_include;         // its name, when it is one that only the editor has
};

// `includer`: the file that has the #include. A result has either a file or a problem.
IncludeSearch find_include(const IncludeRoots& roots, std::string_view asked,
                           const std::filesystem::path& includer);

}  // namespace penumbra::project
