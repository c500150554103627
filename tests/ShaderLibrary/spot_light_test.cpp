// Compares Core/SpotLight.hlsl's depths, penumbrae and its source's image with similar triangles in long
// double and with parameters/spot_light.h.
#include "parameters/spot_light.h"

#include <algorithm>
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"
#include "ShaderLibrary/long_vectors.h"
#include "parameters/random_setup.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr const char* kMap = "const SpotMap map = BoundedSpotMap(In4(0));";
constexpr int kMapWords = 4;

// A map has near plane, far plane, tan of half the angle, and source radius.
void append_map(std::vector<float>& inputs, Random& random) {
  const float near = std::pow(10.0f, random.between(-2.0f, 0.0f));
  const float far = near * std::pow(10.0f, random.between(0.31f, 2.5f));
  inputs.insert(inputs.end(), {near, far, std::tan(random.between(0.05f, 1.2f)), random.between(0.0f, 1.0f)});
}

float between_planes(const std::vector<float>& inputs, Random& random) {
  const float near = inputs[inputs.size() - kMapWords], far = inputs[inputs.size() - kMapWords + 1];
  return near * std::pow(far / near, random.between(0.0f, 1.0f));
}

Real depth_range(const float* in) {  // 1 / metres per unit of stored depth
  return 1.0L / in[0] - 1.0L / in[1];
}

Real above_far(Real stored, DepthDirection direction) {
  return direction == DepthDirection::reversed ? stored : 1.0L - stored;
}

Real axial(const float* in, Real stored, DepthDirection direction) {
  return 1.0L / (1.0L / in[1] + above_far(stored, direction) * depth_range(in));
}

// A depth has a difference, two products, a sum and a division (2.5 ULP in Vulkan); conventional depth has
// one more difference.
TEST(SpotDepth, StoredDepthBecomesMetresAndComesBack) {
  for (const DepthDirection direction : kDepthDirections) {
    Random random(61);
    std::vector<float> inputs;
    for (int i = 0; i < kRandomCases; ++i) {
      append_map(inputs, random);
      const float metres = between_planes(inputs, random);
      inputs.insert(inputs.end(), {random.between(0.0f, 1.0f), metres});
    }
    expect_exact(
        {"SpotLight", std::string(kMap) + "Out(0, AxialDepth(In(4), map)); Out(1, StoredDepth(In(5), map));",
         kMapWords + 2, 2},
        direction, inputs,
        [=](const float* in) {
          const Real metres = std::clamp(Real(in[5]), Real(in[0]), Real(in[1]));
          const Real above = (1.0L / metres - 1.0L / in[1]) / depth_range(in);
          const bool reversed = direction == DepthDirection::reversed;
          return std::vector<Exact>{{axial(in, in[4], direction)},
                                    {reversed ? above : 1.0L - above, reversed ? 0.0L : 1.0L}};
        },
        8.0L);
  }
}

// The lines lead from both ends of the source over an edge at d_b, to the receiver's plane at d_r.
Real penumbra_by_lines(Real radius, Real receiver, Real blocker) {
  const auto over_edge = [&](Real from) { return from + (0.0L - from) * receiver / blocker; };
  return std::fabs(over_edge(radius) - over_edge(-radius)) / 2.0L;
}

TEST(SpotPenumbra, FollowsSimilarTriangles) {
  Random random(62);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    append_map(inputs, random);
    const float receiver = between_planes(inputs, random);
    const float* in = &inputs[inputs.size() - kMapWords];
    const Real largest = (1.0L / in[0] - 1.0L / receiver) / depth_range(in);
    const float gap = static_cast<float>(largest) * random.between(1e-4f, 1.0f);
    inputs.insert(inputs.end(), {receiver, gap});
  }
  const auto exact = [](const float* in) {
    const Real receiver = in[4];
    const Real blocker = 1.0L / (1.0L / receiver + in[5] * depth_range(in));
    const Real radius = penumbra_by_lines(in[3], receiver, blocker);
    // The nearest blocker's penumbra is the source seen over an edge on the near plane.
    const Real search = penumbra_by_lines(in[3], receiver, std::min<Real>(in[0], receiver));
    const Real map_width = 2.0L * in[2] * receiver;  // width at the receiver, metres
    return std::vector<Exact>{{radius}, {search}, {radius / map_width}, {radius / map_width}};
  };
  // There are at most nine roundings and two divisions in a row.
  expect_exact({"SpotLight",
                std::string(kMap) +
                    "Out(0, PenumbraRadiusMetres(In(5), In(4), map)); Out(1, SearchRadiusMetres(In(4), "
                    "map)); Out(2, RadiusInTileUV(PenumbraRadiusMetres(In(5), In(4), map), In(4), map)); "
                    "ShadowTile tile; tile.offsetScale = float4(0, 0, 1, 1); tile.atlasTexelSize = float4(1, "
                    "1, 1, 1); Out(3, In(5) * TileAtReceiver(tile, map, In(4)).depthToRadial);",
                kMapWords + 2, 4},
               inputs, exact, 12.0L);
}

