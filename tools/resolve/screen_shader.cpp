#include "resolve/screen_shader.h"

#include "resolve/counted_modules.h"

namespace penumbra::resolve {
namespace {

// A second entry point for the counting module: runs the pass and returns its red channel and the count.
std::string counting_function(const std::string& entry) {
  return "\nfloat4 " + std::string(CompiledScreenPass::counting_entry) +
         "(ScreenVaryings input) : SV_Target\n{\n    penumbraFetchCount = 0;\n    const float red = " +
         entry + "(input).x;\n    return float4(red, float(penumbraFetchCount), 0.0, 0.0);\n}\n";
}

}  // namespace

CompiledScreenPass compile(const shaders::PackageShader& shader, const std::string& pass,
                           const std::vector<std::string>& keywords, bool reversed_z) {
  const shaders::CompileRequest vertex = shader.request(pass, hlsl::Stage::vertex, keywords, reversed_z);
  const shaders::CompileRequest fragment = shader.request(pass, hlsl::Stage::fragment, keywords, reversed_z);
  CompiledScreenPass compiled;
  compiled.name = pass;
  compiled.vertex_entry = vertex.entry;
  compiled.fragment_entry = fragment.entry;
  compiled.vertex = compile_or_throw(vertex);
  compiled.fragment = compile_or_throw(fragment);
  shaders::CompileRequest counting = fragment;
  counting.entry = CompiledScreenPass::counting_entry;
  *counting.text += counting_function(fragment.entry);
  count_fetches(counting);
  refuse_uncounted_fetches(counting, fragment.file.string() + ": " + pass);
  compiled.counting = compile_or_throw(counting);
  return compiled;
}

}  // namespace penumbra::resolve
