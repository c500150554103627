#include "shaders/package_shader.h"

#include <algorithm>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"
#include "input/input_error.h"
#include "input/nearest_name.h"
#include "platform/data_directory.h"
#include "shaderlab/parse.h"
#include "variants/keyword_space.h"
#include "variants/platform_defines.h"
#include "variants/pragmas.h"

namespace penumbra::shaders {
namespace {

constexpr const char* kPackage = "com.penumbra.shadows";
constexpr const char* kUrp = "com.unity.render-pipelines.universal";
constexpr const char* kCore = "com.unity.render-pipelines.core";

shaderlab::Shader parsed(const std::filesystem::path& file) {
  const hlsl::SourceRead source = hlsl::read_source(file);
  if (!source.problem.empty()) throw InputError(file.string(), source.problem);
  shaderlab::ParsedShader result = shaderlab::parse_shader(source.text, file.string());
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) {
    if (diagnostic.severity != hlsl::Severity::error) continue;
    throw InputError(
        diagnostic.file + ":" + std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column),
        diagnostic.message);
  }
  return std::move(result.shader);
}

bool has_root(const std::vector<PackageRoot>& roots, const std::string& name) {
  return std::any_of(roots.begin(), roots.end(), [&](const PackageRoot& root) { return root.name == name; });
}

std::vector<shaderlab::Program> first_programs(const shaderlab::Shader& shader) {
  std::vector<shaderlab::Program> programs = shaderlab::programs(shader);
  std::erase_if(programs, [](const shaderlab::Program& program) { return program.sub_shader_index != 0; });
  return programs;
}

std::string entry_point(const variants::Pragmas& pragmas, hlsl::Stage stage,
                        const shaderlab::Program& program) {
  for (const variants::EntryPoint& entry : pragmas.entry_points) {
    if (entry.stage == stage) return entry.function;
  }
  throw InputError(program.file + ":" + std::to_string(program.place.line),
                   std::string("the program has no #pragma ") + hlsl::stage_name(stage));
}

variants::Pragmas pragmas_of(const shaderlab::Program& program, const variants::Platform& platform) {
  return variants::read_pragmas({program.file, program.text, variants::pragma_defines(platform), {}});
}

variants::Keywords declared_in(const variants::Pragmas& pragmas, const std::vector<std::string>& keywords) {
  variants::Keywords known;
  for (const variants::KeywordSet& set : pragmas.keyword_sets) {
    for (const std::string& keyword : variants::keywords_of(set)) {
      const bool wanted = std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
      if (wanted) known.push_back(keyword);
    }
  }
  return known;
}

}  // namespace

PackageShader::PackageShader(const std::filesystem::path& file, std::vector<PackageRoot> package_roots)
    : shader_(std::make_shared<const shaderlab::Shader>(parsed(file))),
      programs_(first_programs(*shader_)),
      package_roots_(std::move(package_roots)),
      prepare_(has_root(package_roots_, kUrp)) {
  package_roots_ = with_stand_ins(std::move(package_roots_));
}

const shaderlab::Program& PackageShader::program(const std::string& pass) const {
  for (const shaderlab::Program& program : programs_) {
    if (shaderlab::pass_name(program) == pass) return program;
  }
  throw InputError(shader_->file, "has no pass '" + pass + "' in its first SubShader",
                   unknown_name_remedy(pass, pass_names()));
}

CompileRequest PackageShader::request(const std::string& pass, hlsl::Stage stage,
                                      const std::vector<std::string>& keywords, bool reversed_z) const {
  const shaderlab::Program& program = this->program(pass);
  const variants::Platform platform{reversed_z ? variants::GraphicsApi::vulkan
                                               : variants::GraphicsApi::glcore};
  const variants::Pragmas pragmas = pragmas_of(program, platform);
  const variants::Keywords on = declared_in(pragmas, keywords);
  CompileRequest compile;
  compile.file = program.file;
  compile.text = program.text;
  compile.entry = entry_point(pragmas, stage, program);
  compile.stage = stage;
  const int target = variants::shader_target(pragmas, on);
  for (const auto& [name, value] : variants::platform_defines(platform, stage, target))
    compile.defines.emplace_back(name, value);
  for (const std::string& keyword : on) compile.defines.emplace_back(keyword, "1");
  // OpenGL alone among Unity's APIs does not reverse depth. These programs run on Vulkan with both depth
  // directions; Vulkan defines what OpenGL leaves undefined.
  if (platform.api == variants::GraphicsApi::glcore)
    compile.defines.emplace_back("PENUMBRA_RAW_DEPTH_READS", "1");
  compile.package_roots = package_roots_;
  compile.prepare = prepare_;
  return compile;
}

std::vector<shaderlab::RenderCommand> PackageShader::render_commands(const std::string& pass) const {
  return shaderlab::render_commands(program(pass));
}

std::vector<std::string> PackageShader::pass_names() const {
  std::vector<std::string> names;
  names.reserve(programs_.size());
  for (const shaderlab::Program& program : programs_) names.emplace_back(shaderlab::pass_name(program));
  return names;
}

std::vector<std::string> PackageShader::declared(const std::string& pass,
                                                 const std::vector<std::string>& keywords) const {
  return declared_in(pragmas_of(program(pass), {}), keywords);
}

std::uint64_t PackageShader::variant_count(const std::string& pass) const {
  const variants::KeywordSpace space(pragmas_of(program(pass), {}));
  return space.whole_program().count().value();
}

std::vector<PackageRoot> with_stand_ins(std::vector<PackageRoot> package_roots) {
  const std::filesystem::path root = platform::data_directory();
  const std::filesystem::path stand_ins = root / "tools" / "programs" / "shaders" / "unity";
  const bool real = has_root(package_roots, kUrp);
  if (!has_root(package_roots, kPackage)) package_roots.push_back({kPackage, root});
  for (const char* package : {kUrp, kCore})
    if (!real && !has_root(package_roots, package)) package_roots.push_back({package, stand_ins / package});
  return package_roots;
}

CompileRequest kernel_request(const std::filesystem::path& file, const std::string& kernel,
                              const std::vector<std::string>& keywords, bool reversed_z,
                              std::vector<PackageRoot> package_roots) {
  CompileRequest compile;
  compile.file = file;
  compile.entry = kernel;
  compile.stage = hlsl::Stage::compute;
  compile.prepare = true;
  constexpr int kComputeTarget = 50;
  const variants::Platform platform{reversed_z ? variants::GraphicsApi::vulkan
                                               : variants::GraphicsApi::glcore};
  for (const auto& [name, value] : variants::platform_defines(platform, hlsl::Stage::compute, kComputeTarget))
    compile.defines.emplace_back(name, value);
  for (const std::string& keyword : keywords)
    if (keyword != "UNITY_REVERSED_Z") compile.defines.emplace_back(keyword, "1");
  compile.package_roots = with_stand_ins(std::move(package_roots));
  return compile;
}

std::filesystem::path package_shader_file() {
  return platform::data_directory() / "Shaders" / "PenumbraShadows.shader";
}

std::filesystem::path debug_shader_file() {
  return platform::data_directory() / "Shaders" / "PenumbraDebugViews.shader";
}

}  // namespace penumbra::shaders
