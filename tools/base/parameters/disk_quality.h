// The quality of a point set as a substitute for the unit disk.
//
// half_plane_rmse: root mean square error of coverage over straight shadow edges, the error a filter makes
//   in a penumbra. Edge direction uniform over the circle, edge offset t uniform in [-1, 1] across the disk:
//     RMSE^2 = mean over directions of 1/2 integral (F_N(t) - A(t))^2 dt
//   F_N(t) is the share of points before the edge, A(t) the share of the disk's area. The integral is the
//   energy distance of the projections (Szekely & Rizzo 2013), and a projection's mean length is 2/pi of the
//   vector's, so both averages are exact:
//     RMSE^2 = 1/pi [ 1/N sum g(|p_i|) - 64/(45 pi) - 1/(2 N^2) sum sum |p_i - p_j| ]
//   g(r): mean distance from a point at radius r to the disk, 128/(45 pi) the disk's own mean distance.
// star_discrepancy: of the points mapped to the unit square by the inverse concentric map (Shirley & Chiu
//   1997), which preserves area: the largest | share of points - area | over boxes [0, a) x [0, b), exact.
// radial_deviation: the largest | share of points within r - r^2 | (Kolmogorov-Smirnov distance).
// centroid: length of the mean of the points.  spacing: smallest distance of two points times sqrt(N).
#pragma once

#include <glm/vec2.hpp>
#include <span>

namespace penumbra::parameters {

struct DiskQuality {
  double centroid = 0.0;
  double radial_deviation = 0.0;
  double star_discrepancy = 0.0;
  double half_plane_rmse = 0.0;
  double spacing = 0.0;
};

DiskQuality disk_quality(std::span<const glm::vec2> points);

double half_plane_rmse(std::span<const glm::dvec2> points);

// g(r) above for 0 <= r <= 1, 4/(9 pi) ((7 + m) E(m) - 4 (1 - m) K(m)) with m = r^2 and the complete elliptic
// integrals, and dg/dm = 2/(3 pi) (E + K - (K - E)/m). Only + - * / and sqrt, so every IEEE machine computes
// the same bits.
struct DiskDistance {
  double mean = 0.0;
  double slope = 0.0;  // dg/dm
};
DiskDistance distance_to_disk(double radius_squared);

// Returns the point in [0, 1]^2 to which the inverse concentric map takes a point of the disk.
glm::dvec2 square_from_disk(const glm::dvec2& point);

}  // namespace penumbra::parameters
