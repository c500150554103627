#include "techniques/pass_graph.h"

#include <algorithm>
#include <map>
#include <set>

#include "project/json_diagnostic.h"
#include "techniques/texel_formats.h"

namespace penumbra::techniques {
namespace {

// Returns the names of the graph's textures that a pass needs written before it runs.
std::vector<std::string> inputs(const PassGraph& graph, const GraphPass& pass) {
  std::vector<std::string> names;
  for (const auto& [shader_name, name] : pass.reads) names.push_back(name);
  if (pass.kind == PassKind::filter && pass.filter)
    for (const std::string& argument : pass.filter->arguments)
      if (graph.texture(argument) != nullptr) names.push_back(argument);
  return names;
}

// Passes that write depth come first, then those that change the stencil, then those that are tested against
// it.
bool waits_for_stencil(const GraphPass& later, const GraphPass& earlier) {
  if (later.stencil.empty()) return false;
  if (earlier.depth == later.stencil) return true;
  return earlier.stencil == later.stencil && earlier.kind == PassKind::casters &&
         later.kind == PassKind::raster;
}

}  // namespace

bool reads(const PassGraph& graph, const GraphPass& pass, const std::string& name) {
  const std::vector<std::string> names = inputs(graph, pass);
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool waits_for(const PassGraph& graph, const GraphPass& later, const GraphPass& earlier) {
  if (waits_for_stencil(later, earlier)) return true;
  for (const std::string& name : later.updates)
    if (writes_to(earlier, name) && !changes(earlier, name)) return true;
  for (const std::string& name : inputs(graph, later)) {
    if (!writes_to(earlier, name)) continue;
    const bool own = writes_to(later, name);  // the level before its own
    if (!own || (later.each_mip && !earlier.each_mip)) return true;
  }
  return false;
}

std::vector<std::vector<std::size_t>> awaited_passes(const PassGraph& graph) {
  // The passes are indexed by what they write, or test against as a stencil.
  std::map<std::string, std::set<std::size_t>> users;
  for (std::size_t i = 0; i < graph.passes.size(); ++i) {
    const GraphPass& pass = graph.passes[i];
    for (const auto& [shader_name, name] : pass.writes) users[name].insert(i);
    for (const std::string& name : {pass.depth, pass.stencil})
      if (!name.empty()) users[name].insert(i);
  }
  std::vector<std::vector<std::size_t>> awaited;
  for (const GraphPass& pass : graph.passes) {
    std::set<std::size_t> candidates;
    std::vector<std::string> names = inputs(graph, pass);
    names.insert(names.end(), pass.updates.begin(), pass.updates.end());
    names.push_back(pass.stencil);
    for (const std::string& name : names)
      if (const auto found = users.find(name); found != users.end())
        candidates.insert(found->second.begin(), found->second.end());
    std::vector<std::size_t>& those = awaited.emplace_back();
    for (const std::size_t earlier : candidates)
      if (waits_for(graph, pass, graph.passes[earlier])) those.push_back(earlier);
  }
  return awaited;
}

bool writes_to(const GraphPass& pass, const std::string& name) {
  if (pass.depth == name && !name.empty()) return true;
  return std::any_of(pass.writes.begin(), pass.writes.end(),
                     [&](const auto& written) { return written.second == name; });
}

bool changes(const GraphPass& pass, const std::string& name) {
  return std::find(pass.updates.begin(), pass.updates.end(), name) != pass.updates.end();
}

std::vector<Need> all_needs() {
  return {Need::ground_heights, Need::horizon_angles, Need::distance_fields, Need::noise_mask};
}

bool FilterCall::takes(const std::string& argument) const {
  return std::find(arguments.begin(), arguments.end(), argument) != arguments.end();
}

const GraphTexture* PassGraph::texture(const std::string& name) const {
  const auto found = std::find_if(textures.begin(), textures.end(),
                                  [&](const GraphTexture& texture) { return texture.name == name; });
  return found == textures.end() ? nullptr : &*found;
}

const GraphPass* PassGraph::filter_pass() const {
  const auto found = std::find_if(passes.begin(), passes.end(),
                                  [](const GraphPass& pass) { return pass.kind == PassKind::filter; });
  return found == passes.end() ? nullptr : &*found;
}

const FilterCall* PassGraph::filter() const {
  const auto found = std::find_if(passes.rbegin(), passes.rend(),
                                  [](const GraphPass& pass) { return pass.filter.has_value(); });
  return found == passes.rend() ? nullptr : &*found->filter;
}

bool PassGraph::draws_casters() const {
  return draws(DrawnCasters::opaque) || draws(DrawnCasters::blended) || draws(DrawnCasters::volumes);
}

bool PassGraph::draws(DrawnCasters casters) const {
  return std::any_of(passes.begin(), passes.end(), [casters](const GraphPass& pass) {
    return pass.kind == PassKind::casters && pass.casters == casters;
  });
}

bool PassGraph::has_history() const {
  return std::any_of(textures.begin(), textures.end(),
                     [](const GraphTexture& texture) { return !texture.previous_of.empty(); });
}

bool PassGraph::needs_camera() const {
  return over_screen() || std::any_of(passes.begin(), passes.end(), [](const GraphPass& pass) {
           return pass.kind == PassKind::casters && pass.frequency == Frequency::frame;
         });
}

PassGraph graph_of(FilterCall filter, const std::string& where) {
  PassGraph graph;
  GraphPass pass;
  pass.name = filter.function;
  pass.where = where;
  pass.filter = std::move(filter);
  graph.passes.push_back(std::move(pass));
  return graph;
}

PassGraph in_sequence(const PassGraph& earlier, const PassGraph& later) {
  PassGraph both = earlier;
  for (const GraphTexture& texture : later.textures)
    if (texture.name != later.source) both.textures.push_back(texture);
  for (GraphPass pass : later.passes) {
    for (auto& [shader_name, name] : pass.reads)
      if (name == later.source) name = earlier.visibility;
    if (pass.groups.texels_of == later.source && !later.source.empty())
      pass.groups.texels_of = earlier.visibility;
    both.passes.push_back(std::move(pass));
  }
  both.keywords.insert(both.keywords.end(), later.keywords.begin(), later.keywords.end());
  for (const Need need : later.needs)
    if (std::find(both.needs.begin(), both.needs.end(), need) == both.needs.end()) both.needs.push_back(need);
  both.visibility = later.visibility;
  if (!later.mask.empty()) both.mask = later.mask;
  return both;
}

std::optional<std::vector<GraphPass>> in_running_order(const PassGraph& graph) {
  const std::vector<std::vector<std::size_t>> awaited = awaited_passes(graph);
  std::vector<bool> ran(graph.passes.size());
  const auto can_run = [&](std::size_t pass) {
    return !ran[pass] && std::all_of(awaited[pass].begin(), awaited[pass].end(), [&](std::size_t earlier) {
      return ran[earlier] || graph.passes[earlier].name == graph.passes[pass].name;
    });
  };
  std::vector<GraphPass> ordered;
  while (ordered.size() < graph.passes.size()) {
    std::size_t next = 0;
    while (next < graph.passes.size() && !can_run(next)) ++next;
    if (next == graph.passes.size()) return std::nullopt;
    ran[next] = true;
    ordered.push_back(graph.passes[next]);
  }
  return ordered;
}

std::vector<hlsl::Diagnostic> target_problems(const PassGraph& graph, const GraphPass& pass,
                                              const std::string& target) {
  std::vector<hlsl::Diagnostic> problems;
  if (target != "essl310" || pass.kind != PassKind::compute) return problems;
  for (const auto& [shader_name, name] : pass.writes) {
    const GraphTexture& texture = *graph.texture(name);
    if (find_texel_format(texture.format)->essl_storage) continue;
    problems.push_back(project::diagnostic_at(
        texture.where, hlsl::Severity::error,
        "compute shaders of OpenGL ES 3.1 cannot write '" + texture.format + "', the format of '" + name +
            "'; r32f, rgba16f, rgba32f, rgba8, r32ui and rgba32ui they can"));
  }
  return problems;
}

}  // namespace penumbra::techniques
