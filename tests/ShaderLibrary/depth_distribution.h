// Distributions of depth whose moments, and whose share at or behind any depth, are known.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {

struct Depths {
  std::vector<double> at;
  std::vector<double> share;

  double mean(int power) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += share[i] * std::pow(at[i], power);
    return sum;
  }
  double behind(double depth) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += at[i] >= depth ? share[i] : 0.0;
    return sum;
  }
  double smallest_gap() const {
    std::vector<double> sorted = at;
    std::sort(sorted.begin(), sorted.end());
    double gap = 2.0;
    for (std::size_t i = 1; i < sorted.size(); ++i) gap = std::min(gap, sorted[i] - sorted[i - 1]);
    return gap;
  }
};

// `count` depths in [-extent, extent], each with at least a twentieth of the largest share.
inline Depths drawn(Random& random, float extent, int count) {
  Depths depths;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    depths.at.push_back(random.between(-extent, extent));
    depths.share.push_back(random.between(0.05f, 1.0f));
    sum += depths.share.back();
  }
  for (double& share : depths.share) share /= sum;
  return depths;
}

}  // namespace penumbra::shader_library_tests
