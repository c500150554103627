#include "platform/atomic_file.h"

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "input/input_error.h"
#include "platform/interrupt.h"

#ifdef _WIN32
#include <io.h>
#else
#include <fcntl.h>
#include <unistd.h>
#endif

namespace penumbra::platform {
namespace {

#ifdef _WIN32
bool flush_to_disk(std::FILE* stream) {
  return std::fflush(stream) == 0 && _commit(_fileno(stream)) == 0;
}
#else
bool flush_to_disk(std::FILE* stream) {
  return std::fflush(stream) == 0 && ::fsync(fileno(stream)) == 0;
}
#endif

[[noreturn]] void fail(const std::filesystem::path& file, int reason) {
  const bool full = reason == ENOSPC;
  throw InputError(file.string(), std::string("cannot be written: ") + std::strerror(reason),
                   reason == EFBIG ? "raise the limit on the size of files (ulimit -f); nothing was changed"
                   : full          ? "free some space or choose another folder; nothing was changed"
                                   : "check the folder and its permissions; nothing was changed");
}

#ifdef _WIN32
std::FILE* open_device(const std::filesystem::path& file) {
  return std::fopen(file.string().c_str(), "wb");
}
#else
// The reader of a pipe may be starting; it may also never come, so that it is not waited for without end.
std::FILE* open_device(const std::filesystem::path& file) {
  constexpr int kAttempts = 250;
  int descriptor = -1;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    descriptor = ::open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor >= 0 || errno != ENXIO) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    errno = ENXIO;
  }
  if (descriptor < 0 && errno == ENXIO)
    throw InputError(file.string(), "cannot be written: it is a pipe that no program reads",
                     "start its reader first; nothing was changed");
  if (descriptor < 0) return nullptr;
  (void)::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return ::fdopen(descriptor, "wb");
}
#endif

// A device or a pipe stores no content that could be lost; a rename would replace it by a file.
void write_straight(const std::filesystem::path& file, std::string_view content) {
  std::FILE* stream = open_device(file);
  if (stream == nullptr) fail(file, errno);
  errno = 0;
  const bool written = std::fwrite(content.data(), 1, content.size(), stream) == content.size();
  const int reason = errno;
  const bool closed = std::fclose(stream) == 0;
  if (!written || !closed) fail(file, reason != 0 ? reason : errno);
}

// Nobody can put a link or a pipe in its place beforehand: its name is random, and it must not exist.
class Temporary {
 public:
  // Throws InputError, naming `named`.
  Temporary(const std::filesystem::path& file, const std::filesystem::path& named) {
    for (int attempt = 0; attempt < kMostAttempts && stream_ == nullptr; ++attempt) {
      path_ = file.parent_path() / ("." + file.filename().string() + "." + random_word() + ".part");
      stream_ = std::fopen(path_.string().c_str(), "wbx");
      if (stream_ == nullptr && errno != EEXIST) break;
    }
    if (stream_ == nullptr) fail(named, errno);
  }
  ~Temporary() {
    close();
    std::error_code ignored;
    if (!renamed_) std::filesystem::remove(path_, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  std::FILE* stream() { return stream_; }
  bool close() {
    std::FILE* stream = std::exchange(stream_, nullptr);
    return stream == nullptr || std::fclose(stream) == 0;
  }
  std::error_code rename(const std::filesystem::path& file) {
    std::error_code error;
    std::filesystem::rename(path_, file, error);
    renamed_ = !error;
    return error;
  }

 private:
  static constexpr int kMostAttempts = 16;

  static std::string random_word() {
    std::random_device random;
    return std::to_string((static_cast<std::uint64_t>(random()) << 32U) | random());
  }

  std::filesystem::path path_;
  std::FILE* stream_ = nullptr;
  bool renamed_ = false;
};

// Not where its kind cannot be read: then it may be a file.
bool is_device(const std::filesystem::path& file) {
  std::error_code unreadable;
  const std::filesystem::file_type type = std::filesystem::status(file, unreadable).type();
  return type == std::filesystem::file_type::character || type == std::filesystem::file_type::block ||
         type == std::filesystem::file_type::fifo || type == std::filesystem::file_type::socket;
}

void try_to_write(const std::filesystem::path& file, const std::filesystem::path& named) {
  const FileWrite writing;
  const Temporary temporary(file, named);
}

}  // namespace

void check_file_can_be_written(const std::filesystem::path& file) {
  std::error_code status;
  if (std::filesystem::is_directory(file, status)) fail(file, EISDIR);
  if (is_device(file)) return;
  try_to_write(file, file);
}

void check_folder_can_be_written(const std::filesystem::path& folder, const std::filesystem::path& named) {
  try_to_write(folder / "penumbra-output", named);
}

void write_file_atomically(const std::filesystem::path& file, std::string_view content) {
  std::error_code status;
  if (std::filesystem::is_directory(file, status)) fail(file, EISDIR);
  if (is_device(file)) return write_straight(file, content);
  const FileWrite writing;
  Temporary temporary(file, file);
  errno = 0;
  const bool written = std::fwrite(content.data(), 1, content.size(), temporary.stream()) == content.size() &&
                       flush_to_disk(temporary.stream());
  const int reason = errno;
  const bool closed = temporary.close();
  if (!written || !closed) fail(file, reason != 0 ? reason : errno);
  if (const std::error_code error = temporary.rename(file)) fail(file, error.value());
}

void write_file_atomically(const std::filesystem::path& file, std::span<const std::byte> content) {
  write_file_atomically(file,
                        std::string_view(reinterpret_cast<const char*>(content.data()), content.size()));
}

}  // namespace penumbra::platform
