// A folder that goes with the test, and the pieces of a Unity project written into it.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "hlsl/diagnostic.h"

namespace penumbra::project {

class ProjectFolder {
 public:
  ProjectFolder() {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("penumbra-project-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(folder_);
  }
  ~ProjectFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  ProjectFolder(const ProjectFolder&) = delete;
  ProjectFolder& operator=(const ProjectFolder&) = delete;

  std::filesystem::path path(const std::string& name = {}) const {
    return name.empty() ? folder_ : folder_ / name;
  }

  std::string text(const std::string& name) const { return path(name).string(); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::filesystem::remove(path(name));  // ext4 waits for the disk when a file is cut and written again
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  // Writes FOLDER/package.json; `dependencies` is the inside of its object.
  std::filesystem::path package(const std::string& folder, const std::string& name,
                                const std::string& version, const std::string& dependencies = {}) const {
    write(folder + "/package.json", "{\n  \"name\": \"" + name + "\",\n  \"version\": \"" + version +
                                        "\",\n  \"dependencies\": {" + dependencies + "}\n}\n");
    return path(folder);
  }

  // Writes Packages/manifest.json with each dependency ("name": "version") on a line of its own, the first on
  // line 3.
  void manifest(const std::vector<std::string>& dependencies) const {
    write("Packages/manifest.json", "{\n  \"dependencies\": {\n" + lines(dependencies) + "  }\n}\n");
  }

  void lock(const std::vector<std::string>& dependencies) const {
    write("Packages/packages-lock.json", "{\n  \"dependencies\": {\n" + lines(dependencies) + "  }\n}\n");
  }

 private:
  static std::string lines(const std::vector<std::string>& dependencies) {
    std::string text;
    for (std::size_t i = 0; i < dependencies.size(); ++i)
      text += "    " + dependencies[i] + (i + 1 < dependencies.size() ? ",\n" : "\n");
    return text;
  }

  std::filesystem::path folder_;
};

inline std::vector<std::string> formatted(const std::vector<hlsl::Diagnostic>& diagnostics) {
  std::vector<std::string> texts(diagnostics.size());
  std::transform(diagnostics.begin(), diagnostics.end(), texts.begin(), hlsl::format);
  return texts;
}

// All diagnostics but notes.
inline std::vector<std::string> warnings_of(const std::vector<hlsl::Diagnostic>& diagnostics) {
  std::vector<std::string> texts;
  for (const hlsl::Diagnostic& diagnostic : diagnostics)
    if (diagnostic.severity != hlsl::Severity::note) texts.push_back(format(diagnostic));
  return texts;
}

}  // namespace penumbra::project
