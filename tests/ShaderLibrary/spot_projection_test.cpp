// Compares what follows from a spot light's matrix with projections in long double: coordinates in its map,
// the map's slice and planes, and the slope of the receiver's plane.
#include <algorithm>
#include <array>
#include <numbers>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"
#include "ShaderLibrary/long_vectors.h"
#include "parameters/random_setup.h"
#include "parameters/spot_light.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr const char* kMap = "const SpotMap map = BoundedSpotMap(In4(0));";

// The inputs are the rows of the matrix and a position, for a light anywhere within a hundred metres.
std::vector<float> light_and_position(parameters::SetupGenerator& generator, DepthDirection direction,
                                      parameters::SpotShadow& map) {
  parameters::SpotLight light;
  light.inner_angle_degrees = 0.0;
  light.position = {generator.uniform(-99, 99), generator.uniform(-9, 9), generator.uniform(-99, 99)};
  light.direction = {generator.uniform(-1, 1), generator.uniform(-1, 1), generator.uniform(-1, 1) + 1e-3};
  light.outer_angle_degrees = generator.uniform(10, 120);
  light.range_metres = generator.uniform(3, 30);
  parameters::ShadowSettings settings;
  settings.reversed_z = direction == DepthDirection::reversed;
  map = parameters::spot_shadow(light, settings);
  std::vector<float> in;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) in.push_back(float(map.world_to_shadow[column][row]));
  const double reach = 1.2 * light.range_metres;
  for (int axis = 0; axis < 3; ++axis)
    in.push_back(float(light.position[axis] + generator.uniform(-reach, reach)));
  return in;
}

constexpr const char* kMatrix = "const float4x4 m = InMatrix(0);";

// The rows of the matrix times (p, 1), in long double; `terms` gets the sum of the terms' sizes.
std::array<Real, 4> project(const float* in, const Vector& p, Real* terms = nullptr) {
  std::array<Real, 4> result{};
  for (std::size_t row = 0; row < 4; ++row) {
    const float* m = in + 4 * row;
    result[row] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
    if (terms != nullptr)
      terms[row] = std::fabs(m[0] * p[0]) + std::fabs(m[1] * p[1]) + std::fabs(m[2] * p[2]) + std::fabs(m[3]);
  }
  return result;
}

TEST(SpotCoordinate, CoversWhatLiesInTheMapsPyramid) {
  for (const DepthDirection direction : kDepthDirections) {
    parameters::SetupGenerator generator(66);
    parameters::SpotShadow map;
    std::vector<float> inputs;
    for (int i = 0; i < kRandomCases; ++i) {
      const std::vector<float> in = light_and_position(generator, direction, map);
      inputs.insert(inputs.end(), in.begin(), in.end());
    }
    const std::vector<float> results =
        run({"SpotLight",
             std::string(kMatrix) +
                 "const SpotCoordinate c = ProjectOntoSpotMap(In3(16), m, float4(0, 0, 1, 1)); Out3(0, "
                 "c.shadowCoord.xyz); Out(3, c.axialMetres); Out(4, c.covered ? 1.0 : 0.0);",
             19, 5},
            direction, inputs);
    int covered = 0, behind = 0;
    for (std::size_t i = 0; i < std::size_t(kRandomCases); ++i) {
      const float* in = &inputs[i * 19];
      const float* out = &results[i * 5];
      Real terms[4];
      const auto p = project(in, {in[16], in[17], in[18]}, terms);
      for (int k = 0; k < 5; ++k) ASSERT_TRUE(std::isfinite(out[k]));
      if (p[3] < 0.0L) {
        ++behind;
        ASSERT_EQ(out[4], p[3] < -1e-3L ? 0.0f : out[4]);
        continue;
      }
      if (p[3] < 0.05L) continue;
      Real inside = 1.0L;  // distance to the pyramid's nearest side, negative outside
      for (std::size_t k = 0; k < 3; ++k) {
        const Real exact = p[k] / p[3];
        inside = std::min({inside, exact, 1.0L - exact});
        // Dot products round at the size of their terms, as w does.
        const Real error = 8.0L * ulp_at(terms[k]) / p[3] + std::fabs(exact) * 8.0L * ulp_at(terms[3]) / p[3];
        ASSERT_NEAR(double(out[k]), double(exact), double(error + 4.0L * ulp_at(exact))) << i << ", " << k;
      }
      if (std::fabs(inside) < 1e-3L) continue;
      ASSERT_EQ(out[4], inside > 0.0L ? 1.0f : 0.0f) << i << ": " << double(inside);
      covered += inside > 0.0L;
    }
    EXPECT_GT(covered, kRandomCases / 100);
    EXPECT_GT(behind, kRandomCases / 10);
  }
}

