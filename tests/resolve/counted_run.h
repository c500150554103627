// Runs shaders with and without the counts of their fetches and written texels: the counts come back, and the
// two must compute the same.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/compute_pass.h"
#include "gpu/raster_pass.h"
#include "resolve/test_device.h"
#include "resolve/texel_counter.h"
#include "shaders/compile.h"
#include "shaders/counted_module.h"
#include "shaders/reflect.h"

namespace penumbra::resolve {

inline constexpr const char* kResources = R"(
Texture2D<float4> _Plain;
Texture2DArray<float4> _Array;
Texture3D<float4> _Volume;
Texture2D<float> _Depth;
SamplerState sampler_Linear;
SamplerComparisonState sampler_Compare;
RWTexture2D<float> _Image;
RWTexture2D<uint> _Numbers;
StructuredBuffer<float> _In;
RWStructuredBuffer<float> _Out;
float Read(Texture2D<float4> map, SamplerState s, float x) { return map.SampleLevel(s, x.xx, 0).x; }
)";

inline shaders::CompileResult compiled(const std::string& text, hlsl::Stage stage) {
  shaders::CompileRequest request;
  request.file = "counted.hlsl";
  request.text = kResources + text;
  request.stage = stage;
  request.keep_unoptimised = true;
  shaders::CompileResult result = shaders::compile(request);
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) ADD_FAILURE() << hlsl::format(diagnostic);
  return result;
}

struct Modules {
  Modules(const std::string& text, hlsl::Stage stage) {
    const shaders::CompileResult result = compiled(text, stage);
    shipped = result.spirv;
    counting = shaders::counted_module(result.unoptimised, "Main");
  }

  std::vector<std::uint32_t> shipped;
  std::vector<std::uint32_t> counting;
};

inline gpu::ImageShape shape_of(const shaders::Resource& resource) {
  gpu::ImageShape shape{.format = gpu::Format::rgba32f, .width = 8, .height = 8};
  if (resource.name == "_Depth") shape.format = gpu::Format::depth32;
  if (resource.name == "_Image") shape.format = gpu::Format::r32f;
  if (resource.name == "_Numbers") shape.format = gpu::Format::r32ui;
  if (resource.image.dimensions == 3) shape.depth = 8;
  if (resource.image.arrayed) shape.layers = 2;
  return shape;
}

// The bytes of a texel of each texture, as shape_of() makes them, and of targets of 16 bytes.
inline std::vector<std::uint32_t> texel_bytes(const std::vector<shaders::Resource>& resources,
                                              const shaders::Resource& block) {
  std::vector<std::uint32_t> bytes;
  for (const shaders::UniformMember& member : block.members) {
    bytes.push_back(16);
    for (const shaders::Resource& resource : resources)
      if (member.name == shaders::texel_bytes_uniform(resource.name))
        bytes.back() = static_cast<std::uint32_t>(gpu::texel_bytes(shape_of(resource).format));
  }
  return bytes;
}

// All that a module binds, filled with 0, and a counter.
class Resources {
 public:
  Resources(const std::vector<std::uint32_t>& module, gpu::Bindings& bindings, const TexelCounter& counter) {
    const std::vector<shaders::Resource> resources = shaders::reflect(module).resources;
    for (const shaders::Resource& resource : resources) {
      if (resource.name == shaders::texel_bytes_name) {
        std::vector<std::uint32_t> bytes = texel_bytes(resources, resource);
        bytes.resize(resource.size / 4);  // padded
        bindings.uniform_bytes(resource.name, std::as_bytes(std::span(bytes)));
      } else if (resource.name == shaders::texel_counts_name) {
        bindings.buffer(resource.name, counter.buffer());
      } else if (resource.kind == shaders::ResourceKind::sampler) {
        bindings.sampler(resource.name, gpu::Sampler(test_device(), resource.name == "sampler_Compare"
                                                                        ? gpu::SamplerKind::compare_less_equal
                                                                        : gpu::SamplerKind::linear_clamp));
      } else if (resource.kind == shaders::ResourceKind::storage_buffer) {
        gpu::Buffer buffer(test_device(), std::span<const float>(std::vector<float>(1024, 0.0F)));
        bindings.buffer(resource.name, buffer);
        if (resource.name == "_Out") out_ = buffer;
      } else {
        gpu::Image image(test_device(), shape_of(resource));
        for (int layer = 0; layer < image.shape().layers; ++layer)
          image.upload(std::vector<std::byte>(image.size_bytes()), {0, layer});
        bindings.image(resource.name, image);
      }
    }
  }

