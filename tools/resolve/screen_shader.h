// The package's own .shader file, read and compiled as Unity would: passes by their names, entry points and
// keywords by their pragmas, the platform's macros as its importer defines them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "shaderlab/tree.h"
#include "shaders/compile.h"

namespace penumbra::resolve {

// One pass for one set of keywords, twice: as it ships, and as a fragment shader that returns what the pass
// writes to its red channel and, in green, the fetches it took.
struct CompiledScreenPass {
  std::string name;
  std::vector<std::uint32_t> vertex;
  std::vector<std::uint32_t> fragment;
  std::vector<std::uint32_t> counting;
  std::string vertex_entry;
  std::string fragment_entry;
  static constexpr const char* counting_entry = "PenumbraCountFetches";
};

class ScreenShader {
 public:
  // Throws InputError with the place where the file is no ShaderLab. Without a root for URP, stand-ins of its
  // interface take its place.
  explicit ScreenShader(const std::filesystem::path& file,
                        std::vector<shaders::PackageRoot> package_roots = {});

  // Keywords that the pass does not declare are off in it, as in Unity. Depth runs as on Vulkan when
  // reversed, else as on OpenGL. Throws InputError for a pass that is not there, for the compiler's errors,
  // and for a pass that reads a texture past the counting macros.
  CompiledScreenPass compile(const std::string& pass, const std::vector<std::string>& keywords,
                             bool reversed_z) const;

  std::vector<std::string> pass_names() const;  // of the first SubShader

 private:
  shaderlab::Shader shader_;
  std::vector<shaders::PackageRoot> package_roots_;
  bool prepare_;
};

// The one that the package ships.
std::filesystem::path package_shader();

}  // namespace penumbra::resolve
