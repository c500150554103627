#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "cli/subcommand.h"
#include "input/input_error.h"
#include "platform/atomic_file.h"

namespace penumbra::cli {

void write_output(const std::string& file, std::string_view content) {
  if (!file.empty() && file != "-") {
    platform::write_file_atomically(file, content);
    return;
  }
  const bool written = std::fwrite(content.data(), 1, content.size(), stdout) == content.size();
  if (!written || std::fflush(stdout) != 0) {
    throw InputError("standard output", std::string("cannot be written: ") + std::strerror(errno));
  }
}

void check_output_file(const std::string& file) {
  if (!file.empty() && file != "-") platform::check_file_can_be_written(file);
}

void check_output_folder(const std::string& folder) {
  if (folder.empty()) return;
  std::error_code status;
  std::filesystem::path there = std::filesystem::absolute(folder).lexically_normal();
  while (!std::filesystem::exists(there, status) && there != there.parent_path()) there = there.parent_path();
  if (!std::filesystem::is_directory(there, status)) {
    throw InputError(folder, "'" + there.string() + "' is a file, not a folder");
  }
  platform::check_file_can_be_written(there / "penumbra-output");
}

}  // namespace penumbra::cli
