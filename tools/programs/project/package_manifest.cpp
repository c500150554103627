#include "project/package_manifest.h"

#include <system_error>

#include "input/located_json.h"

namespace penumbra::project {

namespace fs = std::filesystem;

namespace {

constexpr const char* file_name = "package.json";

}  // namespace

bool has_package_manifest(const fs::path& package) {
  std::error_code ignored;
  return fs::is_regular_file(package / file_name, ignored);
}

PackageManifest read_package_manifest(const fs::path& package) {
  const LocatedJson document = LocatedJson::read_found(package / file_name);
  JsonObject object(document);
  PackageManifest manifest;
  manifest.name = object.text("name", "");
  manifest.version = object.text("version", "");
  manifest.where = object.where("version");
  JsonObject dependencies = object.object("dependencies");
  for (const std::string& name : dependencies.keys())
    manifest.dependencies.push_back({name, dependencies.text(name, ""), dependencies.where(name)});
  return manifest;
}

}  // namespace penumbra::project
