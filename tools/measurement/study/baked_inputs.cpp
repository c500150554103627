#include "study/baked_inputs.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "bake/baked_files.h"
#include "bake/field_objects.h"
#include "bake/height_source.h"
#include "bake/horizon_angles.h"
#include "parameters/noise_mask.h"

namespace penumbra::study {
namespace {

using techniques::Need;

constexpr const char* kHeights = "_PenumbraGroundHeightsTexture";
constexpr const char* kFirstAngles = "_PenumbraHorizonFirstTexture";
constexpr const char* kSecondAngles = "_PenumbraHorizonSecondTexture";
constexpr const char* kFields = "_PenumbraFieldTexture";
constexpr const char* kNoise = "_PenumbraNoiseMaskTexture";

bool has(const std::vector<Need>& needs, Need need) {
  return std::find(needs.begin(), needs.end(), need) != needs.end();
}

gpu::Image texture(const gpu::Device& device, gpu::Format format, int width, int height,
                   const std::vector<std::uint16_t>& texels) {
  gpu::Image image(device, format, width, height);
  image.upload(std::span<const std::uint16_t>(texels));
  return image;
}

std::vector<std::string> names_of(Need need) {
  switch (need) {
    case Need::ground_heights:
      return {kHeights};
    case Need::horizon_angles:
      return {kFirstAngles, kSecondAngles};
    case Need::distance_fields:
      return {kFields};
    case Need::noise_mask:
      break;
  }
  return {kNoise};
}

// The slices are stored below each other.
gpu::Image noise_texture(const gpu::Device& device) {
  static const parameters::NoiseMask mask =
      parameters::generate_noise_mask(parameters::kNoiseMaskSide, parameters::kNoiseMaskSlices);
  std::vector<std::uint8_t> texels;
  for (int slice = 0; slice < mask.slices; ++slice)
    for (int y = 0; y < mask.side; ++y)
      for (int x = 0; x < mask.side; ++x) texels.push_back(mask.byte(x, y, slice));
  gpu::Image image(device, gpu::Format::r8, mask.side, mask.side * mask.slices);
  image.upload(std::span<const std::uint8_t>(texels));
  return image;
}

void add_fields(resolve::FrameInputs& inputs, const gpu::Device& device, const scene::Scene& scene,
                const BakeSettings& settings, const bake::BakeOptions& run) {
  bake::ObjectFieldsOptions options;
  options.each.voxels = settings.field_voxels;
  const bake::ObjectFields fields = bake::bake_object_fields(scene, options, run);
  const auto [width, height, depth] = fields.voxels;
  gpu::Image image(device, {.format = gpu::Format::r16, .width = width, .height = height, .depth = depth});
  image.upload(fields.texels());
  inputs.images.emplace(kFields, std::move(image));
  std::vector<glm::vec4> rows = fields.rows(scene.origin);
  rows.resize(std::size_t{6} * bake::most_field_objects, glm::vec4(0.0F));
  inputs.uniforms.set("_PenumbraFieldAtlas", fields.atlas());
  inputs.uniforms.set("_PenumbraFieldObjects", std::span<const glm::vec4>(rows));
}

}  // namespace

resolve::FrameInputs baked_inputs(const gpu::Device& device, const scene::Scene& scene,
                                  const std::vector<Need>& needs, const BakeSettings& settings,
                                  const bake::BakeOptions& run) {
  resolve::FrameInputs inputs;
  if (has(needs, Need::noise_mask)) inputs.images.emplace(kNoise, noise_texture(device));
  if (has(needs, Need::distance_fields)) add_fields(inputs, device, scene, settings, run);
  if (!has(needs, Need::ground_heights) && !has(needs, Need::horizon_angles)) return inputs;
  const scene::Scene ground = bake::ground_of(scene);
  const bake::Area area = bake::area_of(ground);
  const bake::HeightField field =
      bake::heights_of_scene(ground, area, bake::even_counts(area, settings.ground_samples), run);
  const bake::HeightRange range = bake::range_of(field);
  const glm::dvec3& origin = scene.origin;
  inputs.uniforms.set(
      "_PenumbraGroundArea",
      glm::vec4(glm::dvec4(area.corner.x + origin.x, area.corner.y + origin.z, area.size.x, area.size.y)));
  inputs.uniforms.set(
      "_PenumbraGroundHeights",
      glm::vec4(glm::dvec4(range.low + origin.y, range.high + origin.y, field.width, field.depth)));
  inputs.uniforms.set("_PenumbraGroundChannels", glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
  if (has(needs, Need::ground_heights))
    inputs.images.emplace(kHeights, texture(device, gpu::Format::r16, field.width, field.depth,
                                            bake::height_texels(field, range)));
  if (!has(needs, Need::horizon_angles)) return inputs;
  const bake::SampleCounts texels = bake::even_counts(area, settings.horizon_texels);
  const bake::HorizonAngles angles =
      bake::bake_horizon_angles(field, {texels.width, texels.depth, settings.nearest_metres}, run);
  for (const auto& [name, first] :
       {std::pair{kFirstAngles, 0}, std::pair{kSecondAngles, bake::horizon_channels}})
    inputs.images.emplace(name, texture(device, gpu::Format::rgba16, angles.width, angles.depth,
                                        bake::angle_texels(angles, first)));
  return inputs;
}

double baked_mebibytes(const resolve::FrameInputs& inputs, const std::vector<Need>& needs) {
  constexpr double kMebibyte = 1024.0 * 1024.0;
  double bytes = 0.0;
  for (const Need need : needs)
    for (const std::string& name : names_of(need))
      bytes += static_cast<double>(inputs.images.at(name).size_bytes());
  return bytes / kMebibyte;
}

}  // namespace penumbra::study
