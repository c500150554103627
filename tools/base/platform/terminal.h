// Facts about the terminal, and the places of the program and its temporary files.
#pragma once

#include <filesystem>
#include <string>

namespace penumbra::platform {

bool stderr_is_terminal();
bool stdout_is_terminal();
bool colour_wanted_on_stdout();               // standard output is a terminal, and NO_COLOR unset or empty
std::filesystem::path program_path();         // the running executable
std::filesystem::path program_directory();    // the folder of the executable
std::filesystem::path temporary_directory();  // $TMPDIR, or /tmp if that is not a folder
// Makes a new folder in `parent` that this user alone can read, whose name has that prefix; empty if none can
// be created.
std::filesystem::path new_private_directory(const std::string& prefix,
                                            const std::filesystem::path& parent = temporary_directory());

}  // namespace penumbra::platform
