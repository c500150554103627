#include "scene/model_folder.h"

#include <algorithm>
#include <string_view>
#include <system_error>

namespace penumbra::scene {

namespace fs = std::filesystem;

std::optional<fs::path> in_model_folder(const fs::path& path, const fs::path& model) {
  std::error_code error;
  const fs::path folder = fs::canonical(model.has_parent_path() ? model.parent_path() : fs::path("."), error);
  if (error) return std::nullopt;
  const fs::path resolved = fs::weakly_canonical(folder / path, error);
  const fs::path relative = resolved.lexically_relative(folder);
  if (error || relative.empty() || *relative.begin() == "..") return std::nullopt;
  return resolved;
}

// The library gives paths relative to the working directory.
bool ModelFolder::allows(const std::string& file) const {
  std::error_code error;
  if (fs::path(file) == model_) return true;
  const std::optional<fs::path> inside = in_model_folder(fs::absolute(file, error), model_);
  if (!error && inside && fs::is_regular_file(*inside, error)) return true;  // a pipe has no end
  if (inside && !fs::exists(*inside, error)) {
    const std::string name = inside->filename().string();
    if (std::find(missing_.begin(), missing_.end(), name) == missing_.end()) missing_.push_back(name);
  } else if (refused_.empty()) {
    refused_ = file;
  }
  return false;
}

Assimp::IOStream* ModelFolder::Open(const char* file, const char* mode) {
  const bool writes = std::string_view(mode).find_first_of("wa+") != std::string_view::npos;
  return !writes && allows(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
}

}  // namespace penumbra::scene
