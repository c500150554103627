// Light from every direction, tabulated, so that a ray that meets nothing costs a table's look-up.
//
// The table is an octahedral map of 256 x 256 directions over the whole sphere (Engelhardt and Dachsbacher,
// "Octahedron Environment Maps", VMV 2008), looked up bilinearly: details finer than about a degree blur.
// irradiance() is exact for light that varies like spherical harmonics of up to the second order (Ramamoorthi
// and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001), which skies
// are within a few per cent. Reentrant.
#pragma once

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace penumbra::lighting {

class SkyDome {
 public:
  // `radiance` is a function of unit directions.
  explicit SkyDome(const std::function<glm::dvec3(const glm::dvec3&)>& radiance);

  glm::vec3 radiance(const glm::vec3& direction) const;
  // Returns the irradiance of a surface under the unhidden dome; it is never negative.
  glm::vec3 irradiance(const glm::vec3& normal) const;

  std::span<const glm::vec3> table() const { return table_; }  // content to hash for a name

 private:
  std::vector<glm::vec3> table_;
  std::array<glm::dvec3, 9> harmonics_{};
};

}  // namespace penumbra::lighting
