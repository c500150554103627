#include <cerrno>
#include <cstdio>
#include <cstring>

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

}  // namespace penumbra::cli
