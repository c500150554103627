#include "resolve/screen_shader.h"

#include "resolve/module_order.h"

namespace penumbra::resolve {

CompiledScreenPass compile(const shaders::PackageShader& shader, const std::string& pass,
                           const std::vector<std::string>& keywords, bool reversed_z,
                           const platform::WorkerPool& process) {
  ModuleOrder order;
  order.vertex = shader.request(pass, hlsl::Stage::vertex, keywords, reversed_z);
  order.plain = shader.request(pass, hlsl::Stage::fragment, keywords, reversed_z);
  order.file = order.plain.file.string();
  order.name = order.file + ": " + pass;
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
