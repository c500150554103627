#include "techniques/graph_emit.h"

#include <algorithm>
#include <map>

#include "input/input_error.h"
#include "techniques/csharp_literal.h"
#include "techniques/table_row.h"
#include "techniques/texel_formats.h"

namespace penumbra::techniques {
namespace {

std::string extent(ExtentOf extent) {
  switch (extent) {
    case ExtentOf::screen:
      return "Screen";
    case ExtentOf::map:
      return "Map";
    case ExtentOf::tile:
      return "Tile";
    case ExtentOf::fixed:
      break;
  }
  return "Fixed";
}

std::string texture_row(const GraphTexture& texture) {
  TableRow row("texture");
  row.add(texture.name).add(extent(texture.extent)).add(find_texel_format(texture.format)->unity);
  row.option("divisor", texture.divisor, 1);
  if (texture.extent == ExtentOf::fixed)
    row.option("width", texture.size[0], 0)
        .option("height", texture.size[1], 0)
        .option("depth", texture.size[2], 1);
  row.option("mips", texture.mips, 1).option("layers", texture.layers, 1);
  return row.option("samples", texture.samples, 1).line();
}

std::string buffer_row(const GraphBuffer& buffer) {
  return TableRow("buffer")
      .add(buffer.name)
      .option("words", buffer.words, 0)
      .option("wordsPerTexel", buffer.words_per_texel, 0)
      .option("texelsOf", buffer.texture)
      .option("divisor", buffer.divisor, 1)
      .option("indirect", buffer.indirect)
      .line();
}

std::string groups_row(const GroupCount& groups) {
  if (!groups.texels_of.empty())
    return TableRow("groupsOfTexels").add(groups.texels_of).option("divisor", groups.divisor, 1).line();
  if (!groups.indirect.empty()) return TableRow("groupsInBuffer").add(groups.indirect).line();
  return TableRow("groups").add(groups.fixed[0]).add(groups.fixed[1]).add(groups.fixed[2]).line();
}

std::string pass_rows(const GraphPass& pass) {
  TableRow row("pass");
  row.add(csharp_name(name_of(pass.kind))).add(csharp_name(name_of(pass.frequency)));
  row.add(pass.file).add(pass.program);
  row.option("testsShadowMap", pass.depth == shadow_map_name);
  row.option("blended", pass.casters == DrawnCasters::blended).option("eachMip", pass.each_mip);
  std::string rows = row.line();
  const auto bind = [&](const char* kind, const std::pair<std::string, std::string>& bound) {
    rows += TableRow(kind).add(bound.first).add(bound.second).line();
  };
  for (const auto& read : pass.reads) bind("read", read);
  for (const std::string& property : pass.absent) rows += TableRow("absent").add(property).line();
  for (const auto& written : pass.writes)
    if (!changes(pass, written.second)) bind("write", written);
  for (const auto& written : pass.writes)
    if (changes(pass, written.second)) bind("update", written);
  if (!pass.depth.empty() && pass.depth != shadow_map_name) rows += TableRow("depth").add(pass.depth).line();
  return pass.kind == PassKind::compute ? rows + groups_row(pass.groups) : rows;
}

// These are the arguments of the filter at the end, or of filters of shaders after the passes, each under its
// name.
std::string filter_rows(const PassGraph& graph) {
  const GraphPass* last = graph.filter_pass();
  const bool linear = last != nullptr && last->filter->takes("linearSampler");
  std::string rows;
  for (const std::string& name : last == nullptr ? graph.published : last->filter->arguments)
    if (graph.texture(name) != nullptr)
      rows += TableRow("filterTexture")
                  .add("_Penumbra" + csharp_name(name) + "Texture")
                  .add(name)
                  .option("linear", linear)
                  .line();
  return rows;
}

std::string rows_of(const NamedGraph& named) {
  const PassGraph& graph = named.graph;
  std::string rows = TableRow("graph").add(named.name).line();
  for (const GraphTexture& texture : graph.textures) rows += texture_row(texture);
  for (const GraphTexture& texture : graph.textures)
    if (!texture.previous_of.empty())
      rows += TableRow("previous").add(texture.name).add(texture.previous_of).line();
  for (const GraphBuffer& buffer : graph.buffers) rows += buffer_row(buffer);
  for (const GraphPass& pass : graph.passes)
    if (pass.kind != PassKind::filter) rows += pass_rows(pass);
  for (const std::string& keyword : graph.keywords) rows += TableRow("keyword").add(keyword).line();
  rows += filter_rows(graph);
  for (const auto& [kind, name] :
       {std::pair{"visibility", graph.visibility}, {"source", graph.source}, {"mask", graph.mask}})
    if (!name.empty()) rows += TableRow(kind).add(name).line();
  return rows;
}

// The renderer feature has no passes with a stencil: graphs with one are for measuring, and for shaders and
// samples to follow.
bool is_drawn_by_feature(const NamedGraph& named) {
  return std::none_of(named.graph.passes.begin(), named.graph.passes.end(),
                      [](const GraphPass& pass) { return !pass.stencil.empty(); });
}

}  // namespace

std::string graph_rows(const TechniqueList& list) {
  std::map<std::string, const NamedGraph*> named;
  std::string rows;
  for (const NamedGraph& graph : list.graphs) {
    if (!is_drawn_by_feature(graph)) continue;
    const auto [other, is_first] = named.emplace(graph.name, &graph);
    if (!is_first)
      throw InputError(graph.where, "'" + graph.name + "' is the name of another graph, too",
                       "that is at " + other->second->where + ": give one of them another name");
    rows += rows_of(graph);
  }
  return rows;
}

}  // namespace penumbra::techniques
