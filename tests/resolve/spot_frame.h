// Maps of a spot light made by hand: every texel is a formula, and receivers stand at chosen places of one
// slice of an atlas of two by two.
#pragma once

#include <glm/matrix.hpp>
#include <memory>
#include <vector>

#include "parameters/spot_light.h"
#include "resolve/graph_runner.h"
#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"

namespace penumbra::testing_frames {

struct SpotSetup {
  parameters::SpotLight light;
  int slice_texels = 256;
  int slice = 0;  // one of the atlas's four, by rows
  bool reversed_z = true;

  parameters::SpotShadow shadow() const {
    parameters::ShadowSettings settings;
    settings.resolution = slice_texels;
    settings.reversed_z = reversed_z;
    return parameters::spot_shadow(light, settings);
  }
};

// A receiver: UV of the slice, metres along the light's axis.
using SpotPoint = glm::dvec3;

inline glm::dvec3 world_position(const parameters::SpotShadow& shadow, const SpotPoint& point) {
  const double stored = shadow.stored_depth(point.z);
  const glm::dvec4 mapped(point.x, point.y, stored, 1.0);
  return glm::dvec3(glm::inverse(shadow.world_to_shadow) * (mapped * point.z));
}

constexpr int kColumns = 20;       // columns of receivers
constexpr double kReceiver = 4.0;  // metres along the axis

inline SpotSetup lamp(bool reversed_z) {
  SpotSetup setup;
  setup.light.position = {1.0, 5.0, -2.0};
  setup.light.direction = {0.2, -1.0, 0.4};
  setup.light.outer_angle_degrees = 90.0;
  setup.light.source_radius_metres = 0.1;
  setup.light.shadow_near_plane_metres = 0.3;
  setup.light.range_metres = 9.0;
  setup.reversed_z = reversed_z;
  setup.slice = 1;
  return setup;
}

// A grid over the whole slice, to a quarter of a texel from its edges: beyond them a receiver is not covered.
inline std::vector<SpotPoint> grid(double metres) {
  std::vector<SpotPoint> points;
  const auto place = [](int i) { return 0.001 + 0.998 * i / (kColumns - 1.0); };
  for (int y = 0; y < kColumns; ++y)
    for (int x = 0; x < kColumns; ++x) points.emplace_back(place(x), place(y), metres);
  return points;
}

inline std::vector<glm::dvec3> positions(const SpotSetup& setup, const std::vector<SpotPoint>& points) {
  const parameters::SpotShadow shadow = setup.shadow();
  std::vector<glm::dvec3> positions;
  for (const SpotPoint& point : points) positions.push_back(world_position(shadow, point));
  return positions;
}

// normal is that of all receivers, in world space; 0 means towards the light's plane.
inline scene::Frame make_spot_frame(const SpotSetup& setup, const TexelDepth& depth,
                                    const std::vector<glm::dvec3>& positions, int width,
                                    const glm::dvec3& normal = glm::dvec3(0.0)) {
  scene::Frame frame;
  frame.scene_name = "synthetic";
  frame.spot_shadow = setup.shadow();
  frame.cascades.reversed_z = setup.reversed_z;
  frame.cascades.light_direction = frame.spot_shadow->light.direction;
  frame.cascades.atlas_width = frame.cascades.atlas_height = 2 * setup.slice_texels;
  frame.cascades.tile_resolution = setup.slice_texels;
  frame.settings.format = scene::DepthFormat::d32;
  frame.atlas = make_atlas(frame.cascades, depth);
  frame.receivers.width = frame.settings.width = width;
  frame.receivers.height = frame.settings.height = static_cast<int>(positions.size()) / width;
  const glm::dvec3 turned = normal == glm::dvec3(0.0) ? -frame.spot_shadow->light.direction : normal;
  for (const glm::dvec3& position : positions) {
    frame.receivers.position_ws.emplace_back(glm::vec3(position), 1.0F);
    frame.receivers.normal_ws.emplace_back(glm::vec3(turned), 0.0F);
  }
  return frame;
}

// The uniforms that tell the shader of the slice, as a pipeline with an atlas would tell it.
inline resolve::UniformValues slice_uniforms(const SpotSetup& setup) {
  const glm::dvec2 corner(0.5 * (setup.slice % 2), 0.5 * (setup.slice / 2));
  glm::dmat4 into(1.0);  // scales and moves u and v; both times w
  into[0][0] = into[1][1] = 0.5;
  into[3][0] = corner.x;
  into[3][1] = corner.y;
  const std::vector<glm::dmat4> matrices(5, into * setup.shadow().world_to_shadow);
  const std::vector<glm::vec4> tiles(4, glm::vec4(corner.x, corner.y, 0.5, 0.5));
  resolve::UniformValues values;
  values.set("_PenumbraWorldToShadow", std::span<const glm::dmat4>(matrices));
  values.set("_PenumbraTileOffsetScale", std::span<const glm::vec4>(tiles));
  return values;
}

inline resolve::ShadowGraph spot_graph(const techniques::Technique& technique, bool reversed_z) {
  return resolve::technique_graph(library_techniques(), technique, resolve::Taps::as_listed, reversed_z,
                                  techniques::LightKind::spot);
}

}  // namespace penumbra::testing_frames
