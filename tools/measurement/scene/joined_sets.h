// Disjoint sets that are joined one after the other: Tarjan, "Efficiency of a Good But Not Linear Set Union
// Algorithm" (1975).
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace penumbra::scene {

class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : next_(count) { std::iota(next_.begin(), next_.end(), 0U); }

  // A set is named by its lowest member, so that the result does not depend on the order of the joins.
  std::uint32_t of(std::uint32_t member) {
    while (next_[member] != member) member = next_[member] = next_[next_[member]];
    return member;
  }

  void join(std::uint32_t one, std::uint32_t other) {
    const std::uint32_t first = of(one), second = of(other);
    next_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> next_;
};

}  // namespace penumbra::scene
