#include "project/include_bounds.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "input/input_error.h"
#include "platform/atomic_file.h"
#include "platform/cache_store.h"
#include "project/folder_entries.h"
#include "project/package_manifest.h"

namespace penumbra::project {

namespace fs = std::filesystem;

namespace {

constexpr const char* git_folder = ".git";

fs::path without_links(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error).lexically_normal();
  fs::path real = fs::weakly_canonical(absolute, error);
  if (error) real = absolute;
  return real.has_filename() || real == real.root_path() ? real : real.parent_path();
}

bool is_unity_project(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "Assets", ignored) &&
         fs::is_directory(folder / "ProjectSettings", ignored);
}

// Returns the nearest folder above the file for which `is_one` holds; empty without one. Some people keep
// their home folder in git.
template <typename IsOne>
fs::path nearest_above(const fs::path& file, IsOne is_one) {
  for (fs::path folder = file.parent_path(); folder != folder.root_path(); folder = folder.parent_path())
    if (is_one(folder) && !no_file_owns(folder)) return folder;
  return {};
}

}  // namespace

// HOME may be missing or name another folder, as under cron: the system's own entry of the user holds too.
bool no_file_owns(const fs::path& folder) {
  static const fs::path listed = platform::listed_home();
  static const fs::path entered = listed.empty() ? listed : without_links(listed);
  const char* home = std::getenv("HOME");
  const fs::path real = without_links(folder);
  return real == real.root_path() || (!entered.empty() && real == entered) ||
         (home != nullptr && *home != '\0' && real == without_links(home));
}

fs::path own_tree(const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error).lexically_normal();
  const auto has_git = [](const fs::path& folder) { return is_there(folder / git_folder); };
  fs::path tree = nearest_above(absolute, has_git);
  if (tree.empty()) tree = nearest_above(absolute, is_unity_project);
  if (tree.empty()) tree = nearest_above(absolute, has_package_manifest);
  if (tree.empty()) tree = absolute.parent_path();
  return no_file_owns(tree) ? absolute : tree;
}

fs::path project_of(const fs::path& file) {
  std::error_code error;
  fs::path absolute = fs::absolute(file, error).lexically_normal();
  if (!absolute.has_filename()) absolute = absolute.parent_path();  // "Assets/"
  const fs::path project = nearest_above(absolute, is_unity_project);
  if (project.empty()) return {};
  const fs::path first = *absolute.lexically_relative(project).begin();
  return first == "Assets" || first == "Packages" ? project : fs::path();
}

void IncludeBounds::add(const fs::path& root) {
  if (!root.empty()) roots_.push_back(without_links(root));
}

bool IncludeBounds::contain(const fs::path& file) const {
  const fs::path real = without_links(file);
  if (std::find(real.begin(), real.end(), git_folder) != real.end()) return false;
  return std::any_of(roots_.begin(), roots_.end(),
                     [&](const fs::path& root) { return platform::is_below(real, root); });
}

void IncludeBounds::require(const fs::path& file) const {
  if (is_there(file) && !contain(file))
    throw InputError(file.string(),
                     "is a symbolic link to outside of the project and its repository, and is not read",
                     "put the file itself there");
}

}  // namespace penumbra::project
