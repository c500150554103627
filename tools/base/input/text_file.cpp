#include "input/text_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

#include "input/input_error.h"

namespace penumbra {

namespace fs = std::filesystem;

namespace {

// Opening a named pipe blocks until there is a writer. The pipes of a shell's <(...) have no path of their
// own.
bool is_named_pipe(const fs::path& file) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  return !error && fs::is_fifo(real, error);
}

}  // namespace

std::string read_text_file(const fs::path& file, std::size_t largest) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) throw InputError(file.string(), "is a folder, not a file");
  if (is_named_pipe(file))
    throw InputError(file.string(), "is a named pipe, which may have no writer",
                     "give a regular file, or <(command) in the shell");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string(), "cannot be opened", "check the path and its permissions");
  std::string text;
  for (std::array<char, 65536> part{}; stream.read(part.data(), part.size()), stream.gcount() > 0;) {
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > largest)
      throw InputError(file.string(),
                       "has more than " + std::to_string(largest) + " bytes, the size limit of such a file");
  }
  if (stream.bad()) throw InputError(file.string(), "cannot be read");
  return text;
}

void require_regular_file(const fs::path& file) {
  std::error_code ignored;
  const fs::file_type type = fs::status(file, ignored).type();
  if (type == fs::file_type::fifo || type == fs::file_type::character || type == fs::file_type::block ||
      type == fs::file_type::socket)
    throw InputError(file.string(), "is a device or a pipe, not a regular file",
                     "write its content to a file");
}

std::string read_found_text_file(const fs::path& file, std::size_t largest) {
  require_regular_file(file);
  return read_text_file(file, largest);
}

std::optional<std::string> rest_of(std::istream& stream) {
  std::string text;
  for (std::array<char, 65536> part{}; stream.read(part.data(), part.size()), stream.gcount() > 0;)
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) return std::nullopt;
  return text;
}

}  // namespace penumbra
