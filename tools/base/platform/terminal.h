// Whether output goes to a terminal, and where the program and its temporary files are.
#pragma once

#include <filesystem>
#include <string>

namespace penumbra::platform {

bool stderr_is_terminal();
bool stdout_is_terminal();
bool colour_wanted();                         // stderr is a terminal, and NO_COLOR unset or empty
bool colour_wanted_on_stdout();               // the same of standard output
std::filesystem::path program_path();         // the running executable
std::filesystem::path program_directory();    // its folder
std::filesystem::path temporary_directory();  // $TMPDIR, or /tmp where that is not a folder
// A new folder in `parent` that this user alone can read, whose name has that prefix; empty if none can be
// created.
std::filesystem::path new_private_directory(const std::string& prefix,
                                            const std::filesystem::path& parent = temporary_directory());

}  // namespace penumbra::platform
