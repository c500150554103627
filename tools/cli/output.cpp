#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "cli/subcommand.h"
#include "input/input_error.h"
#include "platform/atomic_file.h"
#include "platform/cache_store.h"

namespace penumbra::cli {
namespace {

// Returns the folder itself, or its nearest existing parent. Throws InputError if that is a file.
std::filesystem::path nearest_folder(const std::filesystem::path& folder) {
  std::error_code status;
  std::filesystem::path there = std::filesystem::absolute(folder).lexically_normal();
  while (!std::filesystem::exists(there, status) && there != there.parent_path()) there = there.parent_path();
  if (!std::filesystem::is_directory(there, status))
    throw InputError(folder.string(), "'" + there.string() + "' is a file, not a folder");
  return there;
}

// Throws InputError that names the folder as it was given.
void check_folder(const std::filesystem::path& given) {
  platform::check_folder_can_be_written(nearest_folder(given), given);
}

// Returns why nothing can or may be cached there; empty if it can.
std::string cache_problem(const std::filesystem::path& folder) {
  if (folder.empty()) return "neither HOME nor XDG_CACHE_HOME names a folder for the cache";
  if (std::string problem = platform::cache_folder_problem(folder); !problem.empty())
    return "what is in the cache may be somebody else's: " + problem;
  try {
    // The cache's folder may be behind a link of the user's; its entries may not.
    platform::check_folder_can_be_written(std::filesystem::weakly_canonical(nearest_folder(folder)), folder);
  } catch (const InputError& error) {
    return std::string("the cache cannot be written: ") + error.what();
  }
  return {};
}

}  // namespace

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

void refuse_input_as_output(const std::string& option, const std::string& output,
                            const std::vector<std::string>& inputs) {
  if (output.empty() || output == "-") return;
  for (const std::string& input : inputs) {
    std::error_code ignored;
    if (!input.empty() && std::filesystem::equivalent(output, input, ignored))
      throw InputError(option, "'" + output + "' is a file that this run reads", "name another file");
  }
}

void refuse_report_over_source(const std::string& option, const std::string& output) {
  std::error_code ignored;
  if (!std::filesystem::exists(output, ignored)) return;
  for (const char* ending : {".hlsl", ".hlsli", ".hlslinc", ".cginc", ".glslinc", ".shader", ".compute",
                             ".shadergraph", ".technique.json"}) {
    if (output.ends_with(ending))
      throw InputError(option, "'" + output + "' is a source file, which the report would replace",
                       "name another file, or delete this one before");
  }
}

void check_output_folder(const std::string& folder) {
  if (!folder.empty()) check_folder(folder);
}

void check_cache_folder(const std::string& given, const std::filesystem::path& standard,
                        const Context& context) {
  if (!given.empty()) (void)nearest_folder(given);
  const std::filesystem::path folder = given.empty() ? standard : std::filesystem::path(given);
  const std::string problem = cache_problem(folder);
  if (problem.empty() || context.quiet) return;
  std::fprintf(stderr,
               "note: nothing is kept for the next run, because %s\n"
               "  choose another folder with --cache FOLDER or the environment variable PENUMBRA_CACHE\n",
               problem.c_str());
}

}  // namespace penumbra::cli
