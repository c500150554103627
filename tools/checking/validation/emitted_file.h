// The files in which the emitted texts of a run are kept.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "validation/unit.h"

namespace penumbra::validation {

// Returns "Water-ForwardLit-Frag.fragment.FOAM.1a2b3c4d.essl310.glsl": file or technique, pass, entry point,
// stage and keywords, of which long ones are cut, and the beginning of a hash of them all. It is a file's
// name whatever theirs are, and differs for any two units.
std::string emitted_file_name(const CompileUnit& unit, const std::string& target);

// Writes the file into the folder, which is made if it is not there; throws InputError.
void write_emitted(const std::filesystem::path& folder, const CompileUnit& unit, const std::string& target,
                   std::string_view text);

}  // namespace penumbra::validation
