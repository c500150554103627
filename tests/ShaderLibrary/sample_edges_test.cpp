// Screen/SampleEdges.hlsl: where samples lie, and which of them see different surfaces.
#include <gmock/gmock.h>

#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// The tables are those of the Direct3D 11.3 functional specification, 19.2.4, in 16ths of a pixel.
TEST(SampleEdges, SamplesLieWhereDirect3DHasThem) {
  const std::vector<std::vector<float>> patterns{
      {4, 4, -4, -4}, {-2, -6, 6, -2, -6, 2, 2, 6}, {1, -3, -1, 3, 5, 1, -3, -5, -5, 5, -7, -1, 3, 7, 7, -7}};
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const int samples = 2 << i;
    std::vector<float> inputs;
    for (int index = 0; index < samples; ++index) inputs.push_back(static_cast<float>(index));
    const std::vector<float> results = run(
        {"SampleEdges",
         "const float2 at = 16.0 * SampleOffset(" + std::to_string(samples) + ", InInt(0)); Out2(0, at.xy);",
         1,
         2,
         {},
         "Screen"},
        inputs);
    EXPECT_EQ(results, patterns[i]) << samples;
  }
}

// The inputs are, for each of two samples, position, normal and whether it is seen; the first is 10 m away,
// where a pixel is 2 cm wide.
std::vector<float> differ(const std::vector<float>& inputs) {
  return run({"SampleEdges",
              "EdgeParameters p; p.edgeSamples = 4; p.depthTolerance = 1.0; p.normalCosine = 0.9; "
              "SampleSurface a; a.positionWS = In3(0); a.normalWS = In3(3); a.seen = In(6) > 0.5; "
              "a.metresPerPixel = 0.02; SampleSurface b; b.positionWS = In3(7); b.normalWS = In3(10); b.seen "
              "= In(13) > 0.5; b.metresPerPixel = 0.03; Out(0, SurfacesDiffer(a, b, p) ? 1.0 : 0.0); Out(1, "
              "SurfacesDiffer(b, a, p) ? 1.0 : 0.0);",
              14,
              2,
              {},
              "Screen"},
             inputs);
}

TEST(SampleEdges, SurfacesDifferByWhatIsSeenByDistanceAndByNormal) {
  const float nan = std::nanf("");
  const float tilted[2] = {std::sin(0.4F), std::cos(0.4F)};  // 23 degrees: cosine .92
  const float steep[2] = {std::sin(0.5F), std::cos(0.5F)};   // 29 degrees: cosine .88
  const std::vector<std::pair<std::vector<float>, float>> cases{
      {{0, 0, 10, 0, 1, 0, 1, 5, 0.019F, 10, 0, 1, 0, 1}, 0},  // one plane, to a footprint
      {{0, 0, 10, 0, 1, 0, 1, 5, 0.021F, 10, 0, 1, 0, 1}, 1},
      {{0, 0, 10, 0, 1, 0, 1, 0, 0, 10, tilted[0], tilted[1], 0, 1}, 0},
      {{0, 0, 10, 0, 1, 0, 1, 0, 0, 10, steep[0], steep[1], 0, 1}, 1},
      {{0, 0, 10, 0, 1, 0, 1, 0, 0, 10, 0, -1, 0, 1}, 1},   // a back face
      {{0, 0, 10, 0, 1, 0, 1, 0, 0, 10, 0, 1, 0, 0}, 1},    // beside the sky
      {{0, 0, 10, 0, 1, 0, 0, 9, 9, 9, 1, 0, 0, 0}, 0},     // both in it
      {{0, 0, 10, 0, 1, 0, 1, 0, nan, 10, 0, 1, 0, 1}, 1},  // nothing is known: shade each
      {{0, 0, 10, 0, 1, 0, 1, 0, 0, 10, nan, 1, 0, 1}, 1}};
  std::vector<float> inputs;
  for (const auto& [input, expected] : cases) inputs.insert(inputs.end(), input.begin(), input.end());
  const std::vector<float> results = differ(inputs);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(results[2 * i], cases[i].second) << i;
    EXPECT_EQ(results[2 * i + 1], cases[i].second) << i << ", the other way round";
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
