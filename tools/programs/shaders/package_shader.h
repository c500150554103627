// The package's own .shader file, read as Unity would: passes by their names, entry points and keywords by
// their pragmas, the platform's macros as its importer defines them.
#pragma once

#include <memory>

#include "shaderlab/programs.h"
#include "shaderlab/tree.h"
#include "shaders/compile.h"

namespace penumbra::shaders {

class PackageShader {
 public:
  // Throws InputError with the location if the file is not valid ShaderLab. Without a root for URP, stubs of
  // its interface are used.
  explicit PackageShader(const std::filesystem::path& file, std::vector<PackageRoot> package_roots = {});

  // Returns the request that compiles a stage of a pass. Keywords that the pass does not declare are off in
  // it, as in Unity. The depth convention is Vulkan's if reversed, else OpenGL's. Throws InputError for an
  // unknown pass.
  CompileRequest request(const std::string& pass, hlsl::Stage stage, const std::vector<std::string>& keywords,
                         bool reversed_z) const;

  // Returns the pass's render state: shaderlab::render_commands().
  std::vector<shaderlab::RenderCommand> render_commands(const std::string& pass) const;

  const std::string& name() const { return shader_->name.text; }
  std::vector<std::string> pass_names() const;  // passes of the first SubShader

  // Returns the keywords that the pass declares, in order of declaration. Throws as request() does.
  std::vector<std::string> declared(const std::string& pass, const std::vector<std::string>& keywords) const;

  // Counts the pass's variants, which are the same for every graphics API: each is a program of a vertex and
  // a fragment stage.
  std::uint64_t variant_count(const std::string& pass) const;

 private:
  const shaderlab::Program& program(const std::string& pass) const;

  std::shared_ptr<const shaderlab::Shader> shader_;  // programs_ points into it
  std::vector<shaderlab::Program> programs_;         // programs of the first SubShader
  std::vector<PackageRoot> package_roots_;
  bool prepare_;
};

// Adds this library, and stubs of URP's interface if there is no root for URP.
std::vector<PackageRoot> with_stand_ins(std::vector<PackageRoot> package_roots);

// Returns the request that compiles a kernel of a .compute file with these roots. The depth convention is
// that of PackageShader::request().
CompileRequest kernel_request(const std::filesystem::path& file, const std::string& kernel,
                              const std::vector<std::string>& keywords, bool reversed_z,
                              std::vector<PackageRoot> package_roots = {});

// Returns the shipped shaders: the passes of a frame, and the debug views.
std::filesystem::path package_shader_file();
std::filesystem::path debug_shader_file();

}  // namespace penumbra::shaders
