// The Pareto front: the choices for which nothing is both cheaper and better.
#pragma once

#include <cstddef>
#include <vector>

namespace penumbra::study {

struct CostAndError {
  double cost = 0.0;
  double error = 0.0;
};

// Returns the indices of the points that no other point dominates, by rising cost. A point dominates another
// when it is not worse in either figure and better in one; equal points are kept together. Points that are
// not finite are excluded.
std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

}  // namespace penumbra::study
