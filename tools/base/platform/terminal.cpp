#include "platform/terminal.h"

#include <chrono>
#include <cstdlib>
#include <string>

#ifdef _WIN32
#include <io.h>
#include <windows.h>
#else
#include <unistd.h>
#endif

namespace penumbra::platform {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  return value == nullptr ? std::string() : std::string(value);
}

}  // namespace

bool stderr_is_terminal() {
#ifdef _WIN32
  return _isatty(2) != 0;
#else
  return ::isatty(STDERR_FILENO) != 0;
#endif
}

bool stdout_is_terminal() {
#ifdef _WIN32
  return _isatty(1) != 0;
#else
  return ::isatty(STDOUT_FILENO) != 0;
#endif
}

bool colour_wanted_on_stdout() {
  return stdout_is_terminal() && environment("NO_COLOR").empty();
}

std::filesystem::path program_path() {
#ifdef _WIN32
  wchar_t buffer[MAX_PATH];
  const DWORD length = GetModuleFileNameW(nullptr, buffer, MAX_PATH);
  return std::wstring(buffer, length);
#else
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error);
#endif
}

std::filesystem::path program_directory() {
  const std::filesystem::path program = program_path();
  return program.empty() ? std::filesystem::current_path() : program.parent_path();
}

std::filesystem::path temporary_directory() {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  return error ? std::filesystem::path("/tmp") : folder;
}

std::filesystem::path new_private_directory(const std::string& prefix, const std::filesystem::path& parent) {
#ifdef _WIN32
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  std::filesystem::path folder = parent / (prefix + "-" + std::to_string(now));
  std::error_code error;
  return std::filesystem::create_directory(folder, error) ? folder : std::filesystem::path();
#else
  std::string name = (parent / (prefix + "-XXXXXX")).string();
  return mkdtemp(name.data()) == nullptr ? std::filesystem::path() : std::filesystem::path(name);
#endif
}

}  // namespace penumbra::platform
