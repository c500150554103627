#include "platform/linked_folder.h"

#include <system_error>

namespace penumbra::platform {
namespace {

namespace fs = std::filesystem;

// Returns the outermost checkout: a link may lead into a repository of its own.
fs::path checkout_of(const fs::path& path) {
  std::error_code error;
  const fs::path current = fs::current_path(error);
  fs::path checkout;
  for (fs::path folder = path.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
    if (folder == current || fs::exists(folder / ".git", error)) checkout = folder;
  return checkout;
}

bool lies_below(const fs::path& path, const fs::path& folder) {
  const fs::path inside = path.lexically_normal().lexically_relative(folder);
  return !inside.empty() && *inside.begin() != ".." && *inside.begin() != ".";
}

}  // namespace

std::optional<fs::path> link_below(const fs::path& folder, const fs::path& path) {
  std::error_code error;
  const fs::path top = fs::absolute(folder, error).lexically_normal();
  fs::path reached;  // keeps every "..": after a link, it leads elsewhere than the text says
  for (const fs::path& part : fs::absolute(path, error)) {
    reached /= part;
    if (lies_below(reached, top) && fs::is_symlink(fs::symlink_status(reached, error))) return reached;
  }
  return std::nullopt;
}

std::optional<fs::path> link_of_checkout(const fs::path& path) {
  std::error_code error;
  const fs::path checkout = checkout_of(fs::absolute(path, error).lexically_normal());
  return checkout.empty() ? std::nullopt : link_below(checkout, path);
}

}  // namespace penumbra::platform
