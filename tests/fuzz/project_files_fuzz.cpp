// Reads the JSON files of a Unity project, and its editor's version. The first byte says which file the rest
// is.
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "project/package_version.h"
#include "project/unity_project.h"

namespace penumbra::fuzz {

namespace {

const char* const files[] = {"Packages/manifest.json", "Packages/packages-lock.json",
                             "Library/PackageCache/com.x.a@1.0.0/package.json", "Packages/e/package.json",
                             "ProjectSettings/ProjectVersion.txt"};

const char* const healthy[] = {
    R"({"dependencies": {"com.x.a": "1.0.0", "com.x.c": "https://h/c.git#1"}})",
    R"({"dependencies": {"com.x.c": {"version": "https://h/c.git#1", "hash": "24c1c38f35bd3111"}}})",
    R"({"name": "com.x.a", "version": "1.0.0-pre.1", "dependencies": {"com.x.b": "1.0.0"}})",
    R"({"name": "com.x.e", "version": "2.0.0", "dependencies": {"com.unity.render-pipelines.core": "1.0.0"}})",
    "m_EditorVersion: 2022.3.20f1\n"};

}  // namespace

void targets::project_files(std::string_view bytes) {
  static const ScratchFolder folder;
  static std::size_t written = 0;  // the file that is not healthy
  static bool first = true;
  if (first)
    for (std::size_t i = 0; i < std::size(files); ++i) folder.write(files[i], healthy[i]);
  first = false;
  folder.write(files[written], healthy[written]);
  written = take_byte(bytes) % std::size(files);
  folder.write(files[written], bytes);
  read([&] {
    const project::UnityProject project = project::read_project(folder.path());
    for (const project::PackageRoot& root : project.packages)
      require(!root.directory.empty(), "a package has a folder");
    for (const hlsl::Diagnostic& problem : project.problems) require_harmless(hlsl::format(problem));
    for (const hlsl::Diagnostic& problem : project::version_problems(project.packages))
      require_harmless(hlsl::format(problem));
  });
}

}  // namespace penumbra::fuzz
