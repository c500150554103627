#include "resolve/screen_shader.h"

#include "resolve/counted_modules.h"
#include "resolve/module_order.h"

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
                           const std::vector<std::string>& keywords, bool reversed_z,
                           const platform::WorkerPool& process) {
  ModuleOrder order;
  order.vertex = shader.request(pass, hlsl::Stage::vertex, keywords, reversed_z);
  order.plain = shader.request(pass, hlsl::Stage::fragment, keywords, reversed_z);
  order.file = order.plain.file.string();
  order.name = order.file + ": " + pass;
  order.counting = order.plain;
  order.counting.entry = CompiledScreenPass::counting_entry;
  *order.counting.text += counting_function(order.plain.entry);
  count_fetches(order.counting);
  CompiledModules modules = compile_modules(order, process);
  CompiledScreenPass compiled;
  compiled.name = pass;
  compiled.vertex_entry = order.vertex->entry;
  compiled.fragment_entry = order.plain.entry;
  compiled.vertex = std::move(modules.vertex);
  compiled.fragment = std::move(modules.plain);
  compiled.counting = std::move(modules.counting);
  return compiled;
}

}  // namespace penumbra::resolve
