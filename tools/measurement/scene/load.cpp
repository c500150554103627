#include <algorithm>

#include "input/input_error.h"
#include "input/nearest_name.h"
#include "scene/scene.h"

namespace penumbra::scene {
namespace {

constexpr std::string_view kPackagePrefix = "package:";

bool looks_like_a_file(std::string_view text) {
  if (text.find_first_of("/\\.") != std::string_view::npos) return true;
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::path(text), ignored);
}

}  // namespace

const std::vector<PackageModel>& package_models() {
  static const std::vector<PackageModel> models{
      {"glmark2/horse", "glmark2-data", "glmark2/models/horse.3ds", "a rearing horse, 2.5 m tall", 2.5, true},
      {"glmark2/bunny", "glmark2-data", "glmark2/models/bunny.obj", "the Stanford bunny, 2 m tall", 2.0},
      {"glmark2/cat", "glmark2-data", "glmark2/models/cat.3ds", "a cat, 1 m tall", 1.0, true},
      {"assimp/milk-truck", "assimp-testmodels", "assimp/models/glTF/CesiumMilkTruck/CesiumMilkTruck.gltf",
       "a painted milk truck, 2.4 m tall", 2.4},
      {"assimp/engine", "assimp-testmodels",
       "assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
       "an engine of two cylinders with cooling fins and gears, 1.2 m tall", 1.2},
  };
  return models;
}

Scene package_model(std::string_view name, const ImportOptions& options, const std::filesystem::path& share) {
  const std::vector<PackageModel>& models = package_models();
  const auto found =
      std::find_if(models.begin(), models.end(), [&](const auto& m) { return m.name == name; });
  if (found == models.end()) {
    std::vector<std::string> names;
    names.reserve(models.size());
    for (const PackageModel& model : models) names.push_back(model.name);
    throw InputError("", "unknown package model '" + std::string(name) + "'",
                     unknown_name_remedy(name, names));
  }
  const std::filesystem::path file = share / found->file;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    throw EnvironmentError("the model '" + found->name + "' was not found at " + file.string() +
                           "\n  it comes with the Debian package " + found->debian_package +
                           ": apt-get install " + found->debian_package);
  }
  ImportOptions scaled = options;
  const bool own_scale =
      options.height_metres > 0.0 || options.metres_per_unit != ImportOptions{}.metres_per_unit;
  if (!own_scale) scaled.height_metres = found->height_metres;
  scaled.minus_z_up = found->minus_z_up && !options.z_up;
  Scene scene = import_apart(file, scaled);
  scene.name = found->name;
  scene.description = found->description + ", from the Debian package " + found->debian_package;
  return scene;
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names = built_in_names();
  for (const PackageModel& model : package_models())
    names.push_back(std::string(kPackagePrefix) + model.name);
  return names;
}

Scene load(std::string_view name_or_file, const ImportOptions& options) {
  const std::vector<std::string> names = all_built_in_names();
  if (std::find(names.begin(), names.end(), name_or_file) != names.end()) return built_in(name_or_file);
  if (name_or_file.starts_with(kPackagePrefix)) {
    return package_model(name_or_file.substr(kPackagePrefix.size()), options);
  }
  std::vector<std::string> known = scene_names();
  known.insert(known.end(), names.begin(), names.end());
  if (looks_like_a_file(name_or_file)) return import_apart(std::filesystem::path(name_or_file), options);
  throw InputError("", "'" + std::string(name_or_file) + "' is neither a known scene nor a file",
                   unknown_name_remedy(name_or_file, known));
}

}  // namespace penumbra::scene
