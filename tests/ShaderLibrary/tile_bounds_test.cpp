// Core/TileBounds.hlsl: no fetch placed by these functions can read a texel outside the tile.
#include <algorithm>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr const char* kTile =
    "ShadowTile tile; tile.offsetScale = In4(0); tile.atlasTexelSize = float4(1.0 / In(4), 1.0 / In(5), "
    "In(4), In(5)); tile.uvPerMetre = 0.0; tile.depthPerMetre = 0.0; tile.depthToRadial = 0.0; "
    "tile.radialToDepth = 0.0; const TileBounds bounds = BoundsInTexels(tile);";

// A tile of URP's atlases: the number of cascades, the size of the atlas, and which tile it is.
struct Tile {
  float x, y, width, height;  // atlas UV
  float atlas_width, atlas_height;
};

Tile random_tile(Random& random) {
  const int cascades = random.integer(1, 4);
  const int tile = random.integer(0, cascades - 1);
  const float width = std::exp2(float(random.integer(6, 13)));
  const float extent_x = cascades > 1 ? 0.5f : 1.0f;
  const float extent_y = cascades > 2 ? 0.5f : 1.0f;
  return {float(tile % 2) * extent_x,          (tile >= 2 ? extent_y : 0.0f), extent_x, extent_y, width,
          cascades == 2 ? width / 2.0f : width};
}

// The inputs are a tile, then a coordinate: inside, on the edges, outside, or no number at all.
std::vector<float> tiles_and_coordinates(bool in_texels) {
  Random random(6);
  const std::vector<float> specials = special_floats();
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    const Tile tile = random_tile(random);
    float u = tile.x + tile.width * random.between(-0.25f, 1.25f);
    float v = tile.y + tile.height * random.between(-0.25f, 1.25f);
    if (i % 4 == 1) u = tile.x + tile.width * float(random.integer(0, 1));
    if (i % 4 == 2) v = std::nextafter(tile.y + tile.height, float(random.integer(0, 2)));
    if (i % 4 == 3) u = specials[std::size_t(random.integer(0, int(specials.size()) - 1))];
    inputs.insert(inputs.end(),
                  {tile.x, tile.y, tile.width, tile.height, tile.atlas_width, tile.atlas_height,
                   in_texels ? u * tile.atlas_width : u, in_texels ? v * tile.atlas_height : v});
  }
  return inputs;
}

struct Bounds {
  float low[2];
  float high[2];
};

Bounds bounds_of(const float* in) {
  return {{in[0] * in[4], in[1] * in[5]}, {(in[0] + in[2]) * in[4], (in[1] + in[3]) * in[5]}};
}

TEST(TileBounds, AreTheTilesWholeTexels) {
  expect_exact(
      {"TileBounds", std::string(kTile) + "Out2(0, bounds.minimum.xy); Out2(2, bounds.maximum.xy);", 8, 4},
      tiles_and_coordinates(false),
      [](const float* in) {
        const Bounds b = bounds_of(in);
        return std::vector<Exact>{{b.low[0]}, {b.low[1]}, {b.high[0]}, {b.high[1]}};
      },
      0.0L);
}

// The coordinate is one product, exact for sizes that are powers of two.
TEST(TileBounds, TexelCoordinatesStayInTheTile) {
  expect_exact(
      {"TileBounds", std::string(kTile) + "Out2(0, TexelCoordinates(In2(6), tile));", 8, 2},
      tiles_and_coordinates(false),
      [](const float* in) {
        const Bounds b = bounds_of(in);
        std::vector<Exact> exact(2);
        for (std::size_t k = 0; k < 2; ++k) {
          const float texel = in[6 + k] * in[4 + k];  // overflows as the shader's does
          exact[k].value = std::isfinite(texel) ? std::clamp(texel, b.low[k], b.high[k]) : b.low[k];
        }
        return exact;
      },
      0.5L);
}

// Devices round texel coordinates to 1/256; the footprint around any such rounding lies in the tile.
TEST(TileBounds, BilinearFootprintsStayInTheTileHoweverTheDeviceRounds) {
  const std::vector<float> inputs = tiles_and_coordinates(true);
  const std::vector<float> results =
      run({"TileBounds", std::string(kTile) + "Out2(0, ClampFootprint(In2(6), bounds));", 8, 2}, inputs);
  for (std::size_t i = 0; i < inputs.size() / 8; ++i) {
    const float* in = &inputs[8 * i];
    const Bounds b = bounds_of(in);
    for (std::size_t k = 0; k < 2; ++k) {
      const float placed = results[2 * i + k];
      ASSERT_GE(placed - 0.5f - 1.0f / 256.0f, b.low[k]) << words(in, 8);
      ASSERT_LE(placed + 0.5f + 1.0f / 256.0f, b.high[k]) << words(in, 8);
      const float asked = in[6 + k];
      if (asked >= b.low[k] + 0.52f && asked <= b.high[k] - 0.52f) {
        ASSERT_EQ(placed, asked) << words(in, 8);
      }
    }
  }
}

TEST(TileBounds, QuadCornersAreTheNearestWithFourTexelsInTheTile) {
  const std::vector<float> inputs = tiles_and_coordinates(true);
  const std::vector<float> results =
      run({"TileBounds", std::string(kTile) + "Out2(0, ClampQuadCorner(In2(6), bounds));", 8, 2}, inputs);
  for (std::size_t i = 0; i < inputs.size() / 8; ++i) {
    const float* in = &inputs[8 * i];
    const Bounds b = bounds_of(in);
    for (std::size_t k = 0; k < 2; ++k) {
      const float corner = results[2 * i + k];
      ASSERT_EQ(corner, std::floor(corner)) << words(in, 8);
      ASSERT_GE(corner - 1.0f, b.low[k]) << words(in, 8);
      ASSERT_LE(corner + 1.0f, b.high[k]) << words(in, 8);
      if (std::isfinite(in[6 + k])) {
        const float nearest = std::clamp(in[6 + k], b.low[k] + 1.0f, b.high[k] - 1.0f);
        ASSERT_LE(std::fabs(corner - nearest), 0.5f) << words(in, 8);
      }
    }
  }
}

TEST(TileBounds, AreFiniteForTilesThatAreNoNumbers) {
  Random random(7);
  std::vector<float> inputs(8 * std::size_t(kRandomCases));
  for (float& value : inputs) value = random.any_bits();
  const std::vector<float> results =
      run({"TileBounds",
           std::string(kTile) + "const float2 p = In2(6); const float2 a = TexelCoordinates(p, tile); const "
                                "float2 b = ClampFootprint(p, bounds); const float2 c = ClampQuadCorner(p, "
                                "bounds); Out2(0, a.xy); Out2(2, b.xy); Out2(4, c.xy);",
           8, 6},
          inputs);
  for (const float result : results) ASSERT_TRUE(std::isfinite(result));
}

}  // namespace
}  // namespace penumbra::shader_library_tests
