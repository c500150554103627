// The text of this repository as a Tree: what is ours, without build folders and other ignored places.
#pragma once

#include <filesystem>

#include "architecture/rules.h"

namespace penumbra::architecture {

Tree read_repository(const std::filesystem::path& root);

}  // namespace penumbra::architecture
