// The place of FXC on this machine: Unity's compiler of HLSL, D3DCompiler_47.dll, and the programs that run
// it.
#pragma once

#include <filesystem>
#include <string>

#include "hlsl/stage.h"

namespace penumbra::fxc {

// The environment variable that names the DLL, as --fxc does. If it is "off", FXC is not used, and nothing is
// searched.
inline constexpr const char* location_variable = "PENUMBRA_FXC";

struct Installation {
  std::filesystem::path library;  // D3DCompiler_47.dll, or a copy under another name
  std::filesystem::path worker;   // fxc_worker.exe; empty on Windows, where the library is called directly
  std::filesystem::path wine;     // Wine; empty on Windows
  std::string version;            // version of the library, "10.0.26100.4946"; empty if it has none
  std::string hash;               // hash of the library and the worker
};

// Either an installation, or a description in `missing` of what is missing and how to get it.
struct Search {
  std::optional<Installation> found;
  std::string missing;
};

// Finds the library: $PENUMBRA_FXC, else D3DCompiler_47*.dll in .cache/fxc of data_directory(), where
// scripts/setup puts it, in fxc of the user's cache folder, or in a NuGet package
// microsoft.windowsdesktop.app.runtime.win-x64 of the user's; on Windows the system's. Wine is wine64 or wine
// in PATH, or Debian's /usr/lib/wine/wine64. The answer of the first call is kept.
const Search& find_fxc();

// Gives $PENUMBRA_FXC that value, in this process and those that it starts. It must be called before the
// first call of find_fxc(), and before any thread is started. Throws InputError where the value is neither
// "off" nor a DLL.
void choose_fxc(const std::string& location);

// Returns the same as find_fxc(); throws EnvironmentError when there is none.
const Installation& require_fxc();

// Returns "FXC 10.0.26100.4946", for reports.
std::string name_of(const Installation& installation);

// The profile that Unity gives FXC.
//
// Returns "ps_4_0" and similar. Compute and tessellation are shader model 5.0, and so are all stages of a
// program with `#pragma target 4.5` or more; others are 4.0. shader_target is ten times the target, and 0 if
// none was given. Source: Unity Manual, "Targeting shader models and GPU features".
std::string profile_for(hlsl::Stage stage, int shader_target);

}  // namespace penumbra::fxc
