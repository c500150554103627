// Measures how far a float on the GPU lies from the same function in long double, in ULP.
//
// The ULP is the spacing of floats at `scale`: the size of the largest term the result is made of. Where
// terms cancel, a result's own spacing says nothing about how well it was computed; where they do not, scale
// is the result itself.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "ShaderLibrary/core_function.h"

namespace penumbra::shader_library_tests {

struct Exact {
  long double value = 0.0L;
  long double scale = 0.0L;  // 0: that of the value
};

inline long double ulp_at(long double scale) {
  const float magnitude = static_cast<float>(std::fabs(scale));
  if (!(magnitude >= std::numeric_limits<float>::min())) return std::numeric_limits<float>::min();
  return std::ldexp(1.0L, std::ilogb(magnitude) - 23);
}

inline long double error_in_ulp(float got, const Exact& exact) {
  if (!std::isfinite(got)) return std::numeric_limits<long double>::infinity();
  return std::fabs(got - exact.value) / ulp_at(exact.scale == 0.0L ? exact.value : exact.scale);
}

// One case's inputs and the function's exact outputs for them.
using Reference = std::function<std::vector<Exact>(const float* inputs)>;

inline std::string words(const float* first, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += (i ? ", " : "") + std::to_string(first[i]);
  return text;
}

// Runs the function in one direction and expects every output within `largest_ulp` of the reference.
inline void expect_exact(const CoreFunction& function, DepthDirection direction,
                         const std::vector<float>& inputs, const Reference& reference,
                         long double largest_ulp) {
  const std::vector<float> results = run(function, direction, inputs);
  const std::size_t cases = inputs.size() / std::size_t(function.inputs);
  ASSERT_GE(cases, 10000u) << function.statement;
  long double worst = -1.0L;
  std::size_t worst_case = 0;
  int worst_output = 0;
  for (std::size_t i = 0; i < cases; ++i) {
    const std::vector<Exact> exact = reference(&inputs[i * std::size_t(function.inputs)]);
    ASSERT_EQ(exact.size(), std::size_t(function.outputs));
    for (int k = 0; k < function.outputs; ++k) {
      const long double error =
          error_in_ulp(results[i * std::size_t(function.outputs) + std::size_t(k)], exact[std::size_t(k)]);
      if (!(error <= worst)) {
        worst = error;
        worst_case = i;
        worst_output = k;
      }
    }
  }
  const float* at = &inputs[worst_case * std::size_t(function.inputs)];
  const float got = results[worst_case * std::size_t(function.outputs) + std::size_t(worst_output)];
  EXPECT_LE(worst, largest_ulp) << function.statement << "\n  inputs " << words(at, function.inputs)
                                << "\n  output " << worst_output << " is " << got << ", exactly "
                                << static_cast<double>(reference(at)[std::size_t(worst_output)].value);
  ::testing::Test::RecordProperty("worst_ulp", std::to_string(static_cast<double>(worst)));
}

inline void expect_exact(const CoreFunction& function, const std::vector<float>& inputs,
                         const Reference& reference, long double largest_ulp) {
  expect_exact(function, DepthDirection::conventional, inputs, reference, largest_ulp);
}

// Runs the function and expects every output between the two, which NaN is not.
inline void expect_within(const CoreFunction& function, const std::vector<float>& inputs, float low,
                          float high) {
  const std::vector<float> results = run(function, inputs);
  for (std::size_t i = 0; i < results.size(); ++i)
    ASSERT_TRUE(results[i] >= low && results[i] <= high)
        << function.statement << "\n  output " << i << " is " << results[i];
}

}  // namespace penumbra::shader_library_tests
