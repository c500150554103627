#include "project/caseless_file.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "project/ascii_case.h"

namespace penumbra::project {

namespace fs = std::filesystem;

namespace {

// More occur only on maliciously prepared disks; two are already ambiguous.
constexpr std::size_t most_paths = 8;

void add_matches(const fs::path& folder, const std::string& name, std::vector<fs::path>& found) {
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string entry_name = entry->path().filename().string();
    if (equal_ignoring_case(entry_name, name)) found.push_back(folder / entry_name);
  }
}

}  // namespace

std::vector<fs::path> files_ignoring_case(const fs::path& base, const fs::path& rest) {
  std::vector<fs::path> paths{base};
  for (const fs::path& component : rest) {
    std::vector<fs::path> next;
    for (const fs::path& folder : paths) {
      if (component == "." || component == "..")
        next.push_back(folder / component);
      else
        add_matches(folder, component.string(), next);
    }
    std::sort(next.begin(), next.end());
    if (next.size() > most_paths) next.resize(most_paths);
    paths = std::move(next);
  }
  return rest.empty() ? std::vector<fs::path>() : paths;
}

}  // namespace penumbra::project
