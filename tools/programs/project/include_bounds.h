// The folders outside of which no #include is read: messages show lines of the files they are about, and a
// shader may come from anywhere.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra::project {

// The folder that a file belongs to with all that is below it: its git working tree, else its Unity project
// (a folder that holds Assets/ and ProjectSettings/), else its package (a folder with a package.json), else
// the folder it is in.
std::filesystem::path own_tree(const std::filesystem::path& file);

class IncludeBounds {
 public:
  void add(const std::filesystem::path& root);  // a folder, or a file that stands for itself

  // Whether the file is one of the roots or below one, after links are followed. What is in a .git folder
  // never is: it may hold credentials.
  bool contain(const std::filesystem::path& file) const;
  // Of the folder of a package that the project's own files name. What they say must not widen what is read.
  bool contain_package(const std::filesystem::path& folder) const { return contain(folder / "package.json"); }

 private:
  std::vector<std::filesystem::path> roots_;  // without links
};

}  // namespace penumbra::project
