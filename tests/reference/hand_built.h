// Scenes, receivers and shadow maps whose soft shadows are known exactly. Everything is laid out in the
// light's own frame: metres across the light (right, up) and towards it, from a chosen centre.
#pragma once

#include <cmath>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "reference/lit_receiver.h"
#include "reference/visibility_image.h"
#include "scene/frame.h"
#include "scene/scene.h"

namespace penumbra::reference::hand_built {

struct Setting {
  parameters::Light light{{0.3, -0.8, 0.5}, 5.0};
  glm::dvec3 centre{0.0};  // relative to the scene's origin

  DiscLight disc() const { return disc_light(light); }
  // The tangent is computed anew, so that the tests do not take the library's word for it.
  double tan_half() const { return std::tan(light.angular_diameter_degrees * std::numbers::pi / 360.0); }
  glm::dvec3 at(double across, double along, double towards) const;
};

struct Rectangle {
  double left, right, bottom, top;
};

// Adds a rectangle perpendicular to the light, at this height over the centre.
void add_rectangle(scene::Mesh& mesh, const Setting& setting, const Rectangle& rectangle, double towards);
// Adds a circle about the centre, as a fan of triangles.
void add_circle(scene::Mesh& mesh, const Setting& setting, double radius, double towards);

// Receivers in the plane perpendicular to the light through the centre, at place(x, y).
scene::Receivers receivers(const Setting& setting, ImageSize size,
                           const std::function<glm::dvec2(int x, int y)>& place);

double mean(const VisibilityImage& image);  // over all pixels

// The visibility at this distance (metres, positive: in the open) from the shadow of a straight edge at this
// gap: the share of a disc beyond a chord.
double visible_past_edge(double distance, double gap, double tan_half);

// A map of one cascade, texel (0, 0)'s corner at (-extent/2, -extent/2) metres from the centre; stored depth
// covers heights 0 (far) to 40 m (near) less 10: gaps -10 .. 30 over the centre.
struct MapSettings {
  int resolution = 64;
  double extent = 6.4;
  bool reversed_z = true;
  scene::DepthFormat format = scene::DepthFormat::d32;
};
struct Map {
  scene::ShadowAtlas atlas;
  parameters::CascadeSet cascades;

  // The gap is that of the square's height over the centre.
  void set_gap(int column, int row, double gap_metres);
  void set_depth(int column, int row, float depth);
  double stored_depth(double gap_metres) const;
};
Map empty_map(const Setting& setting, const MapSettings& settings = {}, const glm::dvec3& origin = {});

}  // namespace penumbra::reference::hand_built
