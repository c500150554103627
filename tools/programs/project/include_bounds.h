// The folders outside of which no #include is read: diagnostics quote lines of the files, and a shader may
// come from an untrusted source.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra::project {

// Returns the folder that a file belongs to with all that is below it: its git working tree, else its Unity
// project (a folder that holds Assets/ and ProjectSettings/), else its package (a folder with a
// package.json), else the folder it is in. It is never a folder that no_file_owns(): for a file in such a
// folder, it is the file alone.
std::filesystem::path own_tree(const std::filesystem::path& file);

// Returns the nearest Unity project above the file or folder, if it is in that project's Assets or Packages,
// where Unity imports it; else empty.
std::filesystem::path project_of(const std::filesystem::path& file);

// Returns whether it is the disk's root or the user's home folder. What is below those belongs to no single
// file of theirs, and holds credentials: includes are read from such a folder only if the user names it.
bool no_file_owns(const std::filesystem::path& folder);

class IncludeBounds {
 public:
  void add(const std::filesystem::path& root);  // a folder or a single file

  // Returns whether the file is one of the roots or below one, after symbolic links are resolved. Files in a
  // .git folder are never accepted: they may contain credentials.
  bool contain(const std::filesystem::path& file) const;
  // It is for the folder of a package that the project's own files name: these must not extend what is read.
  bool contain_package(const std::filesystem::path& folder) const { return contain(folder / "package.json"); }

  // Throws InputError where a file that a project always has is a link to outside: its text would be quoted.
  void require(const std::filesystem::path& file) const;

 private:
  std::vector<std::filesystem::path> roots_;  // paths without links
};

}  // namespace penumbra::project