TEST(SpotPenumbra, TheTilesScalesAreTheSlopesAtTheReceiver) {
  Random random(63);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    append_map(inputs, random);
    inputs.back() = std::max(inputs.back(), 1e-4f);
    const float receiver = between_planes(inputs, random);
    inputs.push_back(std::max(receiver, inputs[inputs.size() - kMapWords]));
  }
  expect_exact(
      {"SpotLight",
       std::string(kMap) +
           "ShadowTile tile; tile.offsetScale = float4(0, 0, 1, 1); tile.atlasTexelSize = float4(1, 1, 1, "
           "1); tile = TileAtReceiver(tile, map, In(4)); Out(0, tile.uvPerMetre); Out(1, "
           "tile.depthPerMetre); Out(2, tile.radialToDepth); Out(3, InverseMetresPerDepth(map));",
       kMapWords + 1, 4},
      inputs,
      [](const float* in) {
        const Real receiver = in[4];
        return std::vector<Exact>{{1.0L / (2.0L * in[2] * receiver)},
                                  {1.0L / (depth_range(in) * receiver * receiver)},
                                  {2.0L * in[2] / (in[3] * depth_range(in))},
                                  {depth_range(in)}};
      },
      10.0L);
}

// The library's own light gives, in double, what its map stores and the radius of its penumbra.
TEST(SpotPenumbra, IsThatOfTheLightsOwnMap) {
  for (const DepthDirection direction : kDepthDirections) {
    parameters::SetupGenerator generator(64);
    std::vector<float> inputs;
    std::vector<parameters::SpotShadow> maps;
    for (int i = 0; i < kRandomCases; ++i) {
      parameters::SpotLight light;
      light.inner_angle_degrees = 0.0;
      light.outer_angle_degrees = generator.uniform(5, 120);
      light.source_radius_metres = generator.uniform(0.01, 0.3);
      light.shadow_near_plane_metres = float(generator.uniform(0.05, 0.5));
      light.range_metres = float(generator.uniform(2, 40));
      parameters::ShadowSettings settings;
      settings.reversed_z = direction == DepthDirection::reversed;
      maps.push_back(parameters::spot_shadow(light, settings));
      const double receiver = generator.uniform(2 * light.shadow_near_plane_metres, light.range_metres);
      const double blocker = generator.uniform(light.shadow_near_plane_metres, 0.95 * receiver);
      inputs.insert(inputs.end(),
                    {float(light.shadow_near_plane_metres), float(light.range_metres),
                     float(0.5 / maps.back().uv_per_tangent), float(light.source_radius_metres),
                     float(maps.back().stored_depth(receiver)), float(maps.back().stored_depth(blocker))});
    }
    const auto exact = [&](const float* in) {
      const parameters::SpotShadow& map = maps[std::size_t(in - inputs.data()) / (kMapWords + 2)];
      const double receiver = map.axial_depth(in[4]), blocker = map.axial_depth(in[5]);
      return std::vector<Exact>{{parameters::penumbra_radius_metres(map.light, receiver, blocker)},
                                {std::fabs(Real(in[4]) - in[5]) * map.depth_to_radial}};
    };
    expect_exact({"SpotLight",
                  std::string(kMap) + "const float gap = DepthGap(In(5), In(4)); const float radius = "
                                      "PenumbraRadiusMetres(gap, AxialDepth(In(4), map), map); Out(0, "
                                      "radius); Out(1, RadiusInTileUV(radius, AxialDepth(In(4), map), map));",
                  kMapWords + 2, 2},
                 direction, inputs, exact, 24.0L);
  }
}

