#include "fxc/fxc.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "input/input_error.h"
#include "platform/cache_store.h"
#include "platform/child_process.h"
#include "platform/content_hash.h"
#include "platform/data_directory.h"
#include "platform/terminal.h"

namespace penumbra::fxc {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view turned_off = "off";

const char* environment(const char* name) {
  return std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing sets it while threads run
}

bool is_library(const fs::path& file) {
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.starts_with("d3dcompiler_47") && name.ends_with(".dll");
}

// Returns the library in this folder itself; empty when there is none.
fs::path library_in(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (is_library(entry.path())) return entry.path();
  return {};
}

// Returns the folders into which NuGet unpacks versions of the package, in an order that does not depend on
// the file system.
std::vector<fs::path> nuget_folders() {
  const char* packages = environment("NUGET_PACKAGES");
  const char* home = environment("HOME");
  fs::path root = packages != nullptr ? fs::path(packages)
                                      : fs::path(home != nullptr ? home : "") / ".nuget" / "packages";
  root /= "microsoft.windowsdesktop.app.runtime.win-x64";
  std::vector<fs::path> folders;
  std::error_code error;
  for (const fs::directory_entry& version : fs::directory_iterator(root, error))
    folders.push_back(version.path() / "runtimes" / "win-x64" / "native");
  std::sort(folders.begin(), folders.end());
  return folders;
}

fs::path find_library() {
#ifdef _WIN32
  const char* system = environment("SystemRoot");
  std::vector<fs::path> folders{fs::path(system != nullptr ? system : "C:\\Windows") / "System32"};
#else
  std::vector<fs::path> folders{platform::data_directory() / ".cache" / "fxc"};
  // A library that another user may have put there is not run.
  if (const fs::path kept = platform::cache_directory("fxc"); platform::cache_folder_problem(kept).empty())
    folders.push_back(kept);
  for (fs::path& folder : nuget_folders()) folders.push_back(std::move(folder));
#endif
  for (const fs::path& folder : folders)
    if (fs::path found = library_in(folder); !found.empty()) return found;
  return {};
}

fs::path find_wine() {
  for (const char* name : {"wine64", "wine"})
    if (const std::optional<fs::path> found = platform::find_program(name)) return *found;
  const fs::path debian = "/usr/lib/wine/wine64";
  return fs::exists(debian) ? debian : fs::path();
}

fs::path find_worker() {
  for (const fs::path& folder :
       {platform::program_directory(), platform::program_directory().parent_path() / "libexec" / "penumbra"})
    if (fs::exists(folder / "fxc_worker.exe")) return folder / "fxc_worker.exe";
  return {};
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The version is that of VS_FIXEDFILEINFO in the version resource: the signature, a version of the structure,
// then the file's.
std::string version_of(std::string_view library) {
  constexpr std::string_view signature("\xBD\x04\xEF\xFE", 4);
  const std::size_t at = library.find(signature);
  std::uint16_t parts[4];
  if (at == std::string_view::npos || library.size() - at < 8 + sizeof parts) return {};
  std::memcpy(parts, library.data() + at + 8, sizeof parts);
  return std::to_string(parts[1]) + "." + std::to_string(parts[0]) + "." + std::to_string(parts[3]) + "." +
         std::to_string(parts[2]);
}

// Says why the file cannot be the library; empty where it may be.
std::string problem_of(const fs::path& library) {
  std::error_code error;
  if (!fs::is_regular_file(library, error))
    return "'" + library.string() + (fs::exists(library, error) ? "' is no file" : "' does not exist");
  std::ifstream stream(library, std::ios::binary);
  char mark[2] = {};
  stream.read(mark, sizeof mark);
  if (std::string_view(mark, sizeof mark) != "MZ") return "'" + library.string() + "' is no DLL of Windows";
  return {};
}

Search search() {
  const char* given = environment(location_variable);
  if (given != nullptr && std::string_view(given) == turned_off)
    return {std::nullopt, std::string("it is turned off, by --fxc or ") + location_variable};
  Installation installation;
  installation.library = given != nullptr && *given != '\0' ? fs::path(given) : find_library();
  if (installation.library.empty())
    return {std::nullopt,
            "D3DCompiler_47.dll was not found; scripts/setup gets it, or --fxc and PENUMBRA_FXC name it (it "
            "is in every Windows, "
            "and in the NuGet package Microsoft.WindowsDesktop.App.Runtime.win-x64)"};
  if (const std::string problem = problem_of(installation.library); !problem.empty())
    return {std::nullopt, problem};
  const std::string library = bytes_of(installation.library);
#ifndef _WIN32
  installation.wine = find_wine();
  if (installation.wine.empty())
    return {std::nullopt, "Wine, which runs it here, was not found; on Debian: apt-get install wine64"};
  installation.worker = find_worker();
  if (installation.worker.empty())
    return {std::nullopt,
            "this program was built without fxc_worker.exe; install a MinGW compiler (on Debian "
            "gcc-mingw-w64-x86-64) and build "
            "it again"};
#endif
  installation.version = version_of(library);
  installation.hash = platform::ContentHash().update(library).update(bytes_of(installation.worker)).hex();
  return {installation, {}};
}

const char* prefix_of(hlsl::Stage stage) {
  switch (stage) {
    case hlsl::Stage::vertex:
      return "vs_";
    case hlsl::Stage::hull:
      return "hs_";
    case hlsl::Stage::domain:
      return "ds_";
    case hlsl::Stage::geometry:
      return "gs_";
    case hlsl::Stage::fragment:
      return "ps_";
    case hlsl::Stage::compute:
      break;
  }
  return "cs_";
}

}  // namespace

void choose_fxc(const std::string& location) {
  if (const std::string problem = location == turned_off ? "" : problem_of(location); !problem.empty())
    throw InputError("--fxc", problem, "name D3DCompiler_47.dll itself, or 'off'");
#ifdef _WIN32
  ::_putenv_s(location_variable, location.c_str());
#else
  ::setenv(location_variable, location.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): no threads yet
#endif
}

const Search& find_fxc() {
  static const Search result = search();
  return result;
}

const Installation& require_fxc() {
  const Search& result = find_fxc();
  if (!result.found)
    throw EnvironmentError("FXC, Unity's compiler for Direct3D, is not at hand: " + result.missing);
  return *result.found;
}

std::string name_of(const Installation& installation) {
  return installation.version.empty() ? "FXC" : "FXC " + installation.version;
}

std::string profile_for(hlsl::Stage stage, int shader_target) {
  const bool model_5 = stage == hlsl::Stage::compute || stage == hlsl::Stage::hull ||
                       stage == hlsl::Stage::domain || shader_target >= 45;
  return std::string(prefix_of(stage)) + (model_5 ? "5_0" : "4_0");
}

}  // namespace penumbra::fxc
