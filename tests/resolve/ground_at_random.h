// Some techniques read inputs besides the frame, which are filled here with numbers at random.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "resolve/frame_inputs.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {

// Techniques with needs get ground and an object without form, somewhere about the scene.
inline FrameInputs ground_at_random() {
  constexpr int kSide = 9;
  std::mt19937 bits(5);
  std::vector<std::uint16_t> texels;
  for (int i = 0; i < kSide * kSide * 4; ++i) texels.push_back(static_cast<std::uint16_t>(bits()));
  FrameInputs inputs;
  inputs.uniforms.set("_PenumbraGroundArea", glm::vec4(-20.0F, -10.0F, 60.0F, 70.0F));
  inputs.uniforms.set("_PenumbraGroundHeights", glm::vec4(-3.0F, 9.0F, kSide, kSide));
  inputs.uniforms.set("_PenumbraGroundChannels", glm::vec4(1.0F, 0.0F, 0.0F, 0.0F));
  const auto add = [&](const char* name, gpu::Format format, std::size_t channels) {
    gpu::Image image(test_device(), format, kSide, kSide);
    image.upload(std::span<const std::uint16_t>(texels).first(kSide * kSide * channels));
    inputs.images.emplace(name, std::move(image));
  };
  add("_PenumbraGroundHeightsTexture", gpu::Format::r16, 1);
  add("_PenumbraHorizonFirstTexture", gpu::Format::rgba16, 4);
  add("_PenumbraHorizonSecondTexture", gpu::Format::rgba16, 4);
  gpu::Image fields(test_device(),
                    {.format = gpu::Format::r16, .width = kSide, .height = kSide, .depth = kSide});
  std::vector<std::uint16_t> voxels;
  for (int i = 0; i < kSide * kSide * kSide; ++i) voxels.push_back(static_cast<std::uint16_t>(bits()));
  fields.upload(std::span<const std::uint16_t>(voxels));
  inputs.images.emplace("_PenumbraFieldTexture", std::move(fields));
  std::vector<glm::vec4> rows(96, glm::vec4(0.0F));
  const glm::vec4 object[] = {{1.0F, 0.0F, 0.0F, 0.0F},  {0.0F, 1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F, 0.0F},
                              {-4.0F, 0.0F, 4.0F, 3.0F}, {9.0F, 9.0F, 9.0F, 1.0F}, {0.0F, 0.0F, 0.0F, 0.0F}};
  std::copy(std::begin(object), std::end(object), rows.begin());
  inputs.uniforms.set("_PenumbraFieldAtlas", glm::vec4(kSide, kSide, kSide, 1.0F));
  inputs.uniforms.set("_PenumbraFieldObjects", std::span<const glm::vec4>(rows));
  return inputs;
}

}  // namespace penumbra::resolve
