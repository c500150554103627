#include "scene/frame.h"

#include <glm/geometric.hpp>

#include "input/input_error.h"
#include "scene/seen_surfaces.h"
#include "scene/shadow_map.h"

namespace penumbra::scene {
namespace {

const Mesh& checked(const Scene& scene) {
  const Mesh& mesh = scene.mesh;
  if (mesh.indices.empty() || mesh.indices.size() % 3 != 0) {
    throw InputError("", "scene '" + scene.name + "' has no triangles, or part of one");
  }
  if (mesh.normals.size() != mesh.positions.size()) {
    throw InputError("", "scene '" + scene.name + "' does not have one normal per position");
  }
  for (const std::uint32_t index : mesh.indices) {
    if (index < mesh.positions.size()) continue;
    throw InputError("", "scene '" + scene.name + "': index " + std::to_string(index) + " of " +
                             std::to_string(mesh.positions.size()) + " vertices");
  }
  return mesh;
}

void check(const FrameSettings& settings) {
  if (settings.width > 0 && settings.height > 0) return;
  throw InputError(
      "",
      "a picture of " + std::to_string(settings.width) + " x " + std::to_string(settings.height) + " pixels",
      "width and height are at least 1");
}

parameters::ShadowSettings with_caster_bounds(parameters::ShadowSettings shadows, const Scene& scene) {
  if (shadows.depth_range_metres || shadows.caster_bounds) return shadows;
  const parameters::Bounds bounds = scene.bounds();
  shadows.caster_bounds = parameters::Bounds{bounds.minimum + scene.origin, bounds.maximum + scene.origin};
  return shadows;
}

// Returns the positions of the pixels that show a surface within the shadow distance.
std::vector<glm::dvec3> seen_positions(const Receivers& receivers, const Scene& scene,
                                       double shadow_distance) {
  std::vector<glm::dvec3> positions;
  for (std::size_t i = 0; i < receivers.position_ws.size(); ++i) {
    const glm::dvec3 position(receivers.position_relative[i]);
    if (receivers.position_ws[i].w != 0.0F &&
        glm::distance(position, scene.camera.position) <= shadow_distance)
      positions.push_back(scene.origin + position);
  }
  return positions;
}

parameters::SpotShadow spot_shadow_of(const Scene& scene, const parameters::ShadowSettings& shadows) {
  parameters::SpotLight light = scene.spot_light.value();
  light.position += scene.origin;
  return parameters::spot_shadow(light, shadows);
}

parameters::CascadeSet conventions_of(const parameters::SpotShadow& shadow) {
  parameters::CascadeSet set;
  set.reversed_z = shadow.reversed_z;
  set.clip_depth = shadow.clip_depth;
  set.angular_diameter_degrees = 0.0;
  set.light_direction = shadow.light.direction;
  set.atlas_width = set.atlas_height = set.tile_resolution = shadow.resolution;
  set.depth_range_source = "the spot light's near plane and range";
  return set;
}

}  // namespace

struct Rasteriser::State {
  State(gpu::Device& device, const Scene& given)
      : scene(given),
        mesh(device, checked(given), CutOuts(given)),
        shadow_map(device, mesh),
        seen(device, mesh),
        ground_metres(ground_level(given.mesh) + given.origin.y),
        balls(object_balls(given.mesh, kMostBalls)) {
    for (Ball& ball : balls) ball.centre += given.origin;
  }

  const Scene& scene;
  MeshOnDevice mesh;
  ShadowMapPasses shadow_map;
  SeenSurfacesPass seen;
  double ground_metres;
  std::vector<Ball> balls;
};

Rasteriser::Rasteriser(gpu::Device& device, const Scene& scene)
    : state_(std::make_unique<State>(device, scene)) {}
Rasteriser::~Rasteriser() = default;
Rasteriser::Rasteriser(Rasteriser&&) noexcept = default;

Frame Rasteriser::frame(const FrameSettings& settings) {
  check(settings);
  const Scene& scene = state_->scene;
  Frame frame;
  frame.scene_name = scene.name;
  frame.settings = settings;
  frame.camera = scene.camera;
  frame.camera.position += scene.origin;
  frame.receivers = state_->seen.draw(scene, settings);
  frame.ground_metres = state_->ground_metres;
  frame.balls = state_->balls;
  if (scene.spot_light) {
    frame.spot_shadow = spot_shadow_of(scene, settings.shadows);
    frame.cascades = conventions_of(*frame.spot_shadow);
    frame.atlas = state_->shadow_map.draw(*frame.spot_shadow, scene.origin, settings);
  } else {
    const CascadeChoices& choices = settings.cascade_choices;
    const parameters::Light light{sun_before(scene.light_direction, choices.map_age_degrees),
                                  settings.angular_diameter_degrees};
    frame.cascades = parameters::fit_cascades(
        frame.camera, light, with_caster_bounds(settings.shadows, scene), choices.light_fit,
        seen_positions(frame.receivers, scene, settings.shadows.distance_metres));
    frame.atlas = state_->shadow_map.draw(frame.cascades, scene.origin, settings);
  }
  return frame;
}

Frame rasterise(gpu::Device& device, const Scene& scene, const FrameSettings& settings) {
  return Rasteriser(device, scene).frame(settings);
}

}  // namespace penumbra::scene
