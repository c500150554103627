// check_graph(): the checks of a graph.

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "input/input_error.h"
#include "techniques/caster_check.h"
#include "techniques/pass_graph.h"
#include "techniques/texel_formats.h"

namespace penumbra::techniques {

namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;
constexpr double kMostGraphBytes = 2048.0 * kMebibyte;

// The sizes at which extents count.
constexpr double kScreenPixels[] = {3840.0, 2160.0};
constexpr double kMapSide = 4096.0;  // along each side
constexpr double kTiles = 4.0;

// Counts the texels of the first mip level, with all layers.
double texels_of(const GraphTexture& texture) {
  const auto divided = [&texture](double width, double height) {
    return std::ceil(width / texture.divisor) * std::ceil(height / texture.divisor);
  };
  switch (texture.extent) {
    case ExtentOf::screen:
      return divided(kScreenPixels[0], kScreenPixels[1]) * texture.layers;
    case ExtentOf::map:
      return divided(kMapSide, kMapSide) * texture.layers;
    case ExtentOf::tile:
      return divided(kMapSide / 2.0, kMapSide / 2.0) * kTiles;
    case ExtentOf::fixed:
      break;
  }
  return 1.0 * texture.size[0] * texture.size[1] * texture.size[2] * texture.layers;
}

double bytes_of(const GraphTexture& texture) {
  const TexelFormat* format = find_texel_format(texture.format);
  const double mips = texture.mips == 1 ? 1.0 : 4.0 / 3.0;
  return texels_of(texture) * texture.samples * mips * (format == nullptr ? 16 : format->bytes);
}

// A limit of the memory that a graph takes.
//
// Refuses the texture with which the graph's ones take more together than a graph may: a manifest of some
// kilobytes could otherwise take all of a machine. Those of the screen and of the map count at sizes that few
// exceed. It must be called once every texture is known to be right.
void check_memory(const PassGraph& graph) {
  double sum = 0.0;
  for (const GraphTexture& texture : graph.textures) {
    sum += bytes_of(texture);
    if (sum <= kMostGraphBytes) continue;
    throw InputError(
        texture.where,
        fmt::format("texture '{}': with it, the graph's textures take {:.0f} MiB, more than the {:.0f} MiB "
                    "that a graph may (of a screen of {} x {} pixels and a map of {} x {})",
                    texture.name, sum / kMebibyte, kMostGraphBytes / kMebibyte, kScreenPixels[0],
                    kScreenPixels[1], kMapSide, kMapSide),
        "use fewer or smaller textures, a \"divisor\", or a format of fewer bytes");
  }
}

// Returns whether the pass writes the first mip level, whatever it held before.
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

// The checks, one idea each. All throw the first problem.

void refuse_repeated_name(const PassGraph& graph) {
  std::set<std::string> seen;
  const auto check = [&](const auto& items, const char* what) {
    for (const auto& item : items)
      if (!seen.insert(item.name).second)
        throw InputError(item.where, "there are two of the name '" + item.name + "', one a " + what);
  };
  check(graph.textures, "texture");
  seen.clear();
  check(graph.passes, "pass");
}

std::string known_names(const PassGraph& graph) {
  std::string text;
  for (const GraphTexture& texture : graph.textures) text += (text.empty() ? "" : ", ") + texture.name;
  return text.empty() ? "the graph has no textures" : "the graph has: " + text;
}

void refuse_reserved_name(const PassGraph& graph) {
  for (const GraphTexture& texture : graph.textures)
    if (texture.name == shadow_map_name)
      throw InputError(texture.where, "texture 'shadowMap': the shadow map itself has that name",
                       "rename it");
}

void refuse_unknown_name(const PassGraph& graph, const std::string& where) {
  for (const GraphPass& pass : graph.passes) {
    for (const auto* bindings : {&pass.reads, &pass.writes})
      for (const auto& [shader_name, name] : *bindings)
        if (graph.texture(name) == nullptr)
          throw InputError(pass.where, "'" + pass.name + "' names '" + name + "', which is not declared",
                           known_names(graph));
    if (!pass.depth.empty() && pass.depth != shadow_map_name && graph.texture(pass.depth) == nullptr)
      throw InputError(pass.where, "there is no texture '" + pass.depth + "'",
                       known_names(graph) + "; or test against \"" + shadow_map_name + "\"");
    if (!pass.stencil.empty() && graph.texture(pass.stencil) == nullptr)
      throw InputError(pass.where, "there is no texture '" + pass.stencil + "'", known_names(graph));
    if (pass.kind == PassKind::filter)
      for (const std::string& argument : pass.filter->arguments)
        if (argument != shadow_map_name && argument != "pointSampler" && argument != "linearSampler" &&
            argument != spot_light_name && graph.texture(argument) == nullptr)
          throw InputError(
              pass.where, "'" + argument + "' is no argument of a filter",
              "arguments are shadowMap, pointSampler, linearSampler, spotLight and the graph's textures");
    const std::string& texels_of = pass.groups.texels_of;
    if (!texels_of.empty() && graph.texture(texels_of) == nullptr)
      throw InputError(pass.where, "there is no texture '" + texels_of + "'", known_names(graph));
  }
  for (const GraphTexture& texture : graph.textures)
    if (!texture.previous_of.empty() && graph.texture(texture.previous_of) == nullptr)
      throw InputError(texture.where, "there is no texture '" + texture.previous_of + "'",
                       known_names(graph));
  for (const std::string& name : {graph.visibility, graph.mask, graph.source})
    if (!name.empty() && graph.texture(name) == nullptr)
      throw InputError(where, "there is no texture '" + name + "'", known_names(graph));
  for (const std::string& name : graph.published)
    if (graph.texture(name) == nullptr)
      throw InputError(where, "there is no texture '" + name + "' to be published", known_names(graph));
}

// The texture holds what another texture was a frame ago: that one is written in every frame, and this one by
// no pass.
void check_history(const PassGraph& graph, const GraphTexture& texture) {
  const std::string& now = texture.previous_of;
  if (!graph.texture(now)->previous_of.empty())
    throw InputError(texture.where, "'" + now + "' is itself a frame old", "only one frame is kept");
  for (const GraphPass& pass : graph.passes) {
    if (writes_to(pass, texture.name))
      throw InputError(
          pass.where, "'" + pass.name + "' writes '" + texture.name + "', which is '" + now + "' a frame ago",
          "write '" + now + "'");
    if (writes_to(pass, now) && pass.frequency != Frequency::frame)
      throw InputError(pass.where, "'" + pass.name + "' does not write '" + now + "' in every frame, and '" +
                                       texture.name + "' is what it was a frame ago");
  }
  if (is_output(graph, texture.name))
    throw InputError(texture.where, "'" + texture.name + "' is a frame old, and the graph's result");
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

// A texture has one writer, and a reader.
void check_use(const PassGraph& graph, const std::string& name, const std::string& where) {
  const bool written = std::any_of(graph.passes.begin(), graph.passes.end(),
                                   [&](const GraphPass& pass) { return writes_to(pass, name); });
  if (name == graph.source && written)
    throw InputError(where, "a pass writes '" + name + "', the visibility of the graph before this one",
                     "let it write a texture of its own");
  if (name == graph.source) {
    if (!is_read(graph, name)) throw InputError(where, "nothing reads '" + name + "'", "delete it");
    return;
  }
  if (!written) throw InputError(where, "no pass writes '" + name + "'", "delete it, or let a pass write it");
  if (!made_once(graph, name)) {
    std::string passes;
    for (const GraphPass& pass : graph.passes)
      if (makes(pass, name)) passes += (passes.empty() ? "'" : ", '") + pass.name + "'";
    if (!passes.empty())
      throw InputError(
          where, "more than one pass writes '" + name + "': " + passes,
          "give each pass a texture of its own, or name it among the \"updates\" of a kernel that "
          "changes what the other has written");
    for (const GraphPass& pass : graph.passes)
      if (changes(pass, name))
        throw InputError(pass.where, "'" + pass.name + "' updates '" + name + "', which no other pass writes",
                         "name it among its \"writes\"");
    throw InputError(where, "no pass writes the first mip level of '" + name + "'");
  }
  const auto makers = std::count_if(graph.passes.begin(), graph.passes.end(), [&](const GraphPass& pass) {
    return pass.each_mip && writes_to(pass, name);
  });
  if (makers > 1) throw InputError(where, "more than one pass makes the mip levels of '" + name + "'");
  if (!is_read(graph, name) && !is_read_later(graph, name) && !is_output(graph, name) &&
      !is_depth(graph, name))
    throw InputError(where, "nothing reads '" + name + "'",
                     graph.visibility.empty() && graph.filter_pass() == nullptr
                         ? "where it is the graph's result, add \"visibility\": \"" + name + "\""
                         : "delete it, and what writes it alone");
}

constexpr double kMostBytes = 1024.0 * 1024.0 * 1024.0;

// Returns the largest possible size: 16 bytes per texel and all mip levels.
double fixed_bytes(const GraphTexture& texture) {
  return 16.0 * 4.0 / 3.0 * texture.size[0] * texture.size[1] * texture.size[2] * texture.layers *
         texture.samples;
}

void check_texture(const GraphTexture& texture) {
  const auto refuse = [&](const std::string& text) {
    throw InputError(texture.where, "texture '" + texture.name + "': " + text);
  };
  const bool flat = texture.extent != ExtentOf::fixed || texture.size[2] == 1;
  if (find_texel_format(texture.format)->depth && (texture.mips != 1 || texture.layers != 1 || !flat))
    refuse("a depth target has one mip level, one layer and no depth");
  if (texture.samples > 1 && (texture.mips != 1 || texture.layers != 1 || !flat))
    refuse("a texture with several samples has one mip level, one layer and no depth");
  if (texture.layers > 1 && !flat) refuse("a 3D texture has one layer");
  if (texture.extent == ExtentOf::fixed && fixed_bytes(texture) > kMostBytes) refuse("takes more than 1 GiB");
}

void check_kernel_target(const GraphPass& pass, const GraphTexture& texture) {
  if (texture.samples > 1)
    throw InputError(pass.where, "'" + pass.name + "' is a compute shader, which cannot write '" +
                                     texture.name + "' of several samples");
}

void check_drawn_target(const GraphPass& pass, const GraphTexture& texture) {
  const auto refuse = [&](const std::string& text) {
    throw InputError(pass.where, "'" + pass.name + "' draws into '" + texture.name + "', " + text);
  };
  if (texture.extent == ExtentOf::fixed && texture.size[2] > 1) refuse("which is a 3D texture");
  if (texture.layers > 1) refuse("which has several layers");
}

// Checks all targets of a pass together.
void check_targets(const PassGraph& graph, const GraphPass& pass) {
  const auto refuse = [&](const std::string& text) {
    throw InputError(pass.where, "'" + pass.name + "' " + text);
  };
  constexpr std::size_t kMostTargets = 8;  // of one draw, on every API
  if (is_drawn(pass.kind) && pass.writes.size() > kMostTargets) refuse("draws into more than 8 targets");
  const GraphTexture* first = nullptr;
  std::set<std::string> seen;
  for (const auto& [shader_name, name] : pass.writes) {
    if (!seen.insert(name).second) refuse("writes '" + name + "' twice");
    const GraphTexture& texture = *graph.texture(name);
    if (pass.frequency == Frequency::cascade && !in_cascades(texture))
      refuse("runs for each cascade, and writes '" + name + "', which is not of the map or a tile");
    pass.kind == PassKind::compute ? check_kernel_target(pass, texture) : check_drawn_target(pass, texture);
    if (first != nullptr && is_drawn(pass.kind) && !same_extent(*first, texture))
      refuse("draws into '" + first->name + "' and '" + name + "', which differ in size or samples");
    first = &texture;
  }
}

void check_pass(const PassGraph& graph, const GraphPass& pass) {
  const auto refuse = [&](const std::string& text, const std::string& remedy = "") {
    throw InputError(pass.where, "'" + pass.name + "' " + text, remedy);
  };
  if (pass.kind == PassKind::filter) {
    if (pass.frequency != Frequency::frame) refuse("calls a filter, which runs every frame");
    return;
  }
  if (!pass.stencil.empty()) check_stencil(graph, pass);
  if (pass.kind == PassKind::casters) check_casters(graph, pass);
  if (pass.writes.empty() && pass.kind != PassKind::casters) refuse("writes nothing");
  if (pass.each_mip) {
    const std::string& name = pass.writes.front().second;
    if (pass.writes.size() > 1 || graph.texture(name)->mips == 1 || !reads(graph, pass, name))
      refuse("runs for each mip level of '" + name + "'",
             "that is the one texture it writes, which has several levels and which the pass also reads");
  } else {
    if (!pass.depth.empty() && reads(graph, pass, pass.depth))
      refuse("reads '" + pass.depth + "', which it draws into");
    for (const auto& [shader_name, name] : pass.writes)
      if (reads(graph, pass, name))
        refuse("reads '" + name + "', which it writes", "only with \"each_mip\": true");
  }
  check_targets(graph, pass);
}

// A pass that runs once cannot read data that every frame makes anew.
void check_rates(const PassGraph& graph) {
  const std::vector<std::vector<std::size_t>> awaited = awaited_passes(graph);
  for (std::size_t i = 0; i < graph.passes.size(); ++i)
    for (const std::size_t earlier : awaited[i]) {
      const GraphPass& pass = graph.passes[i];
      const GraphPass& source = graph.passes[earlier];
      if (pass.frequency < source.frequency)
        throw InputError(pass.where, "'" + pass.name + "' runs more rarely than '" + source.name +
                                         "', whose output it reads");
    }
}

// Checks an image that is read back, pixel by pixel.
void check_image(const GraphTexture& texture, const std::string& what) {
  if (texture.extent != ExtentOf::screen || texture.mips != 1 || texture.layers != 1 || texture.samples != 1)
    throw InputError(texture.where, what + " '" + texture.name + "' is not a plain texture of the screen",
                     "extent screen, with one mip level, one layer and one sample");
  if (texture.format != "r8" && texture.format != "r32f")
    throw InputError(texture.where, what + " '" + texture.name + "' has the format " + texture.format,
                     "r8 or r32f");
}

// Checks a texture that a filter reads.
void check_argument(const GraphTexture& texture, const std::string& where, const std::string& what) {
  const bool deep = texture.extent == ExtentOf::fixed && texture.size[2] > 1;
  if (deep || texture.layers > 1 || texture.samples > 1 || texture.extent == ExtentOf::tile)
    throw InputError(where, what + " '" + texture.name + "' is no plain 2D texture",
                     "of the map or a fixed size, with one layer and one sample");
}

void check_published(const PassGraph& graph) {
  for (const std::string& name : graph.published) {
    const GraphTexture& texture = *graph.texture(name);
    if (texture.extent == ExtentOf::screen)
      throw InputError(texture.where, "the published '" + name + "' is of the screen",
                       "shaders after the passes read maps of the light");
    check_argument(texture, texture.where, "the published");
  }
}

// A filter is called for surfaces that are known exactly, so there is no screen to draw over.
void check_filter_graph(const PassGraph& graph, const GraphPass& filter) {
  for (const GraphTexture& texture : graph.textures)
    if (texture.extent == ExtentOf::screen)
      throw InputError(texture.where,
                       "'" + texture.name + "' is of the screen, and the graph ends in a filter",
                       "let a pass over the screen call the filter, and name its target \"visibility\"");
  if (!graph.mask.empty()) throw InputError(filter.where, "a graph that ends in a filter has no mask");
  if (!graph.published.empty())
    throw InputError(filter.where, "a graph that ends in a filter publishes what the filter takes",
                     "leave \"published\" out");
  for (const std::string& argument : filter.filter->arguments) {
    const GraphTexture* texture = graph.texture(argument);
    if (texture == nullptr) continue;
    check_argument(*texture, filter.where, "the filter's argument");
  }
}

void check_result(const PassGraph& graph, const std::string& where) {
  std::vector<const GraphPass*> filters;
  for (const GraphPass& pass : graph.passes)
    if (pass.kind == PassKind::filter) filters.push_back(&pass);
  if (filters.size() > 1)
    throw InputError(filters[1]->where,
                     "there are two filters: '" + filters[0]->name + "' and '" + filters[1]->name + "'",
                     "a graph ends in one");
  if (graph.visibility.empty() == filters.empty())
    throw InputError(filters.empty() ? where : filters[0]->where,
                     "the graph's visibility is that of a filter or a texture: one of the two",
                     filters.empty() ? "add a pass of kind \"filter\", or \"visibility\": texture" : "");
  if (!filters.empty()) return check_filter_graph(graph, *filters.front());
  check_image(*graph.texture(graph.visibility), "the visibility");
  for (const std::string& name : {graph.visibility, graph.source}) {
    if (name.empty()) continue;
    const GraphTexture& visibility = *graph.texture(name);
    if (visibility.divisor != 1)
      throw InputError(visibility.where, "the visibility has not one texel for each pixel of the screen",
                       "add a pass that brings it to the screen's size");
  }
  if (!graph.source.empty()) check_image(*graph.texture(graph.source), "the source");
  check_published(graph);
  if (!graph.mask.empty()) check_image(*graph.texture(graph.mask), "the mask");
}

}  // namespace

void check_graph(const PassGraph& graph, const std::string& where) {
  if (graph.passes.empty()) throw InputError(where, "the graph has no passes");
  refuse_repeated_name(graph);
  refuse_reserved_name(graph);
  refuse_unknown_name(graph, where);
  for (const GraphTexture& texture : graph.textures) check_texture(texture);
  check_memory(graph);
  refuse_misused_depth(graph);
  for (const GraphPass& pass : graph.passes) check_pass(graph, pass);
  for (const GraphTexture& texture : graph.textures) {
    if (texture.previous_of.empty()) {
      check_use(graph, texture.name, texture.where);
      continue;
    }
    check_history(graph, texture);
    if (!is_read(graph, texture.name))
      throw InputError(texture.where, "nothing reads '" + texture.name + "'", "delete it");
  }
  if (!in_running_order(graph)) {
    std::string names;
    for (const GraphPass& pass : graph.passes) names += (names.empty() ? "'" : ", '") + pass.name + "'";
    throw InputError(graph.passes.front().where, "passes wait for each other in a circle, among: " + names,
                     "let one of them read what an earlier one wrote");
  }
  check_rates(graph);
  check_result(graph, where);
}

}  // namespace penumbra::techniques
