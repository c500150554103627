#include "project/project_manifest.h"

#include "input/located_json.h"
#include "project/folder_entries.h"

namespace penumbra::project {

namespace fs = std::filesystem;

ProjectManifest read_project_manifest(const fs::path& packages) {
  ProjectManifest manifest;
  manifest.file = packages / "manifest.json";
  if (is_there(manifest.file)) {
    manifest.found = true;
    const LocatedJson document = LocatedJson::read_found(manifest.file);
    JsonObject dependencies = JsonObject(document).object("dependencies");
    for (const std::string& name : dependencies.keys())
      manifest.requested[name] = {dependencies.text(name, ""), dependencies.where(name)};
  }
  const fs::path lock = packages / "packages-lock.json";
  if (is_there(lock)) {
    manifest.found = true;
    const LocatedJson document = LocatedJson::read_found(lock);
    JsonObject dependencies = JsonObject(document).object("dependencies");
    for (const std::string& name : dependencies.keys()) {
      JsonObject package = dependencies.object(name);
      manifest.locked[name] = {package.text("version", ""), package.text("hash", "")};
    }
  }
  return manifest;
}

}  // namespace penumbra::project
