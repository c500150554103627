// Random cameras, lights and shadow settings within what fit_cascades takes; the same seed gives the same.
#pragma once

#include <glm/geometric.hpp>
#include <random>

#include "parameters/cascades.h"

namespace penumbra::parameters {

struct ShadowSetup {
  Camera camera;
  Light light;
  ShadowSettings shadows;

  CascadeSet fit() const { return fit_cascades(camera, light, shadows); }
};

class SetupGenerator {
 public:
  explicit SetupGenerator(std::uint32_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    // The standard's std::uniform_real_distribution gives different numbers in different libraries.
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }

  int integer(int low, int high) { return low + static_cast<int>(uniform(0.0, high - low + 1.0)); }

  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      const double length = glm::length(v);
      if (length > 0.1 && length < 1.0) return v / length;
    }
  }

  ShadowSetup next() {
    ShadowSetup setup;
    setup.camera.position = {uniform(-500, 500), uniform(0, 50), uniform(-500, 500)};
    setup.camera.forward = direction();
    setup.camera.up = std::abs(setup.camera.forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    setup.camera.fov_y_degrees = uniform(20, 110);
    setup.camera.aspect = uniform(0.5, 2.4);
    setup.camera.near_plane = uniform(0.05, 0.5);
    setup.camera.far_plane = uniform(60, 2000);
    setup.light.direction = direction() * uniform(0.1, 10);
    setup.light.angular_diameter_degrees = uniform(0.05, 30);
    setup.shadows.distance_metres = uniform(20, 300);
    setup.shadows.cascades = integer(1, 4);
    setup.shadows.resolution = 256 << integer(0, 4);
    setup.shadows.reversed_z = integer(0, 1) == 1;
    setup.shadows.clip_depth = integer(0, 1) == 1 ? ClipDepth::zero_to_one : ClipDepth::minus_one_to_one;
    setup.shadows.soft_quality = static_cast<SoftQuality>(integer(0, 3));
    if (integer(0, 2) == 0) setup.shadows.depth_range_metres = uniform(10, 2000);
    return setup;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace penumbra::parameters
