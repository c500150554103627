#include "preparation/drawn.h"

#include <span>

#include "gpu/raster_pass.h"
#include "gpu/resources.h"
#include "preparation/validated_device.h"
#include "shaders/module_of.h"
#include "shaders/reflect.h"

namespace penumbra::preparation {
namespace {

std::vector<std::uint32_t> compiled(const std::string& text, hlsl::Stage stage, bool prepare, bool by_fxc) {
  shaders::CompileRequest request;
  request.file = "drawn.hlsl";
  request.text = text;
  request.stage = stage;
  request.prepare = prepare;
  return by_fxc ? shaders::module_by_fxc(request) : shaders::module_by_glslang(request);
}

bool holds(const std::string& name, const char* part) {
  return name.find(part) != std::string::npos;
}

gpu::Image texture(const Drawing& drawing, const std::string& name) {
  const bool depth = holds(name, "Depth");
  gpu::Image image(device(), depth ? gpu::Format::depth32 : gpu::Format::rgba32f, kDrawnSize, kDrawnSize);
  if (depth) {
    std::vector<float> depths(kDrawnSize * kDrawnSize);
    for (std::size_t i = 0; i < depths.size(); ++i) depths[i] = static_cast<float>(i) / 16.0F;
    image.upload(depths);
  } else {
    image.upload(picture([&](int x, int y) { return texel(drawing.textures.at(name), x, y); }));
  }
  return image;
}

void bind(const Drawing& drawing, const shaders::Resource& resource, gpu::Bindings& bindings) {
  switch (resource.kind) {
    case shaders::ResourceKind::uniform_block:
      bindings.uniform_bytes(resource.name,
                             std::as_bytes(std::span<const float>(drawing.uniforms.at(resource.name))));
      break;
    case shaders::ResourceKind::storage_buffer:
      bindings.buffer(resource.name,
                      gpu::Buffer(device(), std::span<const float>(drawing.buffers.at(resource.name))));
      break;
    case shaders::ResourceKind::sampled_image:
      bindings.image(resource.name, texture(drawing, resource.name));
      break;
    case shaders::ResourceKind::sampler:
      bindings.sampler(resource.name, gpu::Sampler(device(), holds(resource.name, "Compare")
                                                                 ? gpu::SamplerKind::compare_less_equal
                                                                 : gpu::SamplerKind::point_clamp));
      break;
    case shaders::ResourceKind::storage_image:
      throw std::runtime_error("nothing is given for '" + resource.name + "'");
  }
}

std::vector<Pixel> draw(const Drawing& drawing, bool prepare, bool by_fxc = false) {
  gpu::RasterShaders shaders;
  shaders.vertex = compiled(
      "float4 Main(uint i : SV_VertexID) : SV_Position { return float4(i == 1 ? 3 : -1, i == 2 ? 3 : -1, 0, "
      "1); }",
      hlsl::Stage::vertex, false, by_fxc);
  shaders.fragment = compiled(drawing.body, hlsl::Stage::fragment, prepare, by_fxc);
  shaders.colours = {gpu::Format::rgba32f};
  gpu::RasterPass pass(device(), shaders);
  for (const shaders::Resource& resource : shaders::reflect(shaders.fragment).resources)
    bind(drawing, resource, pass.bindings());
  const gpu::Image colour(device(), gpu::Format::rgba32f, kDrawnSize, kDrawnSize);
  pass.draw({{&colour}}, {{0, 0, kDrawnSize, kDrawnSize, 3, {}}});
  for (const std::string& message : device().validation_log()->messages()) throw std::runtime_error(message);
  return colour.download<Pixel>();
}

}  // namespace

std::vector<Pixel> draw_prepared(const Drawing& drawing) {
  return draw(drawing, true);
}

std::vector<Pixel> draw_unprepared(const Drawing& drawing) {
  return draw(drawing, false);
}

std::vector<Pixel> draw_by_fxc(const Drawing& drawing) {
  return draw(drawing, true, true);
}

}  // namespace penumbra::preparation
