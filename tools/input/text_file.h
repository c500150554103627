// A whole file as a text.
#pragma once

#include <filesystem>
#include <string>

namespace penumbra {

// Throws InputError, naming the file, when it cannot be opened.
std::string read_text_file(const std::filesystem::path& file);

}  // namespace penumbra
