// Cases and checks that the tests of every filter share.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "as_identifier.h"

namespace penumbra::resolve {

struct FilterCase {
  std::string technique;
  bool reversed_z;

  friend void PrintTo(const FilterCase& value, std::ostream* stream) {
    *stream << value.technique << (value.reversed_z ? ", reversed Z" : ", conventional Z");
  }
};

inline std::string case_name(const testing::TestParamInfo<FilterCase>& instance) {
  return as_identifier(instance.param.technique +
                       (instance.param.reversed_z ? "_reversed" : "_conventional"));
}

inline void expect_all(const std::vector<float>& seen, float wanted, const std::string& what,
                       float error = 0.0F) {
  for (std::size_t i = 0; i < seen.size(); ++i)
    ASSERT_NEAR(seen[i], wanted, error) << what << ": receiver " << i;
}

inline void expect_in_range(const std::vector<float>& seen, const std::string& what) {
  for (std::size_t i = 0; i < seen.size(); ++i)
    ASSERT_TRUE(seen[i] >= 0.0F && seen[i] <= 1.0F) << what << ": " << seen[i] << " at receiver " << i;
}

// To the bit, since nothing outside of the tile or slice counts.
inline void expect_same(const std::vector<float>& seen, const std::vector<float>& before,
                        const std::string& what) {
  for (std::size_t i = 0; i < before.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint32_t>(seen[i]), std::bit_cast<std::uint32_t>(before[i]))
        << what << ", receiver " << i << ": " << seen[i] << " instead of " << before[i];
}

// A map of structure at every scale: a hash of the texel, some near, some far.
inline float rough_depth(double u, double v, int tile) {
  const auto bits = static_cast<std::uint32_t>(u * 9973.0) * 2654435761U +
                    static_cast<std::uint32_t>(v * 7919.0) * 2246822519U + static_cast<std::uint32_t>(tile);
  return static_cast<float>((bits ^ (bits >> 15)) % 1000) / 999.0F;
}

}  // namespace penumbra::resolve
