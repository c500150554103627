// Tests Core/ScreenScale.hlsl on every screen from 1 to 400 pixels wide, halved.

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

#include <gtest/gtest.h>

namespace penumbra::shader_library_tests {
namespace {

TEST(ScreenScale, IsTheQuotientOfSizesRoundedUp) {
  std::vector<float> inputs;
  std::vector<int> scales;
  for (int full = 2; full <= 8192; full += full < 400 ? 1 : 97) {
    for (const int scale : {1, 2}) {
      inputs.insert(inputs.end(), {float(full), float((full + scale - 1) / scale)});
      scales.push_back(scale);
    }
  }
  const std::vector<float> results =
      run({"ScreenScale", "OutInt(0, ScreenScale(In(0), In(1)));", 2, 1}, inputs);
  for (std::size_t i = 0; i < scales.size(); ++i) ASSERT_EQ(results[i], float(scales[i])) << inputs[2 * i];
}

// A half pixel stands for a pixel inside its own 2 x 2 block where there is one, and the two around a full
// pixel are the nearest before and after it.
TEST(ScreenScale, HalfPixelsEncloseTheFullOne) {
  std::vector<float> inputs;
  for (int size = 1; size <= 400; ++size) {
    for (int pixel = 0; pixel < size; ++pixel) inputs.insert(inputs.end(), {float(size), float(pixel)});
  }
  const std::vector<float> results = run(
      {"ScreenScale",
       "const int2 size = int2(InInt(0), InInt(0)); const int before = HalfPixelBefore(InInt(1)); OutInt(0, "
       "before); OutInt(1, FullPixel(int2(before, before), 2, size).x); OutInt(2, FullPixel(int2(before + 1, "
       "before + 1), 2, size).y); OutInt(3, FullPixel(int2(InInt(1), InInt(1)), 1, size).x);",
       2, 4},
      inputs);
  for (std::size_t i = 0; i < inputs.size() / 2; ++i) {
    const int size = int(inputs[2 * i]);
    const int pixel = int(inputs[2 * i + 1]);
    const float* got = &results[4 * i];
    ASSERT_EQ(got[0], std::floor((pixel - 1) / 2.0)) << pixel;
    ASSERT_LE(got[1], float(pixel));
    ASSERT_GE(got[1], float(pixel - 1) - (pixel == 0 ? 1.0f : 0.0f));
    ASSERT_GT(got[2], float(pixel) - (pixel == size - 1 ? 1.0f : 0.0f));
    ASSERT_LT(got[2], float(size));
    ASSERT_EQ(got[3], float(pixel));
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
