#include "resolve/receiver_pass.h"

namespace penumbra::resolve {
namespace {

constexpr std::uint32_t kTile = 8;  // numthreads of Resolve.hlsl
std::uint32_t groups(int pixels) {
  return (static_cast<std::uint32_t>(pixels) + kTile - 1) / kTile;
}

gpu::RasterShaders raster_shaders(const std::vector<std::uint32_t>& vertex,
                                  const std::vector<std::uint32_t>& fragment) {
  gpu::RasterShaders shaders;
  shaders.vertex = vertex;
  shaders.fragment = fragment;
  shaders.vertex_entry = "ReceiverTriangle";
  shaders.fragment_entry = "ResolveFragment";
  shaders.colours = {gpu::Format::r32f};
  return shaders;
}

}  // namespace

ReceiverPass::ReceiverPass(const gpu::Device& device, const std::vector<std::uint32_t>& vertex,
                           const std::vector<std::uint32_t>& module)
    : device_(&device) {
  if (vertex.empty()) {
    compute_.emplace(device, gpu::ComputeShader{.spirv = module, .entry = "Main"});
  } else {
    raster_.emplace(device, raster_shaders(vertex, module));
  }
}

gpu::Bindings& ReceiverPass::bindings() {
  return compute_ ? compute_->bindings() : raster_->bindings();
}

std::vector<double> ReceiverPass::run(int width, int height, int repeats) {
  if (compute_) return compute_->dispatch({groups(width), groups(height), 1}, repeats);
  return draw(width, height, repeats);
}

std::vector<double> ReceiverPass::draw(int width, int height, int repeats) {
  if (!target_ || target_->width() != width || target_->height() != height) {
    target_.emplace(*device_, gpu::Format::r32f, width, height);
  }
  gpu::RasterTile whole;
  whole.width = width;
  whole.height = height;
  whole.vertex_count = 3;  // one triangle over all of it
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) times.push_back(raster_->draw({{&*target_}, nullptr, 0.0F}, {whole}));
  return times;
}

}  // namespace penumbra::resolve