// A pipeline tells the matrix and the cone; the rest follows from them.
TEST(SpotMap, FollowsFromItsMatrixAndCone) {
  for (const DepthDirection direction : kDepthDirections) {
    parameters::SetupGenerator generator(69);
    std::vector<float> inputs;
    struct Truth {
      parameters::SpotShadow map;
      double corner[2], extent;
    };
    std::vector<Truth> truths;
    for (int i = 0; i < kRandomCases; ++i) {
      parameters::SpotLight light;
      light.inner_angle_degrees = 0.0;
      light.position = {generator.uniform(-30, 30), generator.uniform(-9, 9), generator.uniform(-30, 30)};
      light.direction = {generator.uniform(-1, 1), generator.uniform(-1, 1), generator.uniform(-1, 1) + 1e-3};
      light.outer_angle_degrees = generator.uniform(10, 120);
      light.shadow_guard_degrees = generator.uniform(0, 2);
      light.shadow_near_plane_metres = generator.uniform(0.1, 0.5);
      light.range_metres = generator.uniform(3, 20);
      parameters::ShadowSettings settings;
      settings.reversed_z = direction == DepthDirection::reversed;
      Truth truth{parameters::spot_shadow(light, settings), {}, std::exp2(-generator.integer(0, 4))};
      const int slices = int(1.0 / truth.extent);
      for (double& corner : truth.corner) corner = generator.integer(0, slices - 1) * truth.extent;
      for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
          const double own = truth.map.world_to_shadow[column][row], w = truth.map.world_to_shadow[column][3];
          inputs.push_back(float(row < 2 ? truth.extent * own + truth.corner[row] * w : own));
        }
      }
      inputs.push_back(float(std::tan(light.outer_angle_degrees * std::numbers::pi / 360)));
      inputs.push_back(std::exp2(float(generator.integer(9, 12))));
      truths.push_back(truth);
    }
    const std::vector<float> results = run(
        {"SpotLight",
         std::string(kMatrix) +
             "const float4 s = SliceOfSpotMap(m, In(16), float4(1.0 / In(17), 1.0 / In(17), In(17), "
             "In(17))); const SpotMap map = SpotMapOfMatrix(m, s, 0.25); Out4(0, s.xyzw); Out(4, "
             "map.nearMetres); Out(5, map.farMetres); Out(6, map.tanHalf); Out(7, map.sourceRadiusMetres);",
         18, 8},
        direction, inputs);
    for (std::size_t i = 0; i < truths.size(); ++i) {
      const float* out = &results[i * 8];
      const Truth& truth = truths[i];
      // The bound is a hundredth of a texel of the largest atlas, because filters round slices to texels.
      for (int axis = 0; axis < 2; ++axis) ASSERT_NEAR(out[axis], truth.corner[axis], 0.01 / 4096) << i;
      ASSERT_EQ(out[2], float(truth.extent)) << i;
      ASSERT_EQ(out[3], float(truth.extent)) << i;
      const double near = truth.map.light.shadow_near_plane_metres, far = truth.map.light.range_metres;
      // s is the difference of terms as large as the way from the origin to the light, and q that of terms
      // about 1.
      const double of_s = 4e-7 * 60.0 / near, of_q = 4e-7 * (far - near) / near;
      ASSERT_NEAR(out[4] / near, 1.0, of_s + of_q) << i;
      ASSERT_NEAR(out[5] / far, 1.0, of_s + of_q) << i;
      // There are eight roundings, and those of the matrix's own floats, up to about 1, of whose row the
      // light's part is this long.
      const double of_row = 5e-7 + 2e-7 / (truth.extent * truth.map.uv_per_tangent);
      ASSERT_NEAR(out[6] * 2.0 * truth.map.uv_per_tangent, 1.0, of_row) << i;
      ASSERT_EQ(out[7], 0.25F);
    }
  }
}

