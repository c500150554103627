// Bounds of visibility from moments of depth, in long double and by other means than the shaders'. They are
// the answers of filtered maps.
#pragma once

#include <array>
#include <cmath>

namespace penumbra::resolve::testing_bounds {

using Real = long double;

// This is Cantelli's inequality.
inline Real chebyshev(Real mean, Real square, Real depth, Real smallest_variance) {
  const Real variance = std::max(square - mean * mean, smallest_variance);
  const Real behind = depth - mean;
  return behind > 0 ? variance / (variance + behind * behind) : 1;
}

// The inverse of the Hankel matrix of moments 0 to 4, by cofactors; it is symmetric.
class HankelInverse {
 public:
  explicit HankelInverse(const std::array<Real, 4>& b) {
    const Real m[3][3] = {{1, b[0], b[1]}, {b[0], b[1], b[2]}, {b[1], b[2], b[3]}};
    const auto cofactor = [&](int r, int c) {
      const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
      return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    };
    const Real determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) at_[r][c] = cofactor(c, r) / determinant;
  }
  // The inverse times (1, x, x^2).
  std::array<Real, 3> times(Real x) const {
    std::array<Real, 3> product{};
    for (std::size_t r = 0; r < 3; ++r) product[r] = at_[r][0] + at_[r][1] * x + at_[r][2] * x * x;
    return product;
  }

 private:
  Real at_[3][3];
};

// The share of the depths before `depth`, and that share times their mean gap.
struct Nearer {
  Real share = 0;
  Real gap_sum = 0;
};

// The nearer depths of the canonical distribution with these four moments: it has `depth` and two more
// depths, whose weights follow from the moments 0 and 1 (Peters and Klein 2015, section 2).
inline Nearer nearer(std::array<Real, 4> moments, Real depth, Real mix) {
  const std::array<Real, 4> smooth{0, 0.375L, 0, 0.375L};
  for (std::size_t i = 0; i < 4; ++i) moments[i] += mix * (smooth[i] - moments[i]);
  const std::array<Real, 3> c = HankelInverse(moments).times(depth);
  const Real own = 1 / (c[0] + c[1] * depth + c[2] * depth * depth);
  const Real middle = -c[1] / (2 * c[2]);
  const Real half = std::sqrt(std::max(middle * middle - c[0] / c[2], Real(0)));
  const Real low = middle - half, high = middle + half;
  // The shares follow from low_share + high_share = 1 - own and low_share low + high_share high = mean - own
  // depth.
  const Real high_share = (moments[0] - own * depth - (1 - own) * low) / (high - low);
  const Real low_share = 1 - own - high_share;
  Nearer nearer;
  if (low < depth) nearer = {low_share, low_share * (depth - low)};
  if (high < depth) nearer = {nearer.share + high_share, nearer.gap_sum + high_share * (depth - high)};
  return nearer;
}

// The largest share at or behind `depth` of any distribution with these four moments.
inline Real hamburger(const std::array<Real, 4>& moments, Real depth, Real mix) {
  return 1 - nearer(moments, depth, mix).share;
}

}  // namespace penumbra::resolve::testing_bounds
