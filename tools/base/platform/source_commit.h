// The commit of this repository from which this program and the shaders it reads come.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace penumbra::platform {

// git's 40 hex digits of the commit that the program was built from, followed by "-dirty" if the program's
// sources were changed then, or differ from that commit now: shaders are read at run time. Absent if the
// program was not built in a checkout, as from a tarball.
std::optional<std::string> source_commit();

// The same of a program that was built from `built` and reads its shaders from `folder`. Where there is no
// git, or no checkout, as in an installed copy, nothing tells the shaders from those of the build.
std::optional<std::string> source_commit_in(const std::string& built, const std::filesystem::path& folder);

}  // namespace penumbra::platform