// A plane of the world is a plane in the map, through three of its points, projected.
TEST(SpotReceiverPlane, FromNormalIsTheSlopeOfTheProjectedPlane) {
  for (const DepthDirection direction : kDepthDirections) {
    parameters::SetupGenerator generator(67);
    std::vector<float> inputs;
    std::vector<Exact> exact;
    while (inputs.size() < 22 * std::size_t(kRandomCases)) {
      parameters::SpotShadow map;
      std::vector<float> in = light_and_position(generator, direction, map);
      const Vector p{in[16], in[17], in[18]};
      const auto at = project(in.data(), p);
      if (at[3] < 0.2L) continue;
      const Vector normal =
          unit({generator.uniform(-1, 1), generator.uniform(-1, 1), generator.uniform(-1, 1)});
      const Vector ray =
          unit(along(p, -1.0L, {map.light.position.x, map.light.position.y, map.light.position.z}));
      const Real sine = std::fabs(dot(normal, ray));
      if (sine < 0.02L ||
          ray[0] * map.light.direction.x + ray[1] * map.light.direction.y + ray[2] * map.light.direction.z <
              0.4L)
        continue;
      for (const Real n : normal) in.push_back(float(n));
      const Vector given = unit({in[19], in[20], in[21]});
      const Vector s = unit(cross(given, std::fabs(given[0]) < 0.6L ? Vector{1, 0, 0} : Vector{0, 1, 0}));
      const Vector t = cross(given, s);
      const auto mapped = [&](const Vector& q) {
        const auto projected = project(in.data(), q);
        return Vector{projected[0] / projected[3], projected[1] / projected[3], projected[2] / projected[3]};
      };
      const Real step = at[3] / 64.0L;
      const Vector origin = mapped(p), to_s = along(mapped(along(p, step, s)), -1.0L, origin),
                   to_t = along(mapped(along(p, step, t)), -1.0L, origin);
      const Real determinant = to_s[0] * to_t[1] - to_s[1] * to_t[0];
      const Real u = (to_s[2] * to_t[1] - to_s[1] * to_t[2]) / determinant;
      const Real v = (to_s[0] * to_t[2] - to_s[2] * to_t[0]) / determinant;
      if (std::max(std::fabs(u), std::fabs(v)) > 1000.0L) continue;
      // shadowCoord, given in float, is off by half an ULP at 1, and each row less coordinate times row 3 by
      // that much of a unit row. This is divided by |J0|, which is UV per metre times depth, and by the sine
      // twice.
      const Real scale = (1.0L + std::fabs(u) + std::fabs(v)) / (map.uv_per_tangent * sine * sine);
      exact.push_back({u, scale});
      exact.push_back({v, scale});
      inputs.insert(inputs.end(), in.begin(), in.end());
    }
    expect_exact(
        {"ReceiverPlane",
         std::string(kMatrix) + "const float4 c = mul(m, float4(In(16), In(17), In(18), 1.0)); Out2(0, "
                                "ReceiverPlaneInPerspective(In3(19), m, c.xyz / c.w));",
         22, 2},
        direction, inputs,
        [&](const float* in) {
          const std::size_t i = std::size_t(in - inputs.data()) / 22;
          // Far from the origin the device's own coordinate is off by more.
          Real terms[4];
          const auto at = project(in, {in[16], in[17], in[18]}, terms);
          const Real worse = 1.0L + (terms[0] + terms[1] + terms[2] + terms[3]) / at[3];
          return std::vector<Exact>{{exact[2 * i].value, exact[2 * i].scale * worse},
                                    {exact[2 * i + 1].value, exact[2 * i + 1].scale * worse}};
        },
        16.0L);
  }
}

TEST(SpotLight, EverythingIsFiniteForAnyInput) {
  for (const DepthDirection direction : kDepthDirections) {
    Random random(68);
    std::vector<float> inputs(22 * std::size_t(kRandomCases));
    const std::vector<float> special = special_floats();
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      inputs[i] = i % 5 == 0   ? random.any_bits()
                  : i % 7 == 0 ? special[i % special.size()]
                               : random.magnitude(-8.0f, 8.0f);
    }
    const std::vector<float> results =
        run({"SpotLight",
             std::string(kMap) + kMatrix +
                 "Out(0, map.nearMetres); Out(1, map.farMetres - map.nearMetres); Out(2, map.tanHalf); "
                 "Out(3, map.sourceRadiusMetres); const float depth = AxialDepth(FiniteOr(In(4), 0.5), map); "
                 "Out(4, depth); Out(5, StoredDepth(depth, map)); const float gap = min(max(FiniteOr(In(5), "
                 "0.0), 0.0), 1.0); Out(6, PenumbraRadiusMetres(gap, depth, map)); Out(7, "
                 "SearchRadiusMetres(depth, map)); Out(8, RadiusInTileUV(1.0, depth, map)); ShadowTile tile; "
                 "tile.offsetScale = float4(0, 0, 1, 1); tile.atlasTexelSize = float4(1, 1, 1, 1); tile = "
                 "TileAtReceiver(tile, map, depth); Out(9, tile.uvPerMetre); Out(10, tile.depthPerMetre); "
                 "Out(11, tile.depthToRadial); Out(12, tile.radialToDepth); const SpotCoordinate c = "
                 "ProjectOntoSpotMap(In3(16), m, float4(0, 0, 1, 1)); Out3(13, c.shadowCoord.xyz); Out(16, "
                 "c.axialMetres); const float2 away = AwayFromAxis(FiniteOr(In2(19), float2(0.0, 0.0)), "
                 "map); Out2(17, StretchAwayFromAxis(float2(1.0, 1.0), away));",
             22, 19},
            direction, inputs);
    for (std::size_t i = 0; i < results.size(); ++i)
      ASSERT_TRUE(std::isfinite(results[i])) << "output " << i % 19 << " of case " << i / 19;
    for (std::size_t i = 0; i < results.size(); i += 19) {
      ASSERT_GT(results[i], 0.0f);
      ASSERT_GT(results[i + 1], 0.0f);
      ASSERT_GE(results[i + 5], 0.0f);
      ASSERT_LE(results[i + 5], 1.0f);
      ASSERT_LE(std::fabs(results[i + 17]), 20.0f);
    }
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
