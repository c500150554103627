#include <array>

#include "gpu/gpu_test.h"

namespace penumbra::gpu {
namespace {

using Point = std::array<float, 4>;  // u, v, reference depth, unused

class GpuSampler : public Gpu {
 protected:
  template <typename Result>
  std::vector<Result> run(const std::string& shader, const std::string& sampler_name, const Image& map,
                          SamplerKind kind, const std::vector<Point>& points) {
    return run<Result>(shader, sampler_name, map, Sampler(*device, kind), points);
  }
  template <typename Result>
  std::vector<Result> run(const std::string& shader, const std::string& sampler_name, const Image& map,
                          const Sampler& sampler, const std::vector<Point>& points) {
    const std::vector<std::uint32_t> spirv = compile_test_shader(shader);
    ComputePass pass(*device, {.spirv = spirv});
    const Buffer where(*device, std::span<const Point>(points));
    const Buffer result(*device, points.size() * sizeof(Result));
    pass.bindings().image("_Map", map);
    pass.bindings().sampler(sampler_name, sampler);
    pass.bindings().buffer("_Points", where);
    pass.bindings().buffer("_Result", result);
    pass.dispatch({std::uint32_t(points.size()), 1, 1});
    return result.download<Result>();
  }
  std::vector<float> compare(const Image& map, SamplerKind kind, const std::vector<Point>& points) {
    return run<float>("Compare.hlsl", "_Compare", map, kind, points);
  }
};

// The four are at texel centres of a 2 x 2 map, where the bilinear footprint is one texel:
//   0.25 0.75      row 0 is v = 0
//   0.50 0.50
const std::vector<float> kFourDepths{0.25F, 0.75F, 0.5F, 0.5F};
constexpr float kNear = 0.25F;  // UV of the first texel's centre
constexpr float kFar = 0.75F;

TEST_F(GpuSampler, LessEqualIsLitInFrontOfAndOnTheTexel) {
  Image map(*device, Format::depth32, 2, 2);
  map.upload(kFourDepths);
  EXPECT_EQ(compare(map, SamplerKind::compare_less_equal,
                    {{kNear, kNear, 0.2F},
                     {kNear, kNear, 0.25F},
                     {kNear, kNear, 0.3F},
                     {kFar, kNear, 0.7F},
                     {kFar, kNear, 0.75F},
                     {kFar, kNear, 0.8F},
                     {kNear, kFar, 0.5F},
                     {kNear, kFar, 0.50001F}}),
            (std::vector<float>{1, 1, 0, 1, 1, 0, 1, 0}));
}

// The samples lie in columns 0, 1, 2 and 3, right of the picture and left of it, where each way to go on
// differs.
TEST_F(GpuSampler, WrapsEachAxisInItsOwnWay) {
  Image map(*device, Format::r32f, 4, 4);
  std::vector<float> texels;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) texels.push_back(static_cast<float>(10 * row + column));
  map.upload(texels);
  const std::vector<Point> points{{1.125F, 0.125F}, {-0.375F, 0.125F}, {0.125F, 1.375F}};
  const auto read = [&](SamplerWrap u, SamplerWrap v) {
    std::vector<float> values;
    for (const Point& texel : run<Point>("Sample.hlsl", "_Sampler", map, Sampler(*device, u, v), points))
      values.push_back(texel[0]);
    return values;
  };
  EXPECT_EQ(read(SamplerWrap::repeat, SamplerWrap::mirror), (std::vector<float>{0, 2, 20}));
  EXPECT_EQ(read(SamplerWrap::mirror, SamplerWrap::clamp), (std::vector<float>{3, 1, 30}));
  EXPECT_EQ(read(SamplerWrap::clamp, SamplerWrap::repeat), (std::vector<float>{3, 0, 10}));
}

TEST_F(GpuSampler, UnormDepthsCompareAsTheirFractions) {
  Image depth16(*device, Format::depth16, 1, 1);
  depth16.upload(std::vector<std::uint16_t>{32768});
  Image depth24(*device, Format::depth24, 1, 1);
  depth24.upload(std::vector<std::uint32_t>{0x80'0000});
  const float half16 = 32768.0F / 65535.0F;
  const float half24 = 8388608.0F / 16777215.0F;
  EXPECT_EQ(compare(depth16, SamplerKind::compare_less_equal,
                    {{0.5F, 0.5F, half16 - 1e-5F}, {0.5F, 0.5F, half16 + 1e-5F}}),
            (std::vector<float>{1, 0}));
  EXPECT_EQ(compare(depth24, SamplerKind::compare_greater_equal,
                    {{0.5F, 0.5F, half24 - 3e-7F}, {0.5F, 0.5F, half24 + 3e-7F}}),
            (std::vector<float>{0, 1}));
}

TEST_F(GpuSampler, GreaterEqualIsLitInFrontOfAndOnTheTexelWithReversedDepth) {
  Image map(*device, Format::depth32, 2, 2);
  map.upload(kFourDepths);
  EXPECT_EQ(compare(map, SamplerKind::compare_greater_equal,
                    {{kNear, kNear, 0.2F},
                     {kNear, kNear, 0.25F},
                     {kNear, kNear, 0.3F},
                     {kFar, kNear, 0.7F},
                     {kFar, kNear, 0.75F},
                     {kFar, kNear, 0.8F},
                     {kNear, kFar, 0.5F},
                     {kNear, kFar, 0.49999F}}),
            (std::vector<float>{0, 1, 1, 0, 1, 1, 1, 0}));
}

TEST_F(GpuSampler, CompareFiltersResultsNotDepths) {
  Image map(*device, Format::depth32, 2, 2);
  map.upload(std::vector<float>{0.0F, 1.0F, 0.0F, 1.0F});
  // The averaged depth would be 0.5 at the centre and answer 0 or 1; averaged answers are the lit share.
  const std::vector<float> lit =
      compare(map, SamplerKind::compare_less_equal,
              {{0.5F, 0.5F, 0.4F}, {0.5F, 0.5F, 0.6F}, {0.375F, 0.5F, 0.5F}, {0.625F, 0.25F, 0.5F}});
  const float weight_step = 1.0F / 256.0F;  // devices round bilinear weights to 1/256
  EXPECT_NEAR(lit[0], 0.5F, weight_step);
  EXPECT_NEAR(lit[1], 0.5F, weight_step);
  EXPECT_NEAR(lit[2], 0.25F, weight_step);
  EXPECT_NEAR(lit[3], 0.75F, weight_step);
}

TEST_F(GpuSampler, CompareClampsToTheEdge) {
  Image map(*device, Format::depth32, 2, 2);
  map.upload(kFourDepths);
  EXPECT_EQ(compare(map, SamplerKind::compare_less_equal,
                    {{-3.0F, -3.0F, 0.25F}, {-3.0F, -3.0F, 0.26F}, {4.0F, -1.0F, 0.75F}, {4.0F, 4.0F, 0.6F}}),
            (std::vector<float>{1, 0, 1, 0}));
}

TEST_F(GpuSampler, PointTakesTheTexelAndLinearBlends) {
  Image map(*device, Format::rgba32f, 2, 1);
  map.upload(std::vector<float>{0, 1, 2, 3, 8, 9, 10, 11});
  const std::vector<Point> points{{0.49F, 0.5F}, {0.51F, 0.5F}, {0.5F, 0.5F}, {9.0F, 0.5F}};
  const auto point = run<Point>("Sample.hlsl", "_Sampler", map, SamplerKind::point_clamp, points);
  EXPECT_EQ(point[0], (Point{0, 1, 2, 3}));
  EXPECT_EQ(point[1], (Point{8, 9, 10, 11}));
  EXPECT_EQ(point[3], (Point{8, 9, 10, 11}));
  const auto linear = run<Point>("Sample.hlsl", "_Sampler", map, SamplerKind::linear_clamp, points);
  EXPECT_NEAR(linear[2][0], 4.0F, 8.0F / 256.0F);
  EXPECT_EQ(linear[3], (Point{8, 9, 10, 11}));
}

}  // namespace
}  // namespace penumbra::gpu
