// Modules that the harness cannot do without. Internal to this room.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shaders/compile.h"

namespace penumbra::resolve {

// What to say when the compiler's messages are about this name.
struct MissingName {
  std::string name;
  std::string way_out;
};

// The module; throws InputError with the compiler's messages. Notes are formatted messages; sources the texts
// that were read; unoptimised as in shaders::CompileResult.
std::vector<std::uint32_t> required_module(const shaders::CompileRequest& request,
                                           std::vector<std::string>* notes = nullptr,
                                           const MissingName* needed = nullptr,
                                           hlsl::SourceFiles* sources = nullptr,
                                           std::vector<std::uint32_t>* unoptimised = nullptr);

}  // namespace penumbra::resolve
