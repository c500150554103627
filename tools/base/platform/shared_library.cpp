#include "platform/shared_library.h"

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace penumbra::platform {

void* function_of(const std::filesystem::path& library, const char* name) {
#ifdef _WIN32
  const HMODULE loaded = LoadLibraryW(library.c_str());
  return loaded == nullptr ? nullptr : reinterpret_cast<void*>(GetProcAddress(loaded, name));
#else
  void* const loaded = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  return loaded == nullptr ? nullptr : ::dlsym(loaded, name);
#endif
}

}  // namespace penumbra::platform
