// Identifies the build: cached results are valid only for the code that produced them.
#pragma once

#include <string>

namespace penumbra::platform {

// The identity changes with this program and with every shared library that it links: it covers their build
// ids (the linker's note, elf(5) NT_GNU_BUILD_ID), or size and date of a file that has none. It is a
// ContentHash::hex().
const std::string& build_identity();

}  // namespace penumbra::platform
