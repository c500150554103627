// Compares the map that is drawn for a spot light with rays to it: two programs, one geometry.
#include <cmath>
#include <optional>

#include "reference/trace_visibility.h"
#include "scene/frame_scene.h"

namespace penumbra::reference {
namespace {

using scene::RasterisedFrame;

// Whether the map says that the receiver is blocked, where all texels around its place agree; nothing where
// they do not.
std::optional<bool> blocked_in_map(const scene::Frame& frame, const glm::dvec3& receiver) {
  const parameters::SpotShadow& shadow = *frame.spot_shadow;
  const glm::dvec4 mapped = shadow.world_to_shadow * glm::dvec4(receiver, 1.0);
  const int column = int(std::floor(mapped.x / mapped.w * frame.atlas.width));
  const int row = int(std::floor(mapped.y / mapped.w * frame.atlas.height));
  std::optional<bool> all;
  for (int y = row - 1; y <= row + 1; ++y) {
    for (int x = column - 1; x <= column + 1; ++x) {
      if (x < 0 || y < 0 || x >= frame.atlas.width || y >= frame.atlas.height) return std::nullopt;
      const double depth = shadow.axial_depth(frame.atlas.depth[scene::texel_index(y, frame.atlas.width, x)]);
      const double gap = mapped.w - depth;
      if (gap > 0.01 && gap < 0.1) return std::nullopt;  // there is a slope, or a blocker near its shadow
      const bool blocked = gap >= 0.1;
      if (all && *all != blocked) return std::nullopt;
      all = blocked;
    }
  }
  return all;
}

TEST_F(RasterisedFrame, OfASpotLightAgreesWithRaysToAPoint) {
  scene::Scene scene = scene::built_in("contact-boxes");
  scene.origin = {300.0, 0.0, -200.0};
  scene.spot_light.emplace();
  scene.spot_light->position = scene.camera.position + 8.0 * scene.camera.forward + glm::dvec3(2.0, 4.0, 0.0);
  scene.spot_light->direction = {-0.2, -1.0, 0.1};
  scene.spot_light->outer_angle_degrees = 120.0;
  scene.spot_light->range_metres = 30.0;
  scene.spot_light->source_radius_metres = 0.0;
  for (const bool reversed_z : {false, true}) {
    scene::FrameSettings settings = scene::unbiased_settings(reversed_z, scene::DepthFormat::d32, 1);
    settings.shadows.resolution = 2048;
    settings.width = 320;
    settings.height = 180;
    const scene::Frame frame = scene::rasterise(*device, scene, settings);
    const VisibilityImage traced = trace_visibility(scene, frame.receivers, *scene.spot_light);
    int open = 0, shadowed = 0, apart = 0;
    for (std::size_t pixel = 0; pixel < traced.valid.size(); ++pixel) {
      if (traced.valid[pixel] == 0) continue;
      const glm::dvec3 receiver = scene.origin + glm::dvec3(frame.receivers.position_relative[pixel]);
      const std::optional<bool> blocked = blocked_in_map(frame, receiver);
      if (!blocked) continue;
      ++(*blocked ? shadowed : open);
      apart += (traced.visibility[pixel] == 0.0F) != *blocked ? 1 : 0;
    }
    EXPECT_GT(open, 5000);
    EXPECT_GT(shadowed, 1000);
    EXPECT_LT(apart, (open + shadowed) / 1000) << "of " << open << " and " << shadowed;
  }
}

}  // namespace
}  // namespace penumbra::reference
