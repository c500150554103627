#include "parameters/golden_cameras.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace penumbra::parameters {

namespace {

struct Lens {
  double tan_half_y = 0.577;  // half the height of view at distance 1, or in metres where orthographic
  double aspect = 16.0 / 9.0;
  double shift_x = 0.0;  // off-centre, in halves of the picture
  double shift_y = 0.0;
  double near_plane = 0.3;
  double far_plane = 1000.0;  // may be infinite
  bool orthographic = false;
};

glm::dmat4 rows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z, const glm::dvec4& w) {
  return glm::transpose(glm::dmat4(x, y, z, w));
}

glm::dmat4 as_floats(const glm::dmat4& matrix) {
  glm::dmat4 rounded(0.0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) rounded[column][row] = static_cast<float>(matrix[column][row]);
  }
  return rounded;
}

// Returns Unity's matrix from world to view: the camera looks down -z.
glm::dmat4 look(const glm::dvec3& position, const glm::dvec3& direction) {
  const glm::dvec3 forward = glm::normalize(direction);
  const glm::dvec3 hint = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(hint, forward));
  const glm::dvec3 up = glm::cross(forward, right);
  return as_floats(rows({right, -glm::dot(right, position)}, {up, -glm::dot(up, position)},
                        {-forward, glm::dot(forward, position)}, {0, 0, 0, 1}));
}

// The projection gives clip depth 1 at the near plane and 0 at the far plane.
glm::dmat4 reversed_projection(const Lens& lens) {
  const double x = 1.0 / (lens.tan_half_y * lens.aspect);
  const double y = 1.0 / lens.tan_half_y;
  const double n = lens.near_plane;
  if (lens.orthographic) {
    const double range = lens.far_plane - n;
    return rows({x, 0, 0, lens.shift_x}, {0, y, 0, lens.shift_y}, {0, 0, 1 / range, 1 + n / range},
                {0, 0, 0, 1});
  }
  // With view depth z < 0, depth is (n z + n f) / (f - n) before the division; at an infinite far plane it is
  // n alone.
  const double per_far = std::isinf(lens.far_plane) ? 0.0 : n / (lens.far_plane - n);
  return rows({x, 0, lens.shift_x, 0}, {0, y, lens.shift_y, 0}, {0, 0, per_far, n + n * per_far},
              {0, 0, -1, 0});
}

// The conventions of a device, on a projection to reversed depth.
enum class Device { direct3d, direct3d_flipped, direct3d_forward_depth, opengl };

glm::dmat4 for_device(const glm::dmat4& reversed, Device device) {
  glm::dmat4 change(1.0);
  if (device == Device::direct3d_flipped) change[1][1] = -1;
  if (device == Device::direct3d_forward_depth)
    change = rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 1}, {0, 0, 0, 1});
  if (device == Device::opengl) change = rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -2, 1}, {0, 0, 0, 1});
  return as_floats(change * reversed);
}

GoldenCamera camera(const std::string& name, const glm::dmat4& view, const Lens& lens, Device device) {
  const bool opengl = device == Device::opengl;
  return {name, view, for_device(reversed_projection(lens), device),
          ScreenConventions{.uv_starts_at_top = !opengl, .depth_is_zero_to_one = !opengl}};
}

// Clips at a mirror's plane (view space, facing the camera) in place of the near plane: depth is 0 .. 1 of
// the plane's distance over a far corner's (Lengyel, "Oblique view frustum depth projection and clipping",
// 2005).
GoldenCamera oblique(const std::string& name, const glm::dmat4& view, const glm::dvec4& plane) {
  GoldenCamera result = camera(name, view, Lens{}, Device::direct3d_forward_depth);
  glm::dmat4& m = result.gpu_projection;
  const glm::dvec4 corner =
      glm::inverse(m) * glm::dvec4(std::copysign(1, plane.x), std::copysign(1, plane.y), 1, 1);
  const glm::dvec4 row = plane / glm::dot(plane, corner);
  for (int column = 0; column < 4; ++column) m[column][2] = static_cast<float>(row[column]);
  return result;
}

std::vector<GoldenCamera> awkward_cameras() {
  const glm::dmat4 view = look({12.5, 1.7, -40}, {0.3, -0.2, 1});
  const glm::dmat4 mirrored = glm::dmat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) * view;
  const auto lens = [](auto&& change) {
    Lens result;
    change(result);
    return result;
  };
  return {
      camera("at the origin", glm::dmat4(1.0), Lens{}, Device::direct3d),
      camera("flipped for a texture", view, Lens{}, Device::direct3d_flipped),
      camera("depth not reversed", view, Lens{}, Device::direct3d_forward_depth),
      camera("OpenGL", view, Lens{}, Device::opengl),
      camera("left eye", view, lens([](Lens& l) {
               l.shift_x = -0.213;
               l.shift_y = 0.0312;
             }),
             Device::direct3d_flipped),
      camera("orthographic, off-centre", view, lens([](Lens& l) {
               l.orthographic = true;
               l.tan_half_y = 12;
               l.shift_x = 0.4;
             }),
             Device::direct3d),
      camera("orthographic, OpenGL", view, lens([](Lens& l) {
               l.orthographic = true;
               l.tan_half_y = 250;
             }),
             Device::opengl),
      camera("100 km from the origin", look({1e5, 230, -1e5}, {-1, -0.1, 1}), Lens{},
             Device::direct3d_flipped),
      camera("near plane at a tenth of a millimetre", view, lens([](Lens& l) {
               l.near_plane = 1e-4;
               l.far_plane = 1e6;
             }),
             Device::direct3d_forward_depth),
      camera("infinite far plane", view, lens([](Lens& l) { l.far_plane = HUGE_VAL; }), Device::direct3d),
      camera("lens of half a degree", view, lens([](Lens& l) { l.tan_half_y = 0.00436; }), Device::direct3d),
      camera("lens of 175 degrees", view, lens([](Lens& l) { l.tan_half_y = 22.9; }), Device::direct3d),
      camera("mirrored view", mirrored, Lens{}, Device::direct3d_flipped),
      oblique("oblique near plane", view, {0.2, -0.6, -0.7, -3.0}),
  };
}

GoldenCamera random_camera(int index, SetupGenerator& generator) {
  const double far_away = std::pow(10.0, generator.uniform(0, 5));
  const glm::dvec3 position = generator.direction() * far_away;
  Lens lens;
  lens.orthographic = generator.integer(0, 4) == 0;
  lens.tan_half_y = lens.orthographic ? generator.uniform(1, 100) : generator.uniform(0.1, 2);
  lens.aspect = generator.uniform(0.4, 2.5);
  lens.shift_x = generator.uniform(-0.5, 0.5);
  lens.shift_y = generator.uniform(-0.5, 0.5);
  lens.near_plane = std::pow(10.0, generator.uniform(-2, 0.5));
  lens.far_plane = std::pow(10.0, generator.uniform(1, 4.5));
  const auto device = static_cast<Device>(generator.integer(0, 3));
  return camera(fmt::format("random {}", index), look(position, generator.direction()), lens, device);
}

}  // namespace

std::vector<GoldenCamera> golden_cameras(int random, SetupGenerator& generator) {
  std::vector<GoldenCamera> cameras = awkward_cameras();
  for (int i = 0; i < random; ++i) cameras.push_back(random_camera(i, generator));
  return cameras;
}

}  // namespace penumbra::parameters
