#include "platform/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <list>
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

namespace fs = std::filesystem;

// Returns the outermost checkout: a link may lead into a repository of its own.
fs::path checkout_of(const fs::path& path) {
  std::error_code error;
  const fs::path current = fs::current_path(error);
  fs::path checkout;
  for (fs::path folder = path.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
    if (folder == current || fs::exists(folder / ".git", error)) checkout = folder;
  return checkout;
}

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
                   reason == EFBIG
                       ? "raise the limit on the size of files (ulimit -f); the file was not changed"
                   : full ? "free some space or choose another folder; the file was not changed"
                          : "check the folder and its permissions; the file was not changed");
}

#ifdef _WIN32
std::FILE* open_device(const std::filesystem::path& file) {
  return std::fopen(file.string().c_str(), "wb");
}
#else
// The reader of a pipe may still start; it may also never come, so the wait has an end.
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
                     "start its reader first; the file was not changed");
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

// Returns a file beside another one, under a name at which nobody can put a link or a pipe beforehand.
std::filesystem::path random_name(const std::filesystem::path& file, const char* ending) {
  std::random_device random;
  const std::uint64_t word = (static_cast<std::uint64_t>(random()) << 32U) | random();
  return file.parent_path() / ("." + file.filename().string() + "." + std::to_string(word) + ending);
}

// Returns false where the file's kind cannot be read: then it may be a file. A checkout's link to a device is
// replaced as its links to files are.
bool is_device(const std::filesystem::path& file) {
  std::error_code unreadable;
  if (link_of_checkout(file)) return false;
  const std::filesystem::file_type type = std::filesystem::status(file, unreadable).type();
  return type == std::filesystem::file_type::character || type == std::filesystem::file_type::block ||
         type == std::filesystem::file_type::fifo || type == std::filesystem::file_type::socket;
}

// Checks the folder that holds the file.
void refuse_linked_folder(const std::filesystem::path& file, const std::filesystem::path& named) {
  const std::optional<std::filesystem::path> link = link_of_checkout(file.parent_path());
  if (!link) return;
  throw InputError(named.string(),
                   "cannot be written: '" + link->string() + "' is a link, which is not followed",
                   "name the folder that it leads to, or remove the link; the file was not changed");
}

void refuse_folders(const std::filesystem::path& file) {
  refuse_linked_folder(file, file);
  std::error_code status;
  if (std::filesystem::is_directory(file, status)) fail(file, EISDIR);
}

void try_to_write(const std::filesystem::path& file, const std::filesystem::path& named) {
  refuse_linked_folder(file, named);
  const FileWrite writing;
  TemporaryFile temporary(file);
  if (temporary.stream() == nullptr) fail(named, errno);
}

// The old content of a file, until the files that belong to it are replaced, too.
class OldFile {
 public:
  // Keeps a second name of the file, or a copy where the file system has no second names.
  explicit OldFile(const std::filesystem::path& file) : file_(file) {
    std::error_code error;
    if (std::filesystem::symlink_status(file, error).type() == std::filesystem::file_type::not_found) return;
    kept_ = random_name(file, ".old");
    std::filesystem::create_hard_link(file, kept_, error);
    if (error) std::filesystem::copy_file(file, kept_, error);
    if (error) {
      discard();
      fail(file, error.value());
    }
  }
  ~OldFile() { discard(); }
  OldFile(const OldFile&) = delete;
  OldFile& operator=(const OldFile&) = delete;

  // Throws InputError, and leaves the copy, if that fails.
  void put_back() {
    std::error_code error;
    if (kept_.empty())
      std::filesystem::remove(file_, error);
    else
      std::filesystem::rename(kept_, file_, error);
    const std::filesystem::path kept = std::exchange(kept_, {});
    if (error)
      throw InputError(file_.string(),
                       "was replaced, and a file that belongs to it could not be: " + error.message(),
                       kept.empty() ? "remove it" : "what it held before is in '" + kept.string() + "'");
  }

 private:
  void discard() {
    std::error_code ignored;
    if (!kept_.empty()) std::filesystem::remove(kept_, ignored);
  }

  std::filesystem::path file_;
  std::filesystem::path kept_;  // empty if there was no file
};

