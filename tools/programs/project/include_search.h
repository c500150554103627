// Resolves a Unity shader's #include, in Unity's order: package roots and the project's Assets/, then beside
// the including file, then beside the file that is compiled, then the include directories, then the editor's
// CGIncludes (Unity manual, "include and include_with_pragmas directives in HLSL").
//
// Unity's leniency is kept: backslashes, doubled slashes, "./" and "../", a version after a package's name
// (Packages/NAME@1.2.3/...). Files outside of the roots are not read (include_bounds.h). Names are
// case-sensitive; if there is no exact match, one file that differs only in case is taken, as on Windows and
// macOS, with a warning that gives the right spelling.
#pragma once

#include <optional>
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
      own;  // own_tree() of the compiled file: not searched, but includes may lead there
  std::filesystem::path main_folder;  // folder of the file that is compiled; else empty
};

struct IncludeSearch {
  std::optional<std::filesystem::path> file;  // lexically normal
  std::vector<std::filesystem::path> absent;  // candidates earlier in the order that do not exist
  std::string warning;                        // the file was found under a different spelling
  std::string problem;                        // why there is none, the candidates tried and what to do
  std::string missing_editor_include;         // name of the include, if only the editor has it
};

// `includer` is the file that has the #include; it is empty for a text that is in no file, beside which there
// is nothing. A result has either a file or a problem.
IncludeSearch find_include(const IncludeRoots& roots, std::string_view asked,
                           const std::filesystem::path& includer);

}  // namespace penumbra::project
