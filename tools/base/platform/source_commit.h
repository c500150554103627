// The commit of this repository from which this program and the shaders it reads come.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace penumbra::platform {

// Returns git's 40 hex digits of the commit from which the program was built, followed by "-dirty" if the
// program's sources were changed then, or differ from that commit now: shaders are read at run time. Absent
// if the program was not built in a checkout, as from a tarball.
std::optional<std::string> source_commit();

// Returns the same for a program that was built from `built` and reads its shaders from `folder`. Without git
// or a checkout, as in an installed copy, the shaders cannot be distinguished from those of the build.
std::optional<std::string> source_commit_in(const std::string& built, const std::filesystem::path& folder);

}  // namespace penumbra::platform
