// Modules that the harness cannot do without. Internal to this folder.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "shaders/compile.h"

namespace penumbra::resolve {

// The message for compiler errors about this name.
struct MissingName {
  std::string name;
  std::string remedy;
};

// Returns the module; throws InputError with the compiler's messages. `notes` are formatted messages,
// `sources` the texts that were read, and `unoptimised` as in shaders::CompileResult.
std::vector<std::uint32_t> required_module(const shaders::CompileRequest& request,
                                           std::vector<std::string>* notes = nullptr,
                                           const MissingName* needed = nullptr,
                                           hlsl::SourceFiles* sources = nullptr,
                                           std::vector<std::uint32_t>* unoptimised = nullptr);

// Returns the text without includes and macros, for another compiler: nothing in it is prepared for glslang.
// Throws as above.
std::string required_text(const shaders::CompileRequest& request, hlsl::SourceFiles* sources = nullptr);

// A vertex shader's module, with the semantics of those inputs that it reads, by location.
struct VertexModule {
  std::vector<std::uint32_t> spirv;
  std::map<std::uint32_t, std::string> inputs;
};
VertexModule required_vertex_module(const shaders::CompileRequest& request);
VertexModule vertex_module(std::vector<std::uint32_t> spirv, const shaders::Signature& signature,
                           const std::string& entry);

}  // namespace penumbra::resolve
