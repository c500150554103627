// A technique, or a function of the user's own, as the graph that is run: described, and compiled.
//
// A technique that ends in a filter runs it once per receiver; one that runs over the screen is the passes of
// its .shader files. A user's function is the shortest graph: a filter alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "resolve/compiler.h"
#include "resolve/shadow_shader.h"
#include "shaders/package_shader.h"
#include "shaders/reflect.h"
#include "techniques/pass_graph.h"

namespace penumbra::resolve {

struct ShadowGraph {
  std::string name;
  techniques::PassGraph graph;
  std::filesystem::path package;      // folder of the files that the passes name
  std::vector<std::string> keywords;  // keywords that are on in the passes' programs
  bool reversed_z = true;
  std::optional<ShadowShader> filter;  // the text of the graph's filter pass
  UniformValues parameters;
  bool uses_noise = false;  // the result depends on the noise seed
};

ShadowGraph technique_graph(const techniques::TechniqueList& list, const techniques::Technique& technique,
                            Taps taps = Taps::as_listed, bool reversed_z = true,
                            techniques::LightKind light = techniques::LightKind::directional);
ShadowGraph adapter_graph(const Adapter& adapter, bool reversed_z = true);
ShadowGraph filter_graph(const ShadowShader& shader);

// The program of one pass, compiled as it ships and with its texels counted.
struct CompiledProgram {
  std::string name;                                         // the name in messages
  std::string declared_at{};                                // "file:line:column" of the pass in its manifest
  std::map<std::string, std::string> named_at;              // "file:line" where a resource is first named
  std::vector<std::uint32_t> vertex;                        // empty: a compute shader
  std::map<std::uint32_t, std::string> vertex_inputs{};     // semantics of those that it reads, by location
  std::vector<shaderlab::RenderCommand> render_commands{};  // commands of a pass of a .shader
  std::string file{};                                       // the file of that .shader
  std::vector<std::uint32_t> plain;
  std::vector<std::uint32_t> counting;  // shaders/counted_module.h
  // The uniforms of the vertex stage and of the other stage, for programs compiled from bytecode: their
  // modules lack these.
  std::vector<shaders::Resource> vertex_uniforms{};
  std::vector<shaders::Resource> uniforms{};
  std::string vertex_entry{};
  std::string entry;
};

struct CompiledGraph {
  ShadowGraph source;
  std::vector<CompiledProgram> programs;  // one for each of source.graph.passes
  // For passes of casters that declare techniques::alpha_test_keyword, the program with that keyword. It
  // draws materials with alpha test.
  std::map<std::size_t, CompiledProgram> alpha_tested;
  std::vector<std::string> notes;  // the compiler's, for example which body of two was kept
};

// Throws InputError with the compiler's messages, and for a pass or kernel that its file does not have. A
// user's function is also refused when it compares through a sampler that does not, or reads through one that
// does. If the compiler crashes, hangs or takes more than the limits, the InputError names the user's file.
CompiledGraph compile(const ShadowGraph& graph, const Compiler& compiler = {});

inline CompiledGraph compile(const ShadowShader& shader, const Compiler& compiler = {}) {
  return compile(filter_graph(shader), compiler);
}

// Compiles one pass of a .shader.
CompiledProgram compile_pass(const shaders::PackageShader& shader, const std::string& pass,
                             const std::vector<std::string>& keywords, bool reversed_z,
                             const Compiler& compiler = {});

}  // namespace penumbra::resolve
