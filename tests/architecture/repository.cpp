#include "architecture/repository.h"

#include <fstream>
#include <iterator>
#include <set>

namespace penumbra::architecture {
namespace {

bool is_skipped_folder(const std::filesystem::path& folder) {
  static const std::set<std::string> skipped{".git", "build", ".cache", "report", "node_modules"};
  return skipped.contains(folder.filename().string());
}

}  // namespace

Tree read_repository(const std::filesystem::path& root) {
  Tree tree;
  using Walk = std::filesystem::recursive_directory_iterator;
  for (Walk it(root), end; it != end; ++it) {
    if (it->is_directory() && is_skipped_folder(it->path())) {
      it.disable_recursion_pending();
    } else if (it->is_regular_file() && it->path().filename() != ".git") {  // a worktree's is a file
      std::ifstream file(it->path(), std::ios::binary);
      std::string text{std::istreambuf_iterator<char>(file), {}};
      const bool binary = text.find('\0') != std::string::npos;
      if (!binary) tree[it->path().lexically_relative(root).generic_string()] = std::move(text);
    }
  }
  return tree;
}

}  // namespace penumbra::architecture
