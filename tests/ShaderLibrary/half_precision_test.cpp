// Tells which functions of the library may be computed with 16-bit half, by the largest difference to the
// same function in float over the values that scenes have.
//
// The test prints a line for each function, from which scripts/pages makes the page, and
// compares it with half_precision.json, which holds the lines of the last run of the page.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "ShaderLibrary/half_functions.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr int kCases = 20000;

// The largest difference of an output; infinity where half is not finite and float is.
double largest_difference(const HalfFunction& tested, DepthDirection direction) {
  Random random(71);
  std::vector<float> inputs;
  for (int i = 0; i < kCases; ++i) {
    const Case one = tested.inputs(random);
    EXPECT_EQ(one.size(), std::size_t(tested.called.inputs)) << tested.function;
    inputs.insert(inputs.end(), one.begin(), one.end());
  }
  CoreFunction half = tested.called;
  half.half = true;
  const std::vector<float> in_float = run(tested.called, direction, inputs);
  const std::vector<float> in_half = run(half, direction, inputs);
  double largest = 0.0;
  for (std::size_t i = 0; i < in_float.size(); ++i) {
    EXPECT_TRUE(std::isfinite(in_float[i])) << tested.function;
    double difference = std::fabs(double(in_float[i]) - double(in_half[i]));
    if (tested.quantity.turns) difference = std::min(difference, 1.0 - difference);
    largest =
        std::isfinite(in_half[i]) ? std::max(largest, difference) : std::numeric_limits<double>::infinity();
    if (!std::isfinite(largest)) break;
  }
  return largest;
}

nlohmann::json committed() {
  std::ifstream file(std::string(PENUMBRA_SOURCE_DIR) + "/tests/ShaderLibrary/half_precision.json");
  return nlohmann::json::parse(file);
}

class HalfPrecision : public testing::TestWithParam<HalfFunction> {};

TEST_P(HalfPrecision, DiffersFromFloatAsThePageSays) {
  if (!has_half_arithmetic()) GTEST_SKIP() << device_name() << " has no 16-bit arithmetic";
  const HalfFunction& tested = GetParam();
  double largest = 0.0;
  for (const DepthDirection direction : kDepthDirections)
    largest = std::max(largest, largest_difference(tested, direction));
  std::printf("half: %s | %s | %.6g | %.3g | %d cases, two directions of depth | %s\n",
              tested.function.c_str(), tested.quantity.unit, tested.quantity.accepted, largest, 2 * kCases,
              device_name().c_str());
  const nlohmann::json page = committed();
  const auto found =
      std::find_if(page["functions"].begin(), page["functions"].end(),
                   [&](const nlohmann::json& one) { return one["function"] == tested.function; });
  ASSERT_NE(found, page["functions"].end()) << "not on the page: scripts/pages --take half";
  const double then = (*found)["largest"].is_null() ? std::numeric_limits<double>::infinity()
                                                    : (*found)["largest"].get<double>();
  EXPECT_EQ(then <= tested.quantity.accepted, largest <= tested.quantity.accepted) << largest;
  if (page["device"] != device_name()) return;  // other devices round otherwise
  if (std::isfinite(then))
    EXPECT_NEAR(largest, then, 0.01 * then);
  else
    EXPECT_FALSE(std::isfinite(largest));
}

INSTANTIATE_TEST_SUITE_P(EveryFunction, HalfPrecision, testing::ValuesIn(half_functions()),
                         [](const auto& given) {
                           std::string name;
                           for (const char letter : given.param.function)
                             if (std::isalnum(static_cast<unsigned char>(letter)) != 0) name += letter;
                           return name;
                         });

}  // namespace
}  // namespace penumbra::shader_library_tests
