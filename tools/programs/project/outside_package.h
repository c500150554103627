// A package that the project's files name and that is outside of the project and its repository: an untrusted
// project could name any folder of this machine. Internal to this folder.
#pragma once

#include <filesystem>
#include <string>

namespace penumbra::project {

inline std::string outside_package(const std::string& name, const std::filesystem::path& folder) {
  return "'" + name + "' lies outside of the project and its repository, in " + folder.string() +
         ": nothing is read there; if you trust it, give --package-root " + name + "=" + folder.string();
}

}  // namespace penumbra::project
