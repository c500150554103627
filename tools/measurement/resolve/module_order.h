// The modules of one shadow shader, compiled and checked in a process of its own. Internal to this folder,
// except for that process.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "resolve/compiler.h"
#include "shaders/compile.h"
#include "shaders/reflect.h"

namespace penumbra::resolve {

struct ModuleOrder {
  std::string name;  // the name in messages
  std::string file;  // the file in the message if the compiler crashes
  std::optional<shaders::CompileRequest> vertex;
  shaders::CompileRequest plain;
  bool names_places = false;  // CompiledModules::named_at
  bool is_adapter = false;    // true if the checks of adapters apply
};

struct CompiledModules {
  std::vector<std::uint32_t> vertex;                   // empty without a request
  std::map<std::uint32_t, std::string> vertex_inputs;  // semantics of those that it reads, by location
  std::vector<std::uint32_t> plain;                    // the module as it ships
  std::vector<std::uint32_t> counting;  // the same, with its texels counted: shaders/counted_module.h
  std::vector<std::string> notes;
  std::map<std::string, std::string> named_at;     // "file:line" where a resource is first named
  std::vector<shaders::Resource> vertex_uniforms;  // from bytecode: CompiledProgram
  std::vector<shaders::Resource> uniforms;
};

// Throws InputError as CompiledShadowShader compile() does. Modules that come from another process have
// passed SPIR-V validation in this one.
CompiledModules compile_modules(const ModuleOrder& order, const Compiler& compiler);

// The argument that starts the program as that process; main() then calls serve_modules().
inline constexpr const char* modules_mode = "shader-compiler";
int serve_modules();

}  // namespace penumbra::resolve
