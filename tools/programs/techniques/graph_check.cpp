// graph_problem(): the checks of a graph.
#include <algorithm>
#include <set>

#include "input/nearest_name.h"
#include "techniques/caster_check.h"
#include "techniques/graph_memory.h"
#include "techniques/graph_order.h"
#include "techniques/texel_formats.h"

namespace penumbra::techniques {
namespace {

// Returns whether the pass writes the first mip level, or the buffer, whatever it held before.
bool makes(const GraphPass& pass, const std::string& name) {
  return writes_to(pass, name) && !pass.each_mip && !changes(pass, name);
}

bool made_once(const PassGraph& graph, const std::string& name) {
  return std::count_if(graph.passes.begin(), graph.passes.end(),
                       [&](const GraphPass& pass) { return makes(pass, name); }) == 1;
}

bool is_output(const PassGraph& graph, const std::string& name) {
  return name == graph.visibility || name == graph.mask;
}

// The checks, one idea each. All return the first problem.

Found repeated_name(const PassGraph& graph) {
  std::set<std::string> seen;
  const auto check = [&](const auto& items, const char* what) -> Found {
    for (const auto& item : items)
      if (!seen.insert(item.name).second)
        return GraphProblem{item.where, "there are two of the name '" + item.name + "', one a " + what, ""};
    return std::nullopt;
  };
  if (Found found = check(graph.textures, "texture")) return found;
  if (Found found = check(graph.buffers, "buffer")) return found;
  seen.clear();
  return check(graph.passes, "pass");
}

std::string known_names(const PassGraph& graph) {
  std::string text;
  for (const GraphTexture& texture : graph.textures) text += (text.empty() ? "" : ", ") + texture.name;
  for (const GraphBuffer& buffer : graph.buffers) text += (text.empty() ? "" : ", ") + buffer.name;
  return text.empty() ? "the graph has no textures and no buffers" : "the graph has: " + text;
}

Found reserved_name(const PassGraph& graph) {
  for (const GraphTexture& texture : graph.textures)
    if (texture.name == shadow_map_name)
      return GraphProblem{texture.where, "texture 'shadowMap': the shadow map itself has that name",
                          "rename it"};
  return std::nullopt;
}

Found unknown_name(const PassGraph& graph) {
  const auto known = [&](const std::string& name) {
    return graph.texture(name) != nullptr || graph.buffer(name) != nullptr;
  };
  for (const GraphPass& pass : graph.passes) {
    for (const auto* bindings : {&pass.reads, &pass.writes})
      for (const auto& [shader_name, name] : *bindings)
        if (!known(name))
          return GraphProblem{pass.where, "'" + pass.name + "' names '" + name + "', which is not declared",
                              known_names(graph)};
    if (!pass.depth.empty() && pass.depth != shadow_map_name && graph.texture(pass.depth) == nullptr)
      return GraphProblem{pass.where, "there is no texture '" + pass.depth + "'",
                          known_names(graph) + "; or test against \"" + shadow_map_name + "\""};
    if (!pass.stencil.empty() && graph.texture(pass.stencil) == nullptr)
      return GraphProblem{pass.where, "there is no texture '" + pass.stencil + "'", known_names(graph)};
    if (pass.kind == PassKind::filter && pass.filter)
      for (const std::string& argument : pass.filter->arguments)
        if (argument != shadow_map_name && argument != "pointSampler" && argument != "linearSampler" &&
            argument != spot_light_name && graph.texture(argument) == nullptr)
          return GraphProblem{
              pass.where, "'" + argument + "' is no argument of a filter",
              "arguments are shadowMap, pointSampler, linearSampler, spotLight and the graph's textures"};
    const GroupCount& groups = pass.groups;
    if (!groups.texels_of.empty() && graph.texture(groups.texels_of) == nullptr)
      return GraphProblem{pass.where, "there is no texture '" + groups.texels_of + "'", known_names(graph)};
    const GraphBuffer* indirect = graph.buffer(groups.indirect);
    if (!groups.indirect.empty() && (indirect == nullptr || !indirect->indirect))
      return GraphProblem{pass.where, "there is no buffer '" + groups.indirect + "' of numbers of groups",
                          "declare it with \"indirect\": true"};
  }
  for (const GraphBuffer& buffer : graph.buffers)
    if (!buffer.texture.empty() && graph.texture(buffer.texture) == nullptr)
      return GraphProblem{buffer.where, "there is no texture '" + buffer.texture + "'", known_names(graph)};
  for (const GraphTexture& texture : graph.textures)
    if (!texture.previous_of.empty() && graph.texture(texture.previous_of) == nullptr)
      return GraphProblem{texture.where, "there is no texture '" + texture.previous_of + "'",
                          known_names(graph)};
  for (const std::string& name : {graph.visibility, graph.mask, graph.source})
    if (!name.empty() && graph.texture(name) == nullptr)
      return GraphProblem{"", "there is no texture '" + name + "'", known_names(graph)};
  for (const std::string& name : graph.published)
    if (graph.texture(name) == nullptr)
      return GraphProblem{"", "there is no texture '" + name + "' to be published", known_names(graph)};
  return std::nullopt;
}

// The texture holds what another texture was a frame ago: that one is written in every frame, and this one by
// no pass.
Found wrong_history(const PassGraph& graph, const GraphTexture& texture) {
  const std::string& now = texture.previous_of;
  if (!graph.texture(now)->previous_of.empty())
    return GraphProblem{texture.where, "'" + now + "' is itself a frame old", "only one frame is kept"};
  for (const GraphPass& pass : graph.passes) {
    if (writes_to(pass, texture.name))
      return GraphProblem{
          pass.where, "'" + pass.name + "' writes '" + texture.name + "', which is '" + now + "' a frame ago",
          "write '" + now + "'"};
    if (writes_to(pass, now) && pass.frequency != Frequency::frame)
      return GraphProblem{pass.where,
                          "'" + pass.name + "' does not write '" + now + "' in every frame, and '" +
                              texture.name + "' is what it was a frame ago",
                          ""};
  }
  if (is_output(graph, texture.name))
    return GraphProblem{texture.where, "'" + texture.name + "' is a frame old, and the graph's result", ""};
  return std::nullopt;
}

bool is_read(const PassGraph& graph, const std::string& name) {
  return std::any_of(graph.passes.begin(), graph.passes.end(), [&](const GraphPass& pass) {
    return reads(graph, pass, name) && !writes_to(pass, name);
  });
}

// If its history is read, it is read itself, too.
bool is_read_later(const PassGraph& graph, const std::string& name) {
  return std::any_of(graph.textures.begin(), graph.textures.end(),
                     [&](const GraphTexture& texture) { return texture.previous_of == name; });
}

// A texture or buffer has one writer, and a reader.
Found wrong_use(const PassGraph& graph, const std::string& name, const std::string& where) {
  const bool written = std::any_of(graph.passes.begin(), graph.passes.end(),
                                   [&](const GraphPass& pass) { return writes_to(pass, name); });
  if (name == graph.source && written)
    return GraphProblem{where, "a pass writes '" + name + "', the visibility of the graph before this one",
                        "let it write a texture of its own"};
  if (name == graph.source)
    return is_read(graph, name) ? std::nullopt
                                : Found(GraphProblem{where, "nothing reads '" + name + "'", "delete it"});
  if (!written)
    return GraphProblem{where, "no pass writes '" + name + "'", "delete it, or let a pass write it"};
  if (!made_once(graph, name)) {
    std::string passes;
    for (const GraphPass& pass : graph.passes)
      if (makes(pass, name)) passes += (passes.empty() ? "'" : ", '") + pass.name + "'";
    if (!passes.empty())
      return GraphProblem{
          where, "more than one pass writes '" + name + "': " + passes,
          "give each pass a texture of its own, or name it among the \"updates\" of a kernel that "
          "changes what the other has written"};
    for (const GraphPass& pass : graph.passes)
      if (changes(pass, name))
        return GraphProblem{pass.where,
                            "'" + pass.name + "' updates '" + name + "', which no other pass writes",
                            "name it among its \"writes\""};
    return GraphProblem{where, "no pass writes the first mip level of '" + name + "'", ""};
  }
  const auto makers = std::count_if(graph.passes.begin(), graph.passes.end(), [&](const GraphPass& pass) {
    return pass.each_mip && writes_to(pass, name);
  });
  if (makers > 1) return GraphProblem{where, "more than one pass makes the mip levels of '" + name + "'", ""};
  if (!is_read(graph, name) && !is_read_later(graph, name) && !is_output(graph, name) &&
      !is_depth(graph, name))
    return GraphProblem{where, "nothing reads '" + name + "'",
                        graph.visibility.empty() && graph.filter_pass() == nullptr
                            ? "where it is the graph's result, add \"visibility\": \"" + name + "\""
                            : "delete it, and what writes it alone"};
  return std::nullopt;
}

constexpr double kMostBytes = 1024.0 * 1024.0 * 1024.0;

// Returns the largest possible size: 16 bytes per texel and all mip levels.
double fixed_bytes(const GraphTexture& texture) {
  return 16.0 * 4.0 / 3.0 * texture.size[0] * texture.size[1] * texture.size[2] * texture.layers *
         texture.samples;
}

Found wrong_texture(const GraphTexture& texture) {
  const auto problem = [&](const std::string& text, const std::string& way_out = "") {
    return GraphProblem{texture.where, "texture '" + texture.name + "': " + text, way_out};
  };
  if (find_texel_format(texture.format) == nullptr) {
    std::vector<std::string> known;
    for (const TexelFormat& format : texel_formats()) known.emplace_back(format.name);
    return problem("unknown format '" + texture.format + "'", unknown_name_way_out(texture.format, known));
  }
  if (texture.divisor < 1 || texture.divisor > 64) return problem("a divisor is 1 to 64");
  if (texture.extent == ExtentOf::fixed)
    for (const int size : texture.size)
      if (size < 1 || size > 16384) return problem("a fixed size is 1 to 16384 texels along each axis");
  if (texture.mips < 0 || texture.mips > 15) return problem("mip levels are 1 to 15, or 0 for all");
  if (texture.layers < 1 || texture.layers > 256) return problem("layers are 1 to 256");
  if (texture.samples != 1 && texture.samples != 2 && texture.samples != 4 && texture.samples != 8)
    return problem("samples are 1, 2, 4 or 8");
  const bool flat = texture.extent != ExtentOf::fixed || texture.size[2] == 1;
  if (find_texel_format(texture.format)->depth && (texture.mips != 1 || texture.layers != 1 || !flat))
    return problem("a depth target has one mip level, one layer and no depth");
  if (texture.samples > 1 && (texture.mips != 1 || texture.layers != 1 || !flat))
    return problem("a texture with several samples has one mip level, one layer and no depth");
  if (texture.layers > 1 && !flat) return problem("a 3D texture has one layer");
  if (texture.extent == ExtentOf::fixed && fixed_bytes(texture) > kMostBytes)
    return problem("takes more than 1 GiB");
  return std::nullopt;
}

Found wrong_kernel_target(const GraphPass& pass, const GraphTexture& texture) {
  if (texture.samples == 1) return std::nullopt;
  return GraphProblem{
      pass.where,
      "'" + pass.name + "' is a compute shader, which cannot write '" + texture.name + "' of several samples",
      ""};
}

Found wrong_drawn_target(const GraphPass& pass, const GraphTexture& texture) {
  const auto problem = [&](const std::string& text) {
    return GraphProblem{pass.where, "'" + pass.name + "' draws into '" + texture.name + "', " + text, ""};
  };
  if (texture.extent == ExtentOf::fixed && texture.size[2] > 1) return problem("which is a 3D texture");
  if (texture.layers > 1) return problem("which has several layers");
  return std::nullopt;
}

// Checks all targets of a pass together.
Found wrong_targets(const PassGraph& graph, const GraphPass& pass) {
  const auto problem = [&](const std::string& text) {
    return GraphProblem{pass.where, "'" + pass.name + "' " + text, ""};
  };
  constexpr std::size_t kMostTargets = 8;  // the number in one draw, on every API
  if (is_drawn(pass.kind) && pass.writes.size() > kMostTargets)
    return problem("draws into more than 8 targets");
  const GraphTexture* first = nullptr;
  std::set<std::string> seen;
  for (const auto& [shader_name, name] : pass.writes) {
    if (!seen.insert(name).second) return problem("writes '" + name + "' twice");
    const GraphTexture* texture = graph.texture(name);
    if (texture == nullptr && is_drawn(pass.kind))
      return problem("draws into '" + name + "', which is a buffer");
    if (texture == nullptr) continue;
    if (pass.frequency == Frequency::cascade && !in_cascades(*texture))
      return problem("runs for each cascade, and writes '" + name + "', which is not of the map or a tile");
    Found found = pass.kind == PassKind::compute ? wrong_kernel_target(pass, *texture)
                                                 : wrong_drawn_target(pass, *texture);
    if (found) return found;
    if (first != nullptr && is_drawn(pass.kind) && !same_extent(*first, *texture))
      return problem("draws into '" + first->name + "' and '" + name + "', which differ in size or samples");
    if (first != nullptr && pass.each_mip && first->mips != texture->mips)
      return problem("makes mip levels of '" + first->name + "' and '" + name +
                     "', which have different ones");
    first = texture;
  }
  return std::nullopt;
}

Found wrong_pass(const PassGraph& graph, const GraphPass& pass) {
  const auto problem = [&](const std::string& text, const std::string& way_out = "") {
    return GraphProblem{pass.where, "'" + pass.name + "' " + text, way_out};
  };
  if (pass.kind == PassKind::filter) {
    if (!pass.filter) return problem("names no function of the library", "add \"filter\": {...}");
    if (!pass.writes.empty()) return problem("calls a filter, whose result is the graph's visibility");
    if (pass.frequency != Frequency::frame) return problem("calls a filter, which runs every frame");
    return std::nullopt;
  }
  if (!pass.stencil.empty())
    if (Found found = wrong_stencil(graph, pass)) return found;
  if (pass.kind == PassKind::casters)
    if (Found found = wrong_casters(graph, pass)) return found;
  if (pass.writes.empty() && pass.kind != PassKind::casters) return problem("writes nothing");
  if (pass.each_mip) {
    for (const auto& [shader_name, name] : pass.writes) {
      const GraphTexture* texture = graph.texture(name);
      if (texture == nullptr || texture->mips == 1 || !reads(graph, pass, name))
        return problem("runs for each mip level of '" + name + "'",
                       "that is a texture with several levels which the pass also reads");
    }
  } else {
    if (!pass.depth.empty() && reads(graph, pass, pass.depth))
      return problem("reads '" + pass.depth + "', which it draws into");
    for (const auto& [shader_name, name] : pass.writes)
      if (reads(graph, pass, name))
        return problem("reads '" + name + "', which it writes", "only with \"each_mip\": true");
  }
  if (pass.each_mip && !pass.updates.empty())
    return problem("runs for each mip level, and updates '" + pass.updates.front() + "'",
                   "a pass that makes mip levels has \"writes\" alone");
  if (pass.kind == PassKind::compute) {
    const GroupCount& groups = pass.groups;
    const int given = (groups.fixed != std::array<int, 3>{} ? 1 : 0) + (groups.texels_of.empty() ? 0 : 1) +
                      (groups.indirect.empty() ? 0 : 1);
    if (given != 1)
      return problem(
          "needs one number of groups",
          "give \"groups\": {\"fixed\": [x, y, z]}, {\"texels_of\": texture} or {\"indirect\": buffer}");
  }
  return wrong_targets(graph, pass);
}

// A pass that runs once cannot read data that every frame makes anew.
Found too_rare(const PassGraph& graph) {
  const std::vector<std::vector<std::size_t>> awaited = awaited_passes(graph);
  for (std::size_t i = 0; i < graph.passes.size(); ++i)
    for (const std::size_t earlier : awaited[i]) {
      const GraphPass& pass = graph.passes[i];
      const GraphPass& source = graph.passes[earlier];
      if (pass.frequency < source.frequency)
        return GraphProblem{
            pass.where,
            "'" + pass.name + "' runs more rarely than '" + source.name + "', whose output it reads", ""};
    }
  return std::nullopt;
}

// Checks an image that is read back, pixel by pixel.
Found wrong_image(const GraphTexture& texture, const std::string& what) {
  if (texture.extent != ExtentOf::screen || texture.mips != 1 || texture.layers != 1 || texture.samples != 1)
    return GraphProblem{texture.where, what + " '" + texture.name + "' is not a plain texture of the screen",
                        "extent screen, with one mip level, one layer and one sample"};
  if (texture.format != "r8" && texture.format != "r32f")
    return GraphProblem{texture.where, what + " '" + texture.name + "' has the format " + texture.format,
                        "r8 or r32f"};
  return std::nullopt;
}

// Checks a texture that a filter reads.
Found wrong_argument(const GraphTexture& texture, const std::string& where, const std::string& what) {
  const bool deep = texture.extent == ExtentOf::fixed && texture.size[2] > 1;
  if (deep || texture.layers > 1 || texture.samples > 1 || texture.extent == ExtentOf::tile)
    return GraphProblem{where, what + " '" + texture.name + "' is no plain 2D texture",
                        "of the map or a fixed size, with one layer and one sample"};
  return std::nullopt;
}

Found wrong_published(const PassGraph& graph) {
  for (const std::string& name : graph.published) {
    const GraphTexture& texture = *graph.texture(name);
    if (texture.extent == ExtentOf::screen)
      return GraphProblem{texture.where, "the published '" + name + "' is of the screen",
                          "shaders after the passes read maps of the light"};
    if (Found found = wrong_argument(texture, texture.where, "the published")) return found;
  }
  return std::nullopt;
}

// A filter is called for surfaces that are known exactly, so there is no screen to draw over.
Found wrong_filter_graph(const PassGraph& graph, const GraphPass& filter) {
  for (const GraphTexture& texture : graph.textures)
    if (texture.extent == ExtentOf::screen)
      return GraphProblem{texture.where,
                          "'" + texture.name + "' is of the screen, and the graph ends in a filter",
                          "let a pass over the screen call the filter, and name its target \"visibility\""};
  if (!graph.mask.empty()) return GraphProblem{filter.where, "a graph that ends in a filter has no mask", ""};
  if (!graph.published.empty())
    return GraphProblem{filter.where, "a graph that ends in a filter publishes what the filter takes",
                        "leave \"published\" out"};
  for (const std::string& argument : filter.filter->arguments) {
    const GraphTexture* texture = graph.texture(argument);
    if (texture == nullptr) continue;
    if (Found found = wrong_argument(*texture, filter.where, "the filter's argument")) return found;
  }
  return std::nullopt;
}

Found wrong_result(const PassGraph& graph) {
  std::vector<const GraphPass*> filters;
  for (const GraphPass& pass : graph.passes)
    if (pass.kind == PassKind::filter) filters.push_back(&pass);
  if (filters.size() > 1)
    return GraphProblem{filters[1]->where,
                        "there are two filters: '" + filters[0]->name + "' and '" + filters[1]->name + "'",
                        "a graph ends in one"};
  if (graph.visibility.empty() == filters.empty())
    return GraphProblem{filters.empty() ? "" : filters[0]->where,
                        "the graph's visibility is that of a filter or a texture: one of the two",
                        filters.empty() ? "add a pass of kind \"filter\", or \"visibility\": texture" : ""};
  if (!filters.empty()) return wrong_filter_graph(graph, *filters.front());
  if (Found found = wrong_image(*graph.texture(graph.visibility), "the visibility")) return found;
  for (const std::string& name : {graph.visibility, graph.source}) {
    if (name.empty()) continue;
    const GraphTexture& visibility = *graph.texture(name);
    if (visibility.divisor != 1)
      return GraphProblem{visibility.where, "the visibility has not one texel for each pixel of the screen",
                          "add a pass that brings it to the screen's size"};
  }
  if (!graph.source.empty())
    if (Found found = wrong_image(*graph.texture(graph.source), "the source")) return found;
  if (Found found = wrong_published(graph)) return found;
  return graph.mask.empty() ? std::nullopt : wrong_image(*graph.texture(graph.mask), "the mask");
}

}  // namespace

std::optional<GraphProblem> graph_problem(const PassGraph& graph) {
  if (graph.passes.empty()) return GraphProblem{"", "the graph has no passes", ""};
  if (Found found = repeated_name(graph)) return found;
  if (Found found = reserved_name(graph)) return found;
  if (Found found = unknown_name(graph)) return found;
  for (const GraphTexture& texture : graph.textures)
    if (Found found = wrong_texture(texture)) return found;
  if (Found found = too_much_memory(graph)) return found;
  if (Found found = misused_depth(graph)) return found;
  for (const GraphPass& pass : graph.passes)
    if (Found found = wrong_pass(graph, pass)) return found;
  for (const GraphTexture& texture : graph.textures) {
    if (texture.previous_of.empty()) {
      if (Found found = wrong_use(graph, texture.name, texture.where)) return found;
      continue;
    }
    if (Found found = wrong_history(graph, texture)) return found;
    if (!is_read(graph, texture.name))
      return GraphProblem{texture.where, "nothing reads '" + texture.name + "'", "delete it"};
  }
  for (const GraphBuffer& buffer : graph.buffers)
    if (Found found = wrong_use(graph, buffer.name, buffer.where)) return found;
  if (!in_running_order(graph)) {
    std::string names;
    for (const GraphPass& pass : graph.passes) names += (names.empty() ? "'" : ", '") + pass.name + "'";
    return GraphProblem{graph.passes.front().where, "passes wait for each other in a circle, among: " + names,
                        "let one of them read what an earlier one wrote"};
  }
  if (Found found = too_rare(graph)) return found;
  return wrong_result(graph);
}

}  // namespace penumbra::techniques
