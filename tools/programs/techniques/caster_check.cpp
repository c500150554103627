#include "techniques/caster_check.h"

#include <algorithm>

#include "input/input_error.h"
#include "techniques/pass_graph.h"
#include "techniques/texel_formats.h"

namespace penumbra::techniques {
namespace {

bool has_depth_format(const GraphTexture& texture) {
  return find_texel_format(texture.format)->depth;
}

void refuse(const GraphPass& pass, const std::string& text, const std::string& remedy = "") {
  throw InputError(pass.where, "'" + pass.name + "' " + text, remedy);
}

// The shadow map holds the depth of casters that are drawn where it has them.
void check_map_depth(const PassGraph& graph, const GraphPass& pass) {
  if (pass.writes.empty())
    refuse(pass, "tests against the shadow map, and writes nothing", "give it \"writes\"");
  const GraphTexture& target = *graph.texture(pass.writes.front().second);
  if (target.extent == ExtentOf::map && target.divisor == 1 && target.samples == 1) return;
  refuse(pass, "tests against the shadow map, whose texels are not those of '" + target.name + "'",
         "give '" + target.name + "' the extent \"map\", without divisor and samples");
}

// Compares the sizes of a pass and of the depth that it is tested against.
void check_sizes(const PassGraph& graph, const GraphPass& pass, const GraphTexture& depth) {
  for (const auto& [shader_name, name] : pass.writes)
    if (!same_extent(*graph.texture(name), depth))
      refuse(pass,
             "draws into '" + name + "' and depth '" + depth.name + "', which differ in size or samples");
}

void check_own_depth(const PassGraph& graph, const GraphPass& pass) {
  const GraphTexture& depth = *graph.texture(pass.depth);
  if (!has_depth_format(depth))
    refuse(pass, "has '" + depth.name + "' as its depth, of format " + depth.format,
           "give it one of depth16, depth24, depth32 and depth32s8");
  check_sizes(graph, pass, depth);
}

}  // namespace

bool same_extent(const GraphTexture& a, const GraphTexture& b) {
  return a.extent == b.extent && a.divisor == b.divisor && a.size == b.size && a.samples == b.samples;
}

bool in_cascades(const GraphTexture& texture) {
  return texture.extent == ExtentOf::map || texture.extent == ExtentOf::tile;
}

bool is_depth(const PassGraph& graph, const std::string& name) {
  return std::any_of(graph.passes.begin(), graph.passes.end(),
                     [&](const GraphPass& pass) { return pass.depth == name; });
}

void check_stencil(const PassGraph& graph, const GraphPass& pass) {
  const GraphTexture& texture = *graph.texture(pass.stencil);
  if (!find_texel_format(texture.format)->stencil)
    refuse(pass, "has '" + texture.name + "' as its stencil, of format " + texture.format,
           "give it depth32s8");
  if (!pass.depth.empty())
    refuse(pass, "has a depth and a stencil", "leave out \"depth\": a stencil brings its own");
  if (!is_depth(graph, texture.name))
    refuse(pass, "has '" + texture.name + "' as its stencil, whose depth no casters draw",
           "let a pass of casters have it as its \"depth\"");
  if (texture.extent != ExtentOf::screen || pass.frequency != Frequency::frame || pass.each_mip)
    refuse(pass, "has a stencil, and is not drawn over the screen once a frame");
  if (reads(graph, pass, texture.name)) refuse(pass, "reads '" + texture.name + "', which is its stencil");
  check_sizes(graph, pass, texture);
}

void check_casters(const PassGraph& graph, const GraphPass& pass) {
  const bool map_depth = pass.depth == shadow_map_name;
  const bool own_depth = !pass.depth.empty() && !map_depth;
  if (map_depth) {
    check_map_depth(graph, pass);
  } else if (own_depth) {
    check_own_depth(graph, pass);
  } else if (pass.writes.empty() && pass.stencil.empty()) {
    refuse(pass, "writes nothing", "give it \"writes\", \"depth\" or both");
  }
  if (pass.casters == DrawnCasters::volumes && pass.stencil.empty())
    refuse(pass, "draws shadow volumes without a stencil to count in",
           "give it \"stencil\", the depth of an earlier pass of casters");
  const GraphTexture& target = *graph.texture(own_depth               ? pass.depth
                                              : !pass.stencil.empty() ? pass.stencil
                                                                      : pass.writes.front().second);
  if (target.extent == ExtentOf::fixed)
    refuse(pass, "draws casters into '" + target.name + "', which has a size of its own",
           "the light sees them in the extents map and tile, the camera in screen");
  if (in_cascades(target) && pass.frequency != Frequency::cascade)
    refuse(pass, "draws casters into '" + target.name + "', which each cascade has a part of",
           "add \"runs\": \"cascade\"");
  if (target.extent == ExtentOf::screen && pass.frequency != Frequency::frame)
    refuse(pass, "draws what the camera sees, which changes every frame",
           "leave out \"runs\", or give it \"frame\"");
}

void refuse_misused_depth(const PassGraph& graph) {
  for (const GraphPass& pass : graph.passes)
    for (const auto& [shader_name, name] : pass.writes) {
      const GraphTexture& texture = *graph.texture(name);
      if (has_depth_format(texture))
        refuse(pass, "writes '" + name + "', of format " + texture.format,
               "only casters write depth, into their \"depth\"; r32f holds depths, too");
    }
}

}  // namespace penumbra::techniques
