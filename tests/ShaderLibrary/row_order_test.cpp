// Core/RowOrder.hlsl: every place of grids of every width from 1 to 64, and of one as wide as a map.
#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

TEST(RowOrder, CountsAlongRows) {
  std::vector<float> inputs;
  const auto add = [&](int index, int width) {
    inputs.push_back(float(index));
    inputs.push_back(float(width));
  };
  while (inputs.size() < 2 * std::size_t(kRandomCases)) {
    for (int width = 1; width <= 64; ++width)
      for (int index = 0; index < width * width; ++index) add(index, width);
    for (int index = 0; index < 1 << 24; index += 4095) add(index, 16384);
  }
  expect_exact(
      {"RowOrder", "int2 p = PlaceInRows(int(In(0)), int(In(1))); Out(0, float(p.x)); Out(1, float(p.y));", 2,
       2},
      inputs,
      [](const float* in) {
        const int index = int(in[0]);
        const int width = int(in[1]);
        return std::vector<Exact>{{static_cast<long double>(index - index / width * width)},
                                  {static_cast<long double>(index / width)}};
      },
      0.0L);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
