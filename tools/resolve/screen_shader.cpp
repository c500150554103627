#include "resolve/screen_shader.h"

#include <algorithm>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"
#include "input/input_error.h"
#include "input/nearest_name.h"
#include "platform/data_directory.h"
#include "resolve/counted_modules.h"
#include "shaderlab/parse.h"
#include "shaderlab/programs.h"
#include "variants/platform_defines.h"
#include "variants/pragmas.h"

namespace penumbra::resolve {
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

bool has_root(const std::vector<shaders::PackageRoot>& roots, const std::string& name) {
  return std::any_of(roots.begin(), roots.end(),
                     [&](const shaders::PackageRoot& root) { return root.name == name; });
}

std::vector<shaderlab::Program> first_programs(const shaderlab::Shader& shader) {
  std::vector<shaderlab::Program> programs = shaderlab::programs(shader);
  std::erase_if(programs, [](const shaderlab::Program& program) { return program.sub_shader_index != 0; });
  return programs;
}

std::vector<std::string> names_of(const std::vector<shaderlab::Program>& programs) {
  std::vector<std::string> names;
  names.reserve(programs.size());
  for (const shaderlab::Program& program : programs) names.emplace_back(shaderlab::pass_name(program));
  return names;
}

shaderlab::Program find_program(const shaderlab::Shader& shader, const std::string& pass) {
  const std::vector<shaderlab::Program> programs = first_programs(shader);
  for (const shaderlab::Program& program : programs) {
    if (shaderlab::pass_name(program) == pass) return program;
  }
  throw InputError(shader.file, "has no pass '" + pass + "' in its first SubShader",
                   unknown_name_way_out(pass, names_of(programs)));
}

std::string entry_point(const variants::Pragmas& pragmas, hlsl::Stage stage,
                        const shaderlab::Program& program) {
  for (const variants::EntryPoint& entry : pragmas.entry_points) {
    if (entry.stage == stage) return entry.function;
  }
  throw InputError(program.file + ":" + std::to_string(program.place.line),
                   std::string("the program has no #pragma ") + hlsl::stage_name(stage));
}

variants::Keywords declared(const variants::Pragmas& pragmas, const std::vector<std::string>& keywords) {
  variants::Keywords known;
  for (const variants::KeywordSet& set : pragmas.keyword_sets) {
    for (const std::string& keyword : variants::keywords_of(set)) {
      const bool wanted = std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
      if (wanted) known.push_back(keyword);
    }
  }
  return known;
}

// A second entry point for the counting module: runs the pass and returns its red channel and the count.
std::string counting_function(const std::string& entry) {
  return "\nfloat4 " + std::string(CompiledScreenPass::counting_entry) +
         "(ScreenVaryings input) : SV_Target\n{\n    penumbraFetchCount = 0;\n    const float red = " +
         entry + "(input).x;\n    return float4(red, float(penumbraFetchCount), 0.0, 0.0);\n}\n";
}

}  // namespace

ScreenShader::ScreenShader(const std::filesystem::path& file, std::vector<shaders::PackageRoot> package_roots)
    : shader_(parsed(file)),
      package_roots_(std::move(package_roots)),
      prepare_(has_root(package_roots_, kUrp)) {
  const std::filesystem::path root = platform::data_directory();
  const std::filesystem::path stand_ins = root / "tests" / "platform" / "unity";
  if (!has_root(package_roots_, kPackage)) package_roots_.push_back({kPackage, root});
  for (const char* package : {kUrp, kCore}) {
    if (!prepare_ && !has_root(package_roots_, package)) {
      package_roots_.push_back({package, stand_ins / package});
    }
  }
}

CompiledScreenPass ScreenShader::compile(const std::string& pass, const std::vector<std::string>& keywords,
                                         bool reversed_z) const {
  const shaderlab::Program program = find_program(shader_, pass);
  const variants::Platform platform{reversed_z ? variants::GraphicsApi::vulkan
                                               : variants::GraphicsApi::glcore};
  const variants::Pragmas pragmas =
      variants::read_pragmas({program.file, program.text, variants::pragma_defines(platform), {}});
  const variants::Keywords on = declared(pragmas, keywords);
  const auto request = [&](hlsl::Stage stage, const std::string& entry) {
    shaders::CompileRequest compile;
    compile.file = program.file;
    compile.text = program.text;
    compile.entry = entry;
    compile.stage = stage;
    for (const auto& [name, value] :
         variants::platform_defines(platform, stage, variants::shader_target(pragmas, on))) {
      compile.defines.emplace_back(name, value);
    }
    for (const std::string& keyword : on) compile.defines.emplace_back(keyword, "1");
    compile.package_roots = package_roots_;
    compile.prepare = prepare_;
    return compile;
  };

  CompiledScreenPass compiled;
  compiled.name = pass;
  compiled.vertex_entry = entry_point(pragmas, hlsl::Stage::vertex, program);
  compiled.fragment_entry = entry_point(pragmas, hlsl::Stage::fragment, program);
  compiled.vertex = compile_or_throw(request(hlsl::Stage::vertex, compiled.vertex_entry));
  compiled.fragment = compile_or_throw(request(hlsl::Stage::fragment, compiled.fragment_entry));
  shaders::CompileRequest counting = request(hlsl::Stage::fragment, CompiledScreenPass::counting_entry);
  *counting.text += counting_function(compiled.fragment_entry);
  count_fetches(counting);
  refuse_uncounted_fetches(counting, program.file + ": " + pass);
  compiled.counting = compile_or_throw(counting);
  return compiled;
}

std::vector<std::string> ScreenShader::pass_names() const {
  return names_of(first_programs(shader_));
}

std::filesystem::path package_shader() {
  return platform::data_directory() / "Shaders" / "PenumbraShadows.shader";
}

}  // namespace penumbra::resolve
