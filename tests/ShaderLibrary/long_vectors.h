// Vectors in long double, against which what shaders compute in float is tested.
#pragma once

#include <array>
#include <cmath>

namespace penumbra::shader_library_tests {

using Real = long double;
using Vector = std::array<Real, 3>;

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Real dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector along(const Vector& from, Real length, const Vector& way) {
  return {from[0] + length * way[0], from[1] + length * way[1], from[2] + length * way[2]};
}
inline Vector unit(const Vector& a) {
  return along({0, 0, 0}, 1.0L / std::sqrt(dot(a, a)), a);
}

}  // namespace penumbra::shader_library_tests
