#include "lighting/smoothed_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "lighting/rows.h"

namespace penumbra::lighting {
namespace {

constexpr std::array<float, 5> kSpline{1.0F / 16, 1.0F / 4, 3.0F / 8, 1.0F / 4, 1.0F / 16};

// Returns 1 for a neighbour on the same plane that faces the same way. The weight falls towards 0 over some
// 15 degrees or a slope of one tenth.
float likeness(const SurfacePoint& point, const SurfacePoint& other) {
  const float cosine = glm::dot(point.normal, other.normal);
  if (cosine <= 0.9F) return 0.0F;
  const glm::vec3 apart = other.position - point.position;
  const float distance = glm::length(apart);
  if (distance == 0.0F) return 1.0F;
  const float slope = std::abs(glm::dot(apart, point.flat_normal)) / distance;
  const float facing = (cosine - 0.9F) * 10.0F;
  return facing * facing * std::max(1.0F - 10.0F * slope, 0.0F);
}

std::vector<glm::vec3> one_pass(const SeenMaterials& seen, const std::vector<glm::vec3>& light, int step,
                                const reference::RunOptions& run) {
  std::vector<glm::vec3> result(light.size(), glm::vec3(0.0F));
  const auto index = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(seen.width) +
           static_cast<std::size_t>(column);
  };
  for_each_row(seen.height, run, [&](int row) {
    for (int column = 0; column < seen.width; ++column) {
      const std::size_t pixel = index(column, row);
      if (seen.seen[pixel] == 0) continue;
      glm::vec3 sum(0.0F);
      float weights = 0.0F;
      for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
          const int x = column + i * step;
          const int y = row + j * step;
          if (x < 0 || y < 0 || x >= seen.width || y >= seen.height || seen.seen[index(x, y)] == 0) continue;
          const std::size_t other = index(x, y);
          const float weight = kSpline[static_cast<std::size_t>(i + 2)] *
                               kSpline[static_cast<std::size_t>(j + 2)] *
                               likeness(seen.points[pixel], seen.points[other]);
          sum += light[other] * weight;
          weights += weight;
        }
      }
      result[pixel] = weights > 0.0F ? sum / weights : light[pixel];
    }
  });
  return result;
}

}  // namespace

std::vector<glm::vec3> smoothed(const SeenMaterials& seen, std::vector<glm::vec3> light, int passes,
                                const reference::RunOptions& run) {
  for (int pass = 0; pass < passes; ++pass) light = one_pass(seen, light, 1 << pass, run);
  return light;
}

}  // namespace penumbra::lighting
