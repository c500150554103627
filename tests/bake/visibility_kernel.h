// Kernels of tests/bake/shaders that compute a visibility for each receiver.
#pragma once

#include <glm/vec4.hpp>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gpu/compute_pass.h"
#include "gpu/device.h"
#include "gpu/resources.h"
#include "shaders/compile.h"

namespace penumbra::bake {

inline const std::vector<std::uint32_t>& compiled_kernel(const std::string& file, const std::string& entry) {
  static std::map<std::pair<std::string, std::string>, std::vector<std::uint32_t>> compiled;
  std::vector<std::uint32_t>& kernel = compiled[{file, entry}];
  if (!kernel.empty()) return kernel;
  shaders::CompileRequest request;
  request.file = PENUMBRA_SOURCE_DIR "/tests/bake/shaders/" + file;
  request.entry = entry;
  request.stage = hlsl::Stage::compute;
  request.include_directories = {PENUMBRA_SOURCE_DIR "/ShaderLibrary"};
  const shaders::CompileResult result = shaders::compile(request);
  std::string messages;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) messages += hlsl::format(diagnostic) + "\n";
  if (hlsl::has_errors(result.diagnostics)) throw std::runtime_error(messages);
  return kernel = result.spirv;
}

// Binds _Receivers, _Visibility, sampler_Linear, the cbuffer Parameters, these images, and uniforms outside
// of a cbuffer if there are any. The kernel gives so many numbers for each receiver.
template <typename Parameters>
std::vector<float> run_kernel(const gpu::Device& device, const std::string& file, const std::string& entry,
                              const std::map<std::string, const gpu::Image*>& images,
                              const Parameters& parameters, std::vector<glm::vec4> receivers,
                              std::size_t numbers = 1, std::span<const glm::vec4> globals = {}) {
  const std::size_t count = receivers.size();
  receivers.resize((count + 63) / 64 * 64);
  const gpu::Buffer places(device, std::span<const glm::vec4>(receivers));
  const gpu::Buffer visibility(device, numbers * receivers.size() * sizeof(float));
  const gpu::Sampler linear(device, gpu::SamplerKind::linear_clamp);
  gpu::ComputePass pass(device, {.spirv = compiled_kernel(file, entry), .entry = entry});
  pass.bindings().buffer("_Receivers", places);
  pass.bindings().buffer("_Visibility", visibility);
  for (const auto& [name, image] : images) pass.bindings().image(name, *image);
  pass.bindings().sampler("sampler_Linear", linear);
  if (pass.bindings().has("Parameters")) pass.bindings().uniform("Parameters", parameters);
  if (!globals.empty()) pass.bindings().uniform_bytes("$Global", std::as_bytes(globals));
  pass.dispatch({static_cast<std::uint32_t>(receivers.size() / 64), 1, 1});
  std::vector<float> values = visibility.download<float>();
  values.resize(numbers * count);
  return values;
}

}  // namespace penumbra::bake
