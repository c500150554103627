#include "project/folder_entries.h"

#include <algorithm>
#include <system_error>

#include "input/input_error.h"

namespace penumbra::project {

namespace fs = std::filesystem;

std::vector<fs::path> folders_in(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored)) folders.push_back(entry->path());
  }
  if (error) throw InputError(folder.string(), "cannot be listed: " + error.message());
  std::sort(folders.begin(), folders.end());
  return folders;
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

}  // namespace penumbra::project
