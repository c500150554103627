#include "study/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace penumbra::study {

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(points[a].cost, points[a].error, a) < std::tuple(points[b].cost, points[b].error, b);
  });

  // In the order of cost, a point is in the front if its error is below the smallest so far, or if it equals
  // the point with the smallest.
  std::vector<std::size_t> front;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    const bool twin =
        !front.empty() && points[i].cost == points[front.back()].cost && points[i].error == best;
    if (points[i].error < best || twin) {
      front.push_back(i);
      best = points[i].error;
    }
  }
  return front;
}

}  // namespace penumbra::study
