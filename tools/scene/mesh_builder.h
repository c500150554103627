// Solids in metres, gathered into one indexed mesh.
//
// Winding: cross(b - a, c - a) of a triangle (a, b, c) points out of the solid. In Unity's left-handed space
// that is clockwise seen from outside, Unity's front face. Every solid is closed; faces of a box have their
// own vertices (flat normals), the mantle of a tube shares them (smooth normals).
//
// What is drawn has the material in use at that time.
//
// All is computed in double and rounded once, to multiples of 2^-20 (a micrometre), so that the last bits in
// which mathematics libraries differ do not reach the mesh: the same calls give the same bytes on every
// machine.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace penumbra::scene {

struct Pose {
  glm::dvec3 centre{0.0};
  glm::dmat3 rotation{1.0};
};

// Turns about +Y (yaw), then tilts about the turned X (pitch) and Z (roll), all in degrees.
glm::dmat3 rotation(double yaw_degrees, double pitch_degrees = 0.0, double roll_degrees = 0.0);

// A cylinder or a truncated cone with caps; both radii must be positive.
struct Tube {
  glm::dvec3 from;
  glm::dvec3 to;
  double radius_from;
  double radius_to;
  int sides = 8;
};

// A roof: the ridge runs along z over the middle of a base that lies in the plane of base_centre.
struct Gable {
  glm::dvec3 base_centre;
  glm::dvec3 size;
};

class MeshBuilder {
 public:
  // The surface of all that follows, until the next. One material of a name is kept, the first. Before the
  // first call it is Material's default.
  void use(const Material& material);

  // A flat quadrilateral, two triangles; corners in winding order. The only shape here that is not closed.
  void quad(const std::array<glm::dvec3, 4>& corners);
  void box(const Pose& pose, const glm::dvec3& size);
  void standing_box(const glm::dvec3& base_centre, const glm::dvec3& size, double yaw_degrees = 0.0);
  void tube(const Tube& tube);
  void gable(const Gable& gable);
  // Horizontal square at y = 0.
  void ground(const glm::dvec3& centre, double half_size);

  Mesh take() { return std::move(mesh_); }
  void move_into(Scene& scene);  // the mesh and its materials

 private:
  std::uint32_t vertex(const glm::dvec3& position, const glm::dvec3& normal);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void flat_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
  void cap(const Tube& tube, const std::array<glm::dvec3, 2>& across, bool at_end);

  Mesh mesh_;
  std::vector<Material> materials_{Material{}};
  std::uint16_t material_ = 0;
};

}  // namespace penumbra::scene
