#include "techniques/graph_emit.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "input/input_error.h"
#include "techniques/csharp_literal.h"
#include "techniques/texel_formats.h"

namespace penumbra::techniques {
namespace {

constexpr const char* graph_indent = "            ";
constexpr const char* item_indent = "                ";
constexpr const char* pass_indent = "                    ";

// "(a, b)" and the like; what is empty is left out.
class Arguments {
 public:
  Arguments& add(const std::string& argument) {
    text_.append(text_.empty() ? "" : ", ").append(argument);
    return *this;
  }
  Arguments& number(const std::string& name, int value, int otherwise) {
    return value == otherwise ? *this : add(name + ": " + std::to_string(value));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

template <typename Item>
int index_of(const std::vector<Item>& items, const std::string& name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
  return static_cast<int>(found - items.begin());
}

std::string extent(ExtentOf extent) {
  switch (extent) {
    case ExtentOf::screen:
      return "GraphExtent.Screen";
    case ExtentOf::map:
      return "GraphExtent.Map";
    case ExtentOf::tile:
      return "GraphExtent.Tile";
    case ExtentOf::fixed:
      break;
  }
  return "GraphExtent.Fixed";
}

std::string texture(const PassGraph& graph, const GraphTexture& texture) {
  Arguments arguments;
  arguments.add(csharp_text(texture.name))
      .add(extent(texture.extent))
      .add("GraphicsFormat." + std::string(find_texel_format(texture.format)->unity))
      .number("divisor", texture.divisor, 1);
  if (texture.extent == ExtentOf::fixed)
    arguments.number("width", texture.size[0], 0)
        .number("height", texture.size[1], 0)
        .number("depth", texture.size[2], 1);
  arguments.number("mips", texture.mips, 1)
      .number("layers", texture.layers, 1)
      .number("samples", texture.samples, 1);
  if (!texture.previous_of.empty())
    arguments.add("previousOf: " + std::to_string(index_of(graph.textures, texture.previous_of)));
  return "new GraphTexture(" + arguments.text() + ")";
}

std::string buffer(const PassGraph& graph, const GraphBuffer& buffer) {
  Arguments arguments;
  arguments.add(csharp_text(buffer.name))
      .number("words", buffer.words, 0)
      .number("wordsPerTexel", buffer.words_per_texel, 0);
  if (!buffer.texture.empty())
    arguments.add("texture: " + std::to_string(index_of(graph.textures, buffer.texture)));
  arguments.number("divisor", buffer.divisor, 1);
  if (buffer.indirect) arguments.add("indirect: true");
  return "new GraphBuffer(" + arguments.text() + ")";
}

std::string binding(const PassGraph& graph, const std::string& property, const std::string& name) {
  const bool is_buffer = graph.buffer(name) != nullptr;
  Arguments arguments;
  if (!property.empty()) arguments.add(csharp_text(property));
  arguments.add(std::to_string(is_buffer ? index_of(graph.buffers, name) : index_of(graph.textures, name)));
  return std::string("GraphBinding.") + (is_buffer ? "Buffer(" : "Texture(") + arguments.text() + ")";
}

// member = new[] { ... }; nothing of no items. `lines`: each on a line of its own.
std::string array(const std::string& indent, const std::string& member, const std::vector<std::string>& items,
                  bool lines) {
  if (items.empty()) return "";
  std::string text = indent + member + " = new[]";
  if (!lines) {
    Arguments arguments;
    for (const std::string& item : items) arguments.add(item);
    return text + " { " + arguments.text() + " },\n";
  }
  text.append("\n").append(indent).append("{\n");
  for (const std::string& item : items) text.append(indent).append("    ").append(item).append(",\n");
  return text + indent + "},\n";
}

std::string bindings(const PassGraph& graph, const std::string& member,
                     const std::vector<std::pair<std::string, std::string>>& bound) {
  std::vector<std::string> items;
  for (const auto& [property, name] : bound) items.push_back(binding(graph, property, name));
  return array(pass_indent, member, items, false);
}

std::string groups(const PassGraph& graph, const GroupCount& groups) {
  if (!groups.texels_of.empty()) {
    Arguments arguments;
    arguments.add(std::to_string(index_of(graph.textures, groups.texels_of)));
    arguments.number("divisor", groups.divisor, 1);
    return "GraphGroups.TexelsOf(" + arguments.text() + ")";
  }
  if (!groups.indirect.empty())
    return "GraphGroups.Indirect(" + std::to_string(index_of(graph.buffers, groups.indirect)) + ")";
  Arguments fixed;
  for (const int count : groups.fixed) fixed.add(std::to_string(count));
  return "GraphGroups.Fixed(" + fixed.text() + ")";
}

std::string frequency(Frequency frequency) {
  return csharp_name(name_of(frequency));
}

std::string pass(const PassGraph& graph, const GraphPass& pass) {
  const auto member = [](const std::string& name, const std::string& value) {
    return pass_indent + name + " = " + value + ",\n";
  };
  const bool kernel = pass.kind == PassKind::compute;
  std::string text = std::string(item_indent) + "new GraphPass\n" + item_indent + "{\n";
  text += member("kind", "PassKind." + csharp_name(name_of(pass.kind)));
  text += member("asset", csharp_text(pass.file));
  text += member("program", csharp_text(pass.program));
  if (pass.frequency != Frequency::frame)
    text += member("runs", "PassFrequency." + frequency(pass.frequency));
  text += bindings(graph, "reads", pass.reads);
  std::vector<std::string> absent;
  for (const std::string& property : pass.absent) absent.push_back(csharp_text(property));
  text += array(pass_indent, "absent", absent, false);
  std::vector<std::pair<std::string, std::string>> made, changed;
  for (const auto& written : pass.writes) (changes(pass, written.second) ? changed : made).push_back(written);
  text += bindings(graph, "writes", made);
  text += bindings(graph, "updates", changed);
  if (pass.depth == shadow_map_name)
    text += member("testsShadowMap", "true");
  else if (!pass.depth.empty())
    text += member("depth", std::to_string(index_of(graph.textures, pass.depth)));
  if (pass.casters == DrawnCasters::blended) text += member("blended", "true");
  if (pass.each_mip) text += member("eachMip", "true");
  if (kernel) text += member("groups", groups(graph, pass.groups));
  return text + item_indent + "},\n";
}

// What the filter at the end takes, or filters of shaders after the passes, each under its name.
std::vector<std::string> filter_textures(const PassGraph& graph) {
  std::vector<std::string> items;
  const GraphPass* last = graph.filter_pass();
  for (const std::string& name : last == nullptr ? graph.published : last->filter->arguments)
    if (graph.texture(name) != nullptr)
      items.push_back(binding(graph, "_Penumbra" + csharp_name(name) + "Texture", name));
  return items;
}

std::string csharp_graph(const NamedGraph& named) {
  const PassGraph& graph = named.graph;
  std::vector<std::string> textures;
  std::vector<std::string> buffers;
  std::vector<std::string> keywords;
  for (const GraphTexture& one : graph.textures) textures.push_back(texture(graph, one));
  for (const GraphBuffer& one : graph.buffers) buffers.push_back(buffer(graph, one));
  for (const std::string& keyword : graph.keywords) keywords.push_back(csharp_text(keyword));
  std::string text = "        internal static readonly TechniqueGraph " + csharp_name(named.name) +
                     " = new TechniqueGraph\n        {\n";
  text.append(graph_indent).append("name = ").append(csharp_text(named.name)).append(",\n");
  text += array(graph_indent, "textures", textures, true);
  text += array(graph_indent, "buffers", buffers, true);
  text.append(graph_indent).append("passes = new[]\n").append(graph_indent).append("{\n");
  for (const GraphPass& one : graph.passes)
    if (one.kind != PassKind::filter) text += pass(graph, one);
  text.append(graph_indent).append("},\n");
  text += array(graph_indent, "keywords", keywords, false);
  text += array(graph_indent, "filterTextures", filter_textures(graph), false);
  if (const GraphPass* last = graph.filter_pass(); last != nullptr && last->filter->takes("linearSampler"))
    text.append(graph_indent).append("filtersLinearly = true,\n");
  const auto output = [&](const char* member, const std::string& name) {
    if (!name.empty())
      text.append(graph_indent)
          .append(member)
          .append(" = ")
          .append(std::to_string(index_of(graph.textures, name)))
          .append(",\n");
  };
  output("visibility", graph.visibility);
  output("source", graph.source);
  output("mask", graph.mask);
  return text + "        };\n";
}

// The renderer feature has no passes with a stencil: graphs of such are for measuring, and for shaders and
// samples to follow.
bool is_drawn_by_feature(const NamedGraph& named) {
  return std::none_of(named.graph.passes.begin(), named.graph.passes.end(),
                      [](const GraphPass& pass) { return !pass.stencil.empty(); });
}

std::string stem(const std::string& manifest) {
  const std::string name = std::filesystem::path(manifest).filename().string();
  return name.substr(0, name.size() - std::min(name.size(), std::string_view(manifest_ending).size()));
}

std::string csharp_class(const std::string& manifest) {
  return csharp_name(stem(manifest)) + "Graphs";
}

std::string head(const std::string& manifest) {
  return "using UnityEngine.Experimental.Rendering;\n\nnamespace Penumbra\n{\n"
         "    // Written by `penumbra emit` from " +
         manifest +
         "; do not edit.\n"
         "    /// <summary>The manifest's graphs; passes are listed in the order in which they "
         "run.</summary>\n"
         "    internal static class " +
         csharp_class(manifest) + "\n    {\n";
}

void require_own_name(const std::vector<const NamedGraph*>& others, const NamedGraph& graph) {
  const std::string name = csharp_name(graph.name);
  if (name.empty())
    throw InputError(graph.where, "'" + graph.name + "' is no name that C# can have",
                     "give it letters or digits");
  for (const NamedGraph* other : others)
    if (csharp_name(other->name) == name)
      throw InputError(graph.where,
                       "'" + other->name + "' and '" + graph.name + "' are both " + name + " in C#",
                       "give one of them another name");
}

}  // namespace

std::string csharp_graph_of(const Technique& technique) {
  return csharp_class(technique.manifest) + "." + csharp_name(technique.graph_name);
}

std::vector<EmittedFile> emit_graphs_csharp(const TechniqueList& list) {
  std::vector<std::string> manifests;
  for (const NamedGraph& graph : list.graphs)
    if (is_drawn_by_feature(graph) &&
        std::find(manifests.begin(), manifests.end(), graph.manifest) == manifests.end())
      manifests.push_back(graph.manifest);
  std::vector<EmittedFile> files;
  for (const std::string& manifest : manifests) {
    std::string text = head(manifest);
    std::vector<const NamedGraph*> seen;
    for (const NamedGraph& graph : list.graphs) {
      if (graph.manifest != manifest || !is_drawn_by_feature(graph)) continue;
      require_own_name(seen, graph);
      text += (seen.empty() ? "" : "\n") + csharp_graph(graph);
      seen.push_back(&graph);
    }
    files.push_back({"Runtime/Techniques/" + csharp_class(manifest) + ".cs", text + "    }\n}\n"});
  }
  return files;
}

}  // namespace penumbra::techniques
