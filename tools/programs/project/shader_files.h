// The shader files of a Unity project or of given folders: every .shader and .compute that Unity would
// import.
//
// Unity ignores files and folders whose name begins with '.', ends with '~', is "cvs", or ends in ".tmp"
// (Unity manual, "Reserved folder name reference", hidden assets), and folders of Packages/ without a
// package.json. Every folder is visited once, whatever symbolic links lead to it.
#pragma once

#include <filesystem>
#include <string_view>

#include "hlsl/diagnostic.h"

namespace penumbra::project {

struct ShaderSelection {
  // The folders and files to search; if empty, Assets/ and Packages/ of the project. An .hlsl file is found
  // only when it is named here itself.
  std::vector<std::filesystem::path> places;
  // These are patterns (path_matches()) on ShaderFile::shown; without `include` every file counts. They apply
  // to files named in `places`, too: hooks name the files of a commit, and their settings leave folders out.
  std::vector<std::string> include;
  std::vector<std::string> exclude;
};

struct ShaderFile {
  std::filesystem::path path;
  std::string shown;   // relative to the project where it is below it, with '/'
  bool named = false;  // named by the user; else it was found in a folder
};

struct ShaderFiles {
  std::vector<ShaderFile> files;  // sorted by `shown`
  std::vector<hlsl::Diagnostic>
      problems;  // warnings: a folder that cannot be listed, a link to nothing, a pattern without a match,
                 // Shader Graphs; notes: named files that a pattern leaves out
};

// Throws InputError unless find_shader_files() accepts the file; for a Shader Graph, the message says what to
// do.
void require_shader_file(const std::filesystem::path& file);

// `project` may be empty when `places` are given. Throws InputError for a place that is missing or is a file
// of another kind, for folders without any shader, and, with the nearest name, where no pattern of `include`
// matches any file and no place is one.
ShaderFiles find_shader_files(const std::filesystem::path& project, const ShaderSelection& selection);

// Matches paths against a pattern such as "Assets/Water/**".
//
//   ?     one character, not '/'
//   *     any characters, not '/'
//   **    any characters; "**/" between slashes also no folder at all
//
// Every other character matches itself; case-sensitive. A pattern without '/' is matched against the file's
// name only, one with '/' against the whole path. The time is the product of both lengths, whatever the
// pattern.
//
// `path` has '/' as separator.
bool path_matches(std::string_view pattern, std::string_view path);

}  // namespace penumbra::project
