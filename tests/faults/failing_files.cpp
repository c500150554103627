// The C library's functions under their own names: a program's definitions come before the library's, for the
// C++ library's calls, too.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "faults/fault_counter.h"

namespace {

using penumbra::faults::FileCall;

// Finds the library's own function of that name.
template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

bool fails(FileCall call) {
  const int reason = penumbra::faults::file_call_fails(call);
  if (reason != 0) errno = reason;
  return reason != 0;
}

FileCall use_of(const char* mode) {
  return mode[0] == 'r' && mode[1] != '+' ? FileCall::reads : FileCall::changes;
}

}  // namespace

extern "C" {

std::FILE* fopen(const char* path, const char* mode) {
  static const auto real = next<std::FILE* (*)(const char*, const char*)>("fopen");
  return fails(use_of(mode)) ? nullptr : real(path, mode);
}

std::FILE* fopen64(const char* path, const char* mode) {
  static const auto real = next<std::FILE* (*)(const char*, const char*)>("fopen64");
  return fails(use_of(mode)) ? nullptr : real(path, mode);
}

std::size_t fwrite(const void* data, std::size_t size, std::size_t count, std::FILE* stream) {
  static const auto real = next<std::size_t (*)(const void*, std::size_t, std::size_t, std::FILE*)>("fwrite");
  if (stream == stdout || stream == stderr || !fails(FileCall::changes))
    return real(data, size, count, stream);
  const int reason = errno;
  const std::size_t written = real(data, size, count / 2, stream);
  errno = reason;
  return written;
}

int fflush(std::FILE* stream) {
  static const auto real = next<int (*)(std::FILE*)>("fflush");
  const bool ours = stream != nullptr && stream != stdout && stream != stderr;
  return ours && fails(FileCall::changes) ? EOF : real(stream);
}

// The stream is closed either way, as close(2) leaves its descriptor.
int fclose(std::FILE* stream) {
  static const auto real = next<int (*)(std::FILE*)>("fclose");
  const bool failed = fails(FileCall::changes);
  const int reason = errno;
  const int result = real(stream);
  if (failed) errno = reason;
  return failed ? EOF : result;
}

// The call is not passed on: whether bytes have reached the disk cannot be seen here, and waiting for it
// takes most of the time.
int fsync(int /*descriptor*/) {
  return fails(FileCall::changes) ? -1 : 0;
}

off64_t lseek64(int descriptor, off64_t offset, int whence) noexcept {
  static const auto real = next<off64_t (*)(int, off64_t, int)>("lseek64");
  return fails(FileCall::reads) ? -1 : real(descriptor, offset, whence);
}

ssize_t read(int descriptor, void* data, std::size_t size) {
  static const auto real = next<ssize_t (*)(int, void*, std::size_t)>("read");
  return fails(FileCall::reads) ? -1 : real(descriptor, data, size);
}

ssize_t write(int descriptor, const void* data, std::size_t size) {
  static const auto real = next<ssize_t (*)(int, const void*, std::size_t)>("write");
  if (descriptor <= 2 || !fails(FileCall::changes)) return real(descriptor, data, size);
  return size > 1 ? real(descriptor, data, size / 2) : -1;
}

ssize_t writev(int descriptor, const iovec* pieces, int count) {
  static const auto real = next<ssize_t (*)(int, const iovec*, int)>("writev");
  return descriptor > 2 && fails(FileCall::changes) ? -1 : real(descriptor, pieces, count);
}

int rename(const char* from, const char* to) noexcept {
  static const auto real = next<int (*)(const char*, const char*)>("rename");
  return fails(FileCall::changes) ? -1 : real(from, to);
}

int mkdir(const char* path, mode_t mode) noexcept {
  static const auto real = next<int (*)(const char*, mode_t)>("mkdir");
  return fails(FileCall::changes) ? -1 : real(path, mode);
}

int remove(const char* path) noexcept {
  static const auto real = next<int (*)(const char*)>("remove");
  return fails(FileCall::changes) ? -1 : real(path);
}

int stat(const char* path, struct stat* status) noexcept {
  static const auto real = next<int (*)(const char*, struct stat*)>("stat");
  return fails(FileCall::reads) ? -1 : real(path, status);
}

int lstat(const char* path, struct stat* status) noexcept {
  static const auto real = next<int (*)(const char*, struct stat*)>("lstat");
  return fails(FileCall::reads) ? -1 : real(path, status);
}

DIR* fdopendir(int descriptor) {
  static const auto real = next<DIR* (*)(int)>("fdopendir");
  return fails(FileCall::reads) ? nullptr : real(descriptor);
}

dirent* readdir(DIR* folder) {
  static const auto real = next<dirent* (*)(DIR*)>("readdir");
  return fails(FileCall::reads) ? nullptr : real(folder);
}

int utimensat(int folder, const char* path, const timespec times[2], int flags) noexcept {
  static const auto real = next<int (*)(int, const char*, const timespec[2], int)>("utimensat");
  return fails(FileCall::changes) ? -1 : real(folder, path, times, flags);
}
}
