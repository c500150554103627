// A Unity project folder, read without Unity: the places of its packages, and the editor that it is for.
//
// A package is searched where Unity's Package Manager searches, in its order (Unity manual, "Embedded
// dependencies", "Local folder or tarball paths", "Git dependencies", "Lock files"):
// 1. roots given by hand;
// 2. a folder of Packages/ that holds a package.json; the name in there counts, not the folder's;
// 3. "file:PATH" in Packages/manifest.json, relative to Packages/;
// 4. Library/PackageCache: of several versions the one that packages-lock.json names, then manifest.json,
//    else the highest, with a note.
// A package that lies outside of the project and its repository after links are followed is left out with a
// warning, unless it was given by hand. The packages are those that manifest and lock request and their
// dependencies; without either file they are all that the cache holds. Engine modules (com.unity.modules.*)
// are built into the editor and have no files.
#pragma once

#include <optional>
#include <string_view>

#include "hlsl/diagnostic.h"
#include "project/package_root.h"

namespace penumbra::project {

// The Unity editor's version, and the number that its shaders see as UNITY_VERSION.
//
// Unity manual, "Branch based on Unity version": YYYYMP up to 2023 (2022.3.0 is 202230), 6MMMPPPP from Unity
// 6 (6000.2.3 is 60020003). For a patch above 9 the page says only that it cannot be tested for. The editor
// does not clamp it but carries into the next digit: shader code that 2017.4.18 generated has UNITY_VERSION
// 201758, and there was no 2017.5.
struct EditorVersion {
  int major = 0;     // 2022, 6000
  int minor = 0;     // 3
  int patch = 0;     // 20
  std::string text;  // 2022.3.20f1
};

// Parses "2022.3.20f1" and similar; returns nothing if the text does not begin with three numbers.
std::optional<EditorVersion> parse_editor_version(std::string_view text);

int unity_version_number(const EditorVersion& version);

struct UnityProject {
  std::filesystem::path directory;
  std::optional<EditorVersion> editor;     // ProjectSettings/ProjectVersion.txt
  std::vector<PackageRoot> packages;       // one for each name, sorted by name
  std::vector<hlsl::Diagnostic> problems;  // problems and choices, from notes to errors
};

// Throws InputError when the folder is missing or no Unity project (it holds neither Assets/ nor Packages/),
// when Packages/ or Library/PackageCache/ cannot be listed, and when manifest.json or packages-lock.json is
// broken.
UnityProject read_project(const std::filesystem::path& directory, const std::vector<PackageRoot>& given = {});

}  // namespace penumbra::project