  std::vector<float> out() const { return out_ ? out_->download<float>() : std::vector<float>(); }

 private:
  std::optional<gpu::Buffer> out_;
};

struct Extent {
  int width = 1;
  int height = 1;
  int depth = 1;
};

inline TexelCounts dispatched(const std::string& text, Extent groups, Extent grid) {
  const Modules modules(text, hlsl::Stage::compute);
  const TexelCounter counter(test_device(), grid.width, grid.height, grid.depth);
  std::vector<std::vector<float>> out;
  for (const auto* module : {&modules.shipped, &modules.counting}) {
    gpu::ComputePass pass(test_device(), {.spirv = *module, .entry = "Main"});
    const Resources resources(*module, pass.bindings(), counter);
    pass.dispatch({static_cast<std::uint32_t>(groups.width), static_cast<std::uint32_t>(groups.height),
                   static_cast<std::uint32_t>(groups.depth)});
    out.push_back(resources.out());
  }
  EXPECT_EQ(out[0], out[1]) << "what the shader computes";
  return counter.counts();
}

// The triangles cover the whole target, one behind the other: depth 0.2, 0.4, ...
inline constexpr const char* kTriangles = R"(
float4 Main(uint corner : SV_VertexID) : SV_Position
{
    return float4(corner % 3 == 1 ? 3 : -1, corner % 3 == 2 ? 3 : -1, 0.2 + 0.2 * (corner / 3), 1);
}
)";

// The triangle covers half of the target: the pixels (x, y) with x + y below its side.
inline constexpr const char* kHalf = R"(
float4 Main(uint corner : SV_VertexID) : SV_Position
{
    return float4(corner == 1 ? 1.001 : -1, corner == 2 ? 1.001 : -1, 0.5, 1);
}
)";

struct Drawing {
  int size = 4;  // pixels along the target's side
  int colours = 1;
  int triangles = 1;
  bool depth = false;
  int samples = 1;
  bool shade_each_sample = false;
  const char* vertex = kTriangles;
  std::optional<Extent> grid{};  // the target's without a value
};

inline TexelCounts drawn(const std::string& text, const Drawing& drawing = {}) {
  const Modules modules(text, hlsl::Stage::fragment);
  const Extent grid = drawing.grid.value_or(Extent{drawing.size, drawing.size});
  const TexelCounter counter(test_device(), grid.width, grid.height);
  std::vector<std::vector<float>> out;
  for (const auto* module : {&modules.shipped, &modules.counting}) {
    gpu::RasterShaders shaders;
    shaders.vertex = compiled(drawing.vertex, hlsl::Stage::vertex).spirv;
    shaders.fragment = *module;
    shaders.colours.assign(static_cast<std::size_t>(drawing.colours), gpu::Format::rgba32f);
    shaders.samples = drawing.samples;
    shaders.shade_each_sample = drawing.shade_each_sample;
    if (drawing.depth) shaders.depth = gpu::Format::depth32;
    gpu::RasterPass pass(test_device(), shaders);
    const Resources resources(*module, pass.bindings(), counter);
    const auto image = [&](gpu::Format format) {
      return gpu::Image(
          test_device(),
          gpu::ImageShape{
              .format = format, .width = drawing.size, .height = drawing.size, .samples = drawing.samples});
    };
    std::vector<gpu::Image> images;
    images.reserve(static_cast<std::size_t>(drawing.colours));
    gpu::RasterTargets targets;
    for (int i = 0; i < drawing.colours; ++i) images.push_back(image(gpu::Format::rgba32f));
    for (const gpu::Image& one : images) targets.colours.emplace_back(&one);
    const gpu::Image depth = image(gpu::Format::depth32);
    if (drawing.depth) targets.depth = &depth;
    gpu::RasterTile tile;
    tile.width = tile.height = drawing.size;
    tile.vertex_count = static_cast<std::uint32_t>(3 * drawing.triangles);
    pass.draw(targets, {tile});
    out.push_back(drawing.samples == 1 && drawing.colours > 0 ? images[0].download<float>()
                                                              : std::vector<float>());
  }
  EXPECT_EQ(out[0], out[1]) << "what the shader draws";
  return counter.counts();
}

}  // namespace penumbra::resolve
