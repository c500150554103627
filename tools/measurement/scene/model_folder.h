// The files that a model may read: those in its own folder. Internal to this folder.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace penumbra::scene {

// Returns `path`, relative to the model's folder or absolute, with its links resolved; empty outside of that
// folder. The file need not exist.
std::optional<std::filesystem::path> in_model_folder(const std::filesystem::path& path,
                                                     const std::filesystem::path& model);

// The importer library opens files through it: the model, and buffers and material libraries in its folder.
class ModelFolder final : public Assimp::DefaultIOSystem {
 public:
  explicit ModelFolder(std::filesystem::path model) : model_(std::move(model)) {}

  bool Exists(const char* file) const override { return allows(file) && DefaultIOSystem::Exists(file); }
  Assimp::IOStream* Open(const char* file, const char* mode = "rb") override;

  // Returns the first file outside of the folder that the model named; empty if there is none.
  const std::string& refused() const { return refused_; }
  // Returns the files in the folder that the model named and that are not there, each once.
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  bool allows(const std::string& file) const;

  std::filesystem::path model_;
  mutable std::string refused_;
  mutable std::vector<std::string> missing_;
};

}  // namespace penumbra::scene
