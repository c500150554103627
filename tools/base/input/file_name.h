// Names of files that are made of names in untrusted files.
#pragma once

#include <string>

namespace penumbra {

// Returns the name with '-' in place of every character but letters, digits, '-', '_' and '.', at most so
// long.
std::string file_name_part(std::string name, std::size_t longest = 255);

}  // namespace penumbra
