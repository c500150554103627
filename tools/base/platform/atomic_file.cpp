#include "platform/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "input/input_error.h"
#include "platform/interrupt.h"

#ifdef _WIN32
#include <io.h>
#include <process.h>
#else
#include <fcntl.h>
#include <unistd.h>
#endif

namespace penumbra::platform {
namespace {

#ifdef _WIN32
int process_id() {
  return _getpid();
}
bool flush_to_disk(std::FILE* stream) {
  return std::fflush(stream) == 0 && _commit(_fileno(stream)) == 0;
}
#else
int process_id() {
  return static_cast<int>(::getpid());
}
bool flush_to_disk(std::FILE* stream) {
  return std::fflush(stream) == 0 && ::fsync(fileno(stream)) == 0;
}
#endif

[[noreturn]] void fail(const std::filesystem::path& file, const std::filesystem::path& temporary,
                       int reason) {
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  const bool full = reason == ENOSPC;
  throw InputError(file.string(), std::string("cannot be written: ") + std::strerror(reason),
                   full ? "free some space or choose another folder; nothing was changed"
                        : "check the folder and its permissions; nothing was changed");
}

// A device or a pipe stores no content that could be lost; a rename would replace it by a file.
void write_straight(const std::filesystem::path& file, std::string_view content) {
  std::FILE* stream = std::fopen(file.string().c_str(), "wb");
  if (stream == nullptr) fail(file, {}, errno);
  errno = 0;
  const bool written = std::fwrite(content.data(), 1, content.size(), stream) == content.size();
  const int reason = errno;
  const bool closed = std::fclose(stream) == 0;
  if (!written || !closed) fail(file, {}, reason != 0 ? reason : errno);
}

std::filesystem::path temporary_beside(const std::filesystem::path& file) {
  return file.parent_path() / ("." + file.filename().string() + "." + std::to_string(process_id()) + ".part");
}

void try_to_write(const std::filesystem::path& temporary, const std::filesystem::path& named) {
  const FileWrite writing;
  std::FILE* stream = std::fopen(temporary.string().c_str(), "wb");
  if (stream == nullptr) fail(named, temporary, errno);
  std::fclose(stream);
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
}

}  // namespace

void check_file_can_be_written(const std::filesystem::path& file) {
  const std::filesystem::path temporary = temporary_beside(file);
  std::error_code status;
  if (std::filesystem::is_directory(file, status)) fail(file, temporary, EISDIR);
  if (std::filesystem::exists(file, status) && !std::filesystem::is_regular_file(file, status)) return;
  try_to_write(temporary, file);
}

void check_folder_can_be_written(const std::filesystem::path& folder, const std::filesystem::path& named) {
  try_to_write(temporary_beside(folder / "penumbra-output"), named);
}

void write_file_atomically(const std::filesystem::path& file, std::string_view content) {
  const std::filesystem::path temporary = temporary_beside(file);
  std::error_code status;
  if (std::filesystem::is_directory(file, status)) fail(file, temporary, EISDIR);
  if (std::filesystem::exists(file, status) && !std::filesystem::is_regular_file(file, status))
    return write_straight(file, content);
  const FileWrite writing;
  std::FILE* stream = std::fopen(temporary.string().c_str(), "wb");
  if (stream == nullptr) fail(file, temporary, errno);
  errno = 0;
  const bool written =
      std::fwrite(content.data(), 1, content.size(), stream) == content.size() && flush_to_disk(stream);
  const int reason = errno;
  const bool closed = std::fclose(stream) == 0;
  if (!written || !closed) fail(file, temporary, reason != 0 ? reason : errno);
  std::error_code error;
  std::filesystem::rename(temporary, file, error);
  if (error) fail(file, temporary, error.value());
}

void write_file_atomically(const std::filesystem::path& file, std::span<const std::byte> content) {
  write_file_atomically(file,
                        std::string_view(reinterpret_cast<const char*>(content.data()), content.size()));
}

}  // namespace penumbra::platform