// A source that faces the receiver is drawn point by point: lines from the receiver to points of its circle
// meet the plane of a blocker's depth, and the map has what they meet where it lies from the light.
TEST(SpotSource, LooksLikeAnEllipseAwayFromTheAxis) {
  constexpr Real kRadius = 1e-4L;  // metres: the ellipse is exact to first order in it
  Random random(65);
  std::vector<float> inputs;
  const auto tan_limit = 9.9f;  // cosine 0.1
  for (int i = 0; i < kRandomCases; ++i) {
    const float tan_half = std::tan(random.between(0.05f, 1.4f));
    inputs.insert(inputs.end(),
                  {0.1f, 10.0f, std::min(tan_half, tan_limit / 1.42f), 0.0f, random.between(0.0f, 1.0f),
                   random.between(0.0f, 1.0f), random.between(0.0f, 6.2831f)});
  }
  const std::vector<float> results =
      run({"SpotLight",
           std::string(kMap) +
               "const float2 away = AwayFromAxis(In2(4), map); const float2 circle = float2(cos(In(6)), "
               "sin(In(6))); const float2 ellipse = StretchAwayFromAxis(circle, away); Out2(0, ellipse.xy); "
               "const float4 back = SquaredRadiusFacingLight(ellipse.x, ellipse.y, away); Out(2, back.x); "
               "Out(3, AxisCosine(away));",
           kMapWords + 3, 4},
          inputs);
  for (int i = 0; i < kRandomCases; ++i) {
    const float* in = &inputs[std::size_t(i) * (kMapWords + 3)];
    const Real receiver_depth = 2.0L, blocker_depth = 1.0L;
    const Vector receiver{(in[4] - 0.5L) * 2.0L * in[2] * receiver_depth,
                          (in[5] - 0.5L) * 2.0L * in[2] * receiver_depth, receiver_depth};
    // The axes of the source's disc lie across the way to the receiver, the first also across the light's
    // axis.
    const Vector way = unit(receiver);
    Vector across = cross({0, 0, 1}, way);
    if (dot(across, across) < 1e-12L) continue;
    across = unit(across);
    // The second axis lies in the plane of the light's axis and the receiver.
    const Vector outward = cross(across, way);
    const Real cosine = way[2];
    // The point of the circle whose image the shader's point at this angle is: its part away from the axis is
    // the image's outward one. Both signs of `outward` appear in the random angles.
    const Vector radial_in_map = unit({receiver[0], receiver[1], 0});
    const Vector tangent_in_map = unit({across[0], across[1], 0});
    const Real cos_angle = std::cos(Real(in[6])), sin_angle = std::sin(Real(in[6]));
    const Real radial = cos_angle * radial_in_map[0] + sin_angle * radial_in_map[1];
    const Real tangential = cos_angle * tangent_in_map[0] + sin_angle * tangent_in_map[1];
    const Real side = dot(outward, radial_in_map) > 0 ? 1.0L : -1.0L;
    const Vector source =
        along(along({0, 0, 0}, kRadius * radial * side, outward), kRadius * tangential, across);
    // The line from the receiver to that point crosses the blocker's depth here.
    const Real share = (receiver_depth - blocker_depth) / (receiver_depth - source[2]);
    const Vector met = along(receiver, share, along(source, -1.0L, receiver));
    const Real scale = kRadius * (1.0L / blocker_depth - 1.0L / receiver_depth);
    const Real x = (met[0] / met[2] - receiver[0] / receiver_depth) / scale;
    const Real y = (met[1] / met[2] - receiver[1] / receiver_depth) / scale;
    const float* out = &results[std::size_t(i) * 4];
    ASSERT_NEAR(double(out[3]), double(cosine), 2e-5) << i;
    const double tolerance = 2e-3 / double(cosine);
    ASSERT_NEAR(double(out[0]), double(x), tolerance) << i << ": cosine " << double(cosine);
    ASSERT_NEAR(double(out[1]), double(y), tolerance) << i << ": cosine " << double(cosine);
    ASSERT_NEAR(double(out[2]), 1.0, 1e-5 / double(cosine * cosine)) << i;
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
