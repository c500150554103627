#include "resolve/compiled_graph.h"

#include <utility>

#include "resolve/module_order.h"

namespace penumbra::resolve {
namespace {

using techniques::GraphPass;
using techniques::PassKind;

CompiledProgram program_of(const std::string& name, const ModuleOrder& order, CompiledModules modules,
                           std::vector<std::string>* notes = nullptr) {
  CompiledProgram program;
  program.name = name;
  program.entry = order.plain.entry;
  if (order.vertex) program.vertex_entry = order.vertex->entry;
  program.named_at = std::move(modules.named_at);
  program.vertex = std::move(modules.vertex);
  program.vertex_inputs = std::move(modules.vertex_inputs);
  program.plain = std::move(modules.plain);
  program.counting = std::move(modules.counting);
  program.vertex_uniforms = std::move(modules.vertex_uniforms);
  program.uniforms = std::move(modules.uniforms);
  if (notes != nullptr) notes->insert(notes->end(), modules.notes.begin(), modules.notes.end());
  return program;
}

CompiledProgram compile_kernel(const ShadowGraph& graph, const GraphPass& pass, const Compiler& compiler) {
  ModuleOrder order;
  order.plain = shaders::kernel_request((graph.package / pass.file).lexically_normal(), pass.program,
                                        graph.keywords, graph.reversed_z);
  order.file = order.plain.file.string();
  order.name = order.file + ": " + pass.program;
  return program_of(order.name, order, compile_modules(order, compiler));
}

}  // namespace

ShadowGraph filter_graph(const ShadowShader& shader) {
  ShadowGraph graph;
  graph.name = shader.name;
  graph.graph = techniques::graph_of({}, "");
  graph.filter = shader;
  graph.parameters = shader.parameters;
  graph.uses_noise = shader.uses_noise;
  return graph;
}

ShadowGraph technique_graph(const techniques::TechniqueList& list, const techniques::Technique& technique,
                            Taps taps, bool reversed_z, techniques::LightKind light) {
  ShadowGraph graph;
  graph.name = technique.name;
  graph.graph = technique.graph;
  graph.package = list.package;
  graph.keywords = technique.all_keywords();
  graph.reversed_z = reversed_z;
  // With unlimited samples the filter runs alone, on surfaces whose positions are known exactly.
  const bool filter_alone = taps == Taps::unlimited && technique.graph.filter_pass() == nullptr;
  if (filter_alone) graph.graph = techniques::graph_of(*technique.graph.filter(), technique.where);
  if (graph.graph.filter_pass() != nullptr)
    graph.filter = technique_shader(list, technique, taps, reversed_z, light);
  graph.parameters = parameter_uniforms(list, technique, taps);
  graph.uses_noise = technique.is_sampled() && taps == Taps::as_listed;
  return graph;
}

ShadowGraph adapter_graph(const Adapter& adapter, bool reversed_z) {
  return filter_graph(adapter_shader(adapter, reversed_z));
}

CompiledProgram compile_pass(const shaders::PackageShader& shader, const std::string& pass,
                             const std::vector<std::string>& keywords, bool reversed_z,
                             const Compiler& compiler) {
  ModuleOrder order;
  order.vertex = shader.request(pass, hlsl::Stage::vertex, keywords, reversed_z);
  order.plain = shader.request(pass, hlsl::Stage::fragment, keywords, reversed_z);
  order.file = order.plain.file.string();
  order.name = order.file + ": " + pass;
  CompiledProgram program = program_of(pass, order, compile_modules(order, compiler));
  program.render_commands = shader.render_commands(pass);
  program.file = order.file;
  return program;
}

CompiledGraph compile(const ShadowGraph& graph, const Compiler& compiler) {
  CompiledGraph compiled{graph, {}, {}, {}};
  std::map<std::filesystem::path, shaders::PackageShader> parsed;
  for (const GraphPass& pass : graph.graph.passes) {
    switch (pass.kind) {
      case PassKind::filter: {
        const ModuleOrder order = module_order(*graph.filter);
        compiled.programs.push_back(
            program_of(graph.name, order, compile_modules(order, compiler), &compiled.notes));
        break;
      }
      case PassKind::raster:
      case PassKind::casters: {
        const std::filesystem::path file = (graph.package / pass.file).lexically_normal();
        const shaders::PackageShader& shader = parsed.try_emplace(file, file).first->second;
        if (pass.kind == PassKind::casters &&
            !shader.declared(pass.program, {techniques::alpha_test_keyword}).empty()) {
          std::vector<std::string> keywords = graph.keywords;
          keywords.emplace_back(techniques::alpha_test_keyword);
          CompiledProgram& program = compiled.alpha_tested[compiled.programs.size()] =
              compile_pass(shader, pass.program, keywords, graph.reversed_z, compiler);
          program.declared_at = pass.where;
        }
        compiled.programs.push_back(
            compile_pass(shader, pass.program, graph.keywords, graph.reversed_z, compiler));
        compiled.programs.back().declared_at = pass.where;
        break;
      }
      case PassKind::compute:
        compiled.programs.push_back(compile_kernel(graph, pass, compiler));
        compiled.programs.back().declared_at = pass.where;
        break;
    }
  }
  return compiled;
}

}  // namespace penumbra::resolve
