// Compiling a shader so that every texture fetch counts itself. Internal to this room.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shaders/compile.h"

namespace penumbra::resolve {

// Whichever file defines the sampling macros, ours or a pipeline's, the counting ones replace them there.
void count_fetches(shaders::CompileRequest& request);

// What to say when the compiler's messages are about this name.
struct MissingName {
  std::string name;
  std::string way_out;
};

// The module; throws InputError with the compiler's messages. Notes are formatted messages; sources the texts
// that were read; unoptimised as in shaders::CompileResult.
std::vector<std::uint32_t> compile_or_throw(const shaders::CompileRequest& request,
                                            std::vector<std::string>* notes = nullptr,
                                            const MissingName* needed = nullptr,
                                            hlsl::SourceFiles* sources = nullptr,
                                            std::vector<std::uint32_t>* unoptimised = nullptr);

// Throws InputError, naming the line or else the shader, when a request that counts reads a texture outside
// the counting functions.
void refuse_uncounted_fetches(shaders::CompileRequest counting, const std::string& shader);

}  // namespace penumbra::resolve
