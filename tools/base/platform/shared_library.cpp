#include "platform/shared_library.h"

#include <windows.h>

namespace penumbra::platform {

void* function_of(const std::filesystem::path& library, const char* name) {
  const HMODULE loaded = LoadLibraryW(library.c_str());
  return loaded == nullptr ? nullptr : reinterpret_cast<void*>(GetProcAddress(loaded, name));
}

}  // namespace penumbra::platform
