// A function of a shared library that is named at run time. Windows only.
#pragma once

#include <filesystem>

namespace penumbra::platform {

// Returns the function's address; null if the library cannot be loaded or has no such function. The library
// stays loaded.
void* function_of(const std::filesystem::path& library, const char* name);

}  // namespace penumbra::platform