// A file that is whole and on the disk, but not in its place yet.
class NewFile {
 public:
  NewFile(const std::filesystem::path& file, std::string_view content) : file_(file), temporary_(file) {
    if (temporary_.stream() == nullptr) fail(file, errno);
    errno = 0;
    const bool written =
        std::fwrite(content.data(), 1, content.size(), temporary_.stream()) == content.size() &&
        flush_to_disk(temporary_.stream());
    const int reason = errno;
    const bool closed = temporary_.close();
    if (!written || !closed) fail(file, reason != 0 ? reason : errno);
  }

  void keep_old() { old_.emplace(file_); }
  std::error_code place() { return temporary_.rename(file_); }
  void put_back() {
    if (old_) old_->put_back();
  }
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  TemporaryFile temporary_;
  std::optional<OldFile> old_;
};

// Places all of them, or none.
void place_all(std::list<NewFile>& files) {
  for (auto file = files.begin(); file != files.end(); ++file)
    if (std::next(file) != files.end()) file->keep_old();
  for (auto file = files.begin(); file != files.end(); ++file) {
    const std::error_code error = file->place();
    if (!error) continue;
    for (auto placed = file; placed != files.begin();) (--placed)->put_back();
    fail(file->file(), error.value());
  }
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& file) {
  constexpr int kMostAttempts = 16;
  for (int attempt = 0; attempt < kMostAttempts && stream_ == nullptr; ++attempt) {
    path_ = random_name(file, ".part");
    stream_ = std::fopen(path_.string().c_str(), "wbx");
    if (stream_ == nullptr && errno != EEXIST) break;
  }
  if (stream_ == nullptr) path_.clear();  // that file is not this one's to remove
}

TemporaryFile::~TemporaryFile() {
  close();
  std::error_code ignored;
  if (!renamed_ && !path_.empty()) fs::remove(path_, ignored);
}

bool TemporaryFile::close() {
  std::FILE* stream = std::exchange(stream_, nullptr);
  return stream == nullptr || std::fclose(stream) == 0;
}

std::error_code TemporaryFile::rename(const fs::path& file) {
  std::error_code error;
  fs::rename(path_, file, error);
  renamed_ = !error;
  return error;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void check_file_can_be_written(const std::filesystem::path& file) {
  refuse_folders(file);
  if (is_device(file)) return;
  try_to_write(file, file);
}

void check_folder_can_be_written(const std::filesystem::path& folder, const std::filesystem::path& named) {
  try_to_write(folder / "penumbra-output", named);
}

void write_files_atomically(const std::vector<FileContent>& files) {
  for (const FileContent& file : files) {
    refuse_folders(file.file);
    if (files.size() > 1 && is_device(file.file))
      throw InputError(file.file.string(),
                       "is a device or a pipe, and one of several files that belong together",
                       "remove it, or choose another name; the file was not changed");
  }
  const FileWrite writing;
  if (files.size() == 1 && is_device(files.front().file))
    return write_straight(files.front().file, files.front().content);
  std::list<NewFile> written;
  for (const FileContent& file : files) written.emplace_back(file.file, file.content);
  place_all(written);
}

void write_file_atomically(const std::filesystem::path& file, std::string_view content) {
  write_files_atomically({{file, content}});
}

void write_file_atomically(const std::filesystem::path& file, std::span<const std::byte> content) {
  write_file_atomically(file, text_of(content));
}

bool is_below(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

std::optional<fs::path> link_below(const fs::path& folder, const fs::path& path) {
  std::error_code error;
  const fs::path normal = fs::absolute(folder, error).lexically_normal();
  const fs::path top = normal.has_filename() ? normal : normal.parent_path();
  fs::path reached;  // keeps every "..": after a link, it leads elsewhere than the text says
  for (const fs::path& part : fs::absolute(path, error)) {
    reached /= part;
    const fs::path inside = reached.lexically_normal();
    if (inside != top && is_below(inside, top) && fs::is_symlink(fs::symlink_status(reached, error)))
      return reached;
  }
  return std::nullopt;
}

std::optional<fs::path> link_of_checkout(const fs::path& path) {
  std::error_code error;
  const fs::path checkout = checkout_of(fs::absolute(path, error).lexically_normal());
  return checkout.empty() ? std::nullopt : link_below(checkout, path);
}

}  // namespace penumbra::platform
