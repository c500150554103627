// Builds one indexed mesh from solids, in metres.
//
// Winding: cross(b - a, c - a) of a triangle (a, b, c) points out of the solid. In Unity's left-handed space
// that is clockwise seen from outside, Unity's front face. Every solid is closed; faces of a box have their
// own vertices (flat normals), the lateral surface of a tube shares them (smooth normals).
//
// Solids get the current material. Texture coordinates are in units of the texture's size in metres on the
// surface; u runs along the grain: a quad's longer edge, a tube's axis.
//
// Everything is computed in double and rounded once, to multiples of 2^-20 (a micrometre), so that
// differences in the last bits of mathematics libraries do not affect the mesh: the same calls give the same
// bytes on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace penumbra::scene {

struct Pose {
  glm::dvec3 centre{0.0};
  glm::dmat3 rotation{1.0};
};

// The rotation turns about +Y (yaw), then tilts about the turned X (pitch) and Z (roll), all in degrees.
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

// A surface of revolution about the pose's Y axis. The profile holds (radius, height) pairs and has its
// outside on its right as it climbs: from the axis out, up and, for a vessel, down its inside to the axis
// again. It is smooth where it bends by less than 50 degrees.
struct Lathe {
  Pose pose;  // its centre is the place of (0, 0) of the profile
  std::vector<std::array<double, 2>> profile;
  int sides = 24;
};

// A round bar along a bent line, closed by flat ends.
struct Bar {
  std::vector<glm::dvec3> path;  // at least two points
  double radius;
  int sides = 8;
};

// A box with rounded edges whose eight corners may be moved, as of hewn stone: corner_shift's index has bit 0
// for +x, bit 1 for +y, bit 2 for +z. Twice the radius is less than every side.
struct RoundedBox {
  Pose pose;
  glm::dvec3 size;
  double radius;
  std::array<glm::dvec3, 8> corner_shift{};
};

// A leaf or petal, folded along its midrib; one sheet of four triangles. Its upper side looks towards
// cross(along, across).
struct Leaf {
  glm::dvec3 stalk;
  glm::dvec3 along;   // unit, from the stalk to the tip
  glm::dvec3 across;  // unit, at a right angle to it
  double length;
  double width;
  double fold_degrees = 25.0;  // the angle by which each half is turned up
};

class MeshBuilder {
 public:
  // Sets the material of all shapes that follow, until the next call. The first material of a name is kept.
  // Before the first call it is Material's default. metres_per_texture is the length of an edge of its
  // textures.
  void use(const Material& material, double metres_per_texture = 1.0);
  // Adds a texture that materials can refer to; returns its index.
  int add_texture(Texture texture);

  // Adds a flat quadrilateral of two triangles, with its corners in winding order. It is not closed.
  void quad(const std::array<glm::dvec3, 4>& corners);
  // Adds a parallelogram with so many repeats of its texture along the first edge and the second.
  void card(const std::array<glm::dvec3, 4>& corners, const glm::dvec2& repeats = {1.0, 1.0});
  void box(const Pose& pose, const glm::dvec3& size);
  void standing_box(const glm::dvec3& base_centre, const glm::dvec3& size, double yaw_degrees = 0.0);
  void tube(const Tube& tube);
  void gable(const Gable& gable);
  void lathe(const Lathe& lathe);
  void bar(const Bar& bar);
  void rounded_box(const RoundedBox& box);
  void leaf(const Leaf& leaf);                                                   // not closed
  void triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);  // flat, not closed
  // Adds a smooth surface without an underside, from level squares of this edge, so many each way from the
  // smallest x and z on, at their corners' heights. `heights` are those of (cells + 1)^2 corners, rows along
  // +x.
  void heights(const glm::dvec2& corner, double cell, int cells, const std::vector<double>& heights);
  // Adds a horizontal square at y = 0.
  void ground(const glm::dvec3& centre, double half_size);

  Mesh take() { return std::move(mesh_); }
  void move_into(Scene& scene);  // the mesh, its materials and textures

 private:
  struct Ring;  // a ring of a lathe or a bar

  // uv is in metres on the surface.
  std::uint32_t vertex(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec2& uv);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void join(const Ring& low, const Ring& high, int sides);
  void rounded_face(const RoundedBox& box, int axis, double sign);
  void cap(const Tube& tube, const std::array<glm::dvec3, 2>& across, bool at_end);

  Mesh mesh_;
  std::vector<Material> materials_{Material{}};
  std::vector<Texture> textures_;
  std::uint16_t material_ = 0;
  double metres_per_texture_ = 1.0;
};

}  // namespace penumbra::scene
