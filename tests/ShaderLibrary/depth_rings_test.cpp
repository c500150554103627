// Filters/Cells/CellRings.hlsl and Filters/Cells/CellSums.hlsl: shares of rings, blockers of texels and of
// cells, the ground and the sums, against long double; cells of a known distribution; every cell of a tile is
// visited once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

using Exact = long double;

const std::string kRingReceiver =
    "QuadReceiver r; r.bounds.minimum = float2(0.0, 0.0); r.bounds.maximum = float2(4096.0, 4096.0); "
    "r.texelSize = 1.0; r.centre = float2(0.0, 0.0); r.inPerspective = false; r.awayFromAxis = float2(0.0, "
    "0.0); ";
// The sums and the ground need these three of the scales.
std::string ring_scales(const std::string& depth_per_texel, const std::string& texels_per_metre) {
  return "ConeScales s; s.depthPerTexel = " + depth_per_texel + "; s.texelsPerDepth = 1.0 / (" +
         depth_per_texel + "); s.texelsPerMetre = " + texels_per_metre +
         "; s.depthPerMetre = 1e-3; s.largestRadius = 2048.0; ";
}

CoreFunction depth_rings(const std::string& statement, int inputs, int outputs) {
  return function_in("Filters/Cells", "CellRings", statement, inputs, outputs);
}
CoreFunction depth_ring_sums(const std::string& statement, int inputs, int outputs) {
  return function_in("Filters/Cells", "CellSums", statement, inputs, outputs);
}

Exact toward_light(DepthDirection direction, Exact depth, Exact reference) {
  return direction == DepthDirection::reversed ? depth - reference : reference - depth;
}
Exact behind_near_plane(DepthDirection direction, Exact depth) {
  const Exact step = 0x1p-24L;
  return direction == DepthDirection::reversed ? std::clamp(depth, Exact{0}, 1 - step)
                                               : std::clamp(depth, step, Exact{1});
}
Exact share_of_ring(Exact distance, int level, Exact radius, Exact ring_cells) {
  const auto ramp = [&](Exact cell) {
    return std::clamp((std::min(ring_cells * cell, radius) - distance) / cell + 0.5L, Exact{0}, Exact{1});
  };
  const Exact cell = std::ldexp(Exact{1}, level);
  return level == 0 ? ramp(cell) : ramp(cell) * (1 - ramp(cell / 2));
}

TEST(DepthRings, SharesOfRingsAreThoseOfTheRamps) {
  const std::vector<float> inputs = random_cases(201, [&](Random& random, int i) {
    const int level = random.integer(0, 8);
    const float cells = i % 2 == 0 ? 3.0f : 5.0f;
    const float end = cells * std::exp2(static_cast<float>(level));
    const float radius = i % 3 == 0 ? random.between(0.0f, 1.5f * end) : 3.0f * end;
    return Case{random.between(0.0f, 1.2f * end), static_cast<float>(level), radius, cells};
  });
  const std::vector<float> out =
      run(depth_rings("Out(0, ShareInRing(In(0), int(In(1)), In(2), In(3)));", 4, 1), inputs);
  int partial = 0, whole = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Exact exact = share_of_ring(inputs[4 * i], static_cast<int>(inputs[4 * i + 1]), inputs[4 * i + 2],
                                      inputs[4 * i + 3]);
    // The share has the roundings of a difference of up to 6 cells, a half, and a product.
    ASSERT_NEAR(out[i], static_cast<double>(exact), 6.0 * 0x1p-23) << i;
    partial += exact > 0.0L && exact < 1.0L ? 1 : 0;
    whole += exact == 1.0L ? 1 : 0;
  }
  EXPECT_GT(partial, kRandomCases / 20);
  EXPECT_GT(whole, kRandomCases / 20);
}

TEST(DepthRings, ADiscIsItsRingAndWhatThatEncloses) {
  const std::vector<float> inputs = random_cases(206, [&](Random& random, int i) {
    const int level = random.integer(0, 8);
    const float end = 5.0f * std::exp2(static_cast<float>(level));
    const float radius = i % 3 == 0 ? random.between(0.0f, 1.5f * end) : 3.0f * end;
    return Case{random.between(0.0f, 1.2f * end), static_cast<float>(level), radius, 5.0f};
  });
  const std::vector<float> out =
      run(depth_rings("Out(0, ShareInDisc(In(0), int(In(1)), In(2), In(3)));", 4, 1), inputs);
  int partial = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Exact width = std::exp2(static_cast<Exact>(inputs[4 * i + 1]));
    const Exact end =
        std::min(static_cast<Exact>(inputs[4 * i + 3]) * width, static_cast<Exact>(inputs[4 * i + 2]));
    const Exact exact = std::clamp((end - static_cast<Exact>(inputs[4 * i])) / width + 0.5L, 0.0L, 1.0L);
    // The share has the roundings of a difference of up to 6 cells and a half.
    ASSERT_NEAR(out[i], static_cast<double>(exact), 6.0 * 0x1p-23) << i;
    partial += exact > 0.0L && exact < 1.0L ? 1 : 0;
  }
  EXPECT_GT(partial, kRandomCases / 20);
}

TEST(DepthRings, SharesStayInRangeWhateverTheyAreGiven) {
  const std::vector<float> inputs = random_cases(202, [&](Random& random, int i) {
    const std::vector<float> odd = random_special_floats(random, 2);
    return Case{i % 2 == 0 ? odd[0] : random.between(0.0f, 100.0f), static_cast<float>(random.integer(0, 8)),
                i % 3 == 0 ? random.between(0.0f, 100.0f) : odd[1], 5.0f};
  });
  const std::vector<float> out =
      run(depth_rings("Out(0, ShareInRing(In(0), int(In(1)), In(2), In(3)));", 4, 1), inputs);
  for (std::size_t i = 0; i < out.size(); ++i) ASSERT_TRUE(out[i] >= 0.0f && out[i] <= 1.0f) << i;
}

TEST(DepthRings, LevelsReachTheRadiusAndNoFarther) {
  const std::vector<float> inputs = random_cases(203, [&](Random& random, int i) {
    const float cells = i % 2 == 0 ? 3.0f : 5.0f;
    const float power = cells * std::exp2(static_cast<float>(random.integer(0, 9)));
    const float near_power = i % 4 == 0 ? power : i % 4 == 1 ? std::nextafter(power, 1e9f) : power * 1.001f;
    return Case{i % 2 == 0 ? near_power : random.between(0.0f, 3000.0f), cells,
                static_cast<float>(random.integer(0, 8))};
  });
  const std::vector<float> out =
      run(depth_rings("OutInt(0, RingLevels(In(0), In(1), int(In(2))));", 3, 1), inputs);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int levels = static_cast<int>(out[i]);
    const Exact radius = inputs[3 * i], cells = inputs[3 * i + 1];
    const int most = static_cast<int>(inputs[3 * i + 2]);
    ASSERT_GE(levels, 0) << i;
    ASSERT_LE(levels, most) << i;
    if (levels < most) {  // otherwise the device's logarithm may be wrong by one
      ASSERT_GE(std::ldexp(cells, levels), radius * (1 - 1e-6L)) << i;
    }
    if (levels > 0) {
      ASSERT_LT(std::ldexp(cells, levels - 1), radius * (1 + 1e-6L)) << i;
    }
  }
}

struct RingPlane {
  Exact depth, x, y;
  Exact at(DepthDirection direction, Exact away_x, Exact away_y) const {
    return behind_near_plane(direction, depth + x * away_x + y * away_y);
  }
};

// The inputs are depth, gradient and place of receivers, and a depth near their plane or anywhere, at either
// end, too.
std::vector<float> receivers_and_depths(std::uint32_t seed) {
  const std::vector<float> inputs = random_cases(seed, [&](Random& random, int i) {
    const float slope = i % 4 == 0 ? 0.0f : i % 4 == 1 ? 0.3f : std::fabs(random.magnitude(-6.0f, -2.0f));
    const float x = slope * random.between(-1.0f, 1.0f), y = slope * random.between(-1.0f, 1.0f);
    const float depth = i % 9 == 0 ? 0.0f : i % 9 == 1 ? 1.0f : random.between(0.0f, 1.0f);
    const float away_x = random.between(-40.0f, 40.0f), away_y = random.between(-40.0f, 40.0f);
    const float plane = std::clamp(depth + x * away_x + y * away_y, 0.0f, 1.0f);
    const float near_plane = std::clamp(plane + random.magnitude(-6.0f, -1.0f), 0.0f, 1.0f);
    const float texel = i % 5 == 0   ? random.between(0.0f, 1.0f)
                        : i % 5 == 1 ? static_cast<float>(random.integer(0, 1))
                                     : near_plane;
    return Case{depth, x, y, away_x, away_y, texel};
  });
  return inputs;
}

TEST(DepthRings, ATexelBlocksAboveThePlaneAndTheReceiver) {
  for (const DepthDirection direction : kDepthDirections) {
    const std::vector<float> inputs = receivers_and_depths(204);
    const std::vector<float> out =
        run(depth_rings(kRingReceiver +
                            "r.depth = In(0); r.gradient = float2(In(1), In(2)); const CellBlockers b = "
                            "BlockersOfTexel(In(5), float2(In(3), In(4)), r); Out(0, b.share); Out(1, "
                            "b.gap); Out(2, PlaneDepth(r, float2(In(3), In(4))));",
                        6, 3),
            direction, inputs);
    int blocking = 0, passing = 0;
    for (std::size_t i = 0; i < out.size() / 3; ++i) {
      const float* in = &inputs[6 * i];
      const RingPlane plane{in[0], in[1], in[2]};
      const Exact at = plane.at(direction, in[3], in[4]);
      // The three terms are each rounded, and so are their sums.
      const Exact terms = std::fabs(static_cast<Exact>(in[0])) +
                          std::fabs(static_cast<Exact>(in[1]) * in[3]) +
                          std::fabs(static_cast<Exact>(in[2]) * in[4]) + 1.0L;
      const Exact error = 4 * 0x1p-24L * terms;
      ASSERT_NEAR(out[3 * i + 2], static_cast<double>(at), static_cast<double>(error)) << i;
      const Exact gap = toward_light(direction, in[5], in[0]);
      ASSERT_NEAR(out[3 * i + 1], static_cast<double>(gap), 0x1p-24) << i;
      const Exact above = toward_light(direction, in[5], at);
      if (std::fabs(above) <= error + 0x1p-24L || (gap != 0.0L && std::fabs(gap) < 0x1p-24L)) continue;
      const bool blocks = above > 0.0L && gap > 0.0L;
      ASSERT_EQ(out[3 * i], blocks ? 1.0f : 0.0f) << i;
      ++(blocks ? blocking : passing);
    }
    EXPECT_GT(blocking, kRandomCases / 10);
    EXPECT_GT(passing, kRandomCases / 10);
  }
}

const std::string kOfCell =
    kRingReceiver +
    "r.depth = In(0); r.gradient = float2(In(1), In(2)); DepthSpread d; d.mean = In(5); d.deviation = In(6); "
    "const CellBlockers b = BlockersOfCell(d, float2(In(3), In(4)), In(7), In(8), r); Out(0, b.share); "
    "Out(1, b.gap);";

TEST(DepthRings, ACellBlocksAsItsMeanAndDeviationSay) {
  for (const DepthDirection direction : kDepthDirections) {
    const std::vector<float> places = receivers_and_depths(205);
    Random random(206);
    std::vector<float> inputs;
    for (std::size_t i = 0; i < places.size() / 6; ++i) {
      inputs.insert(inputs.end(), &places[6 * i], &places[6 * i] + 6);
      const float deviation = i % 3 == 0 ? 0.0f : std::min(std::fabs(random.magnitude(-5.0f, -0.3f)), 0.5f);
      inputs.insert(inputs.end(), {deviation, std::exp2(static_cast<float>(random.integer(1, 8))),
                                   i % 4 == 0 ? 0.0f : std::fabs(random.magnitude(-6.0f, -2.0f))});
    }
    const std::vector<float> out = run(depth_rings(kOfCell, 9, 2), direction, inputs);
    int blocking = 0, passing = 0, skipped = 0;
    for (std::size_t i = 0; i < out.size() / 2; ++i) {
      const float* in = &inputs[9 * i];
      ASSERT_TRUE(std::isfinite(out[2 * i + 1])) << i;
      ASSERT_TRUE(out[2 * i] >= 0.0f && out[2 * i] <= 1.0f) << i;
      const RingPlane plane{in[0], in[1], in[2]};
      const Exact at = plane.at(direction, in[3], in[4]);
      const Exact cell = in[7], ground = in[8], deviation = in[6];
      const Exact above = toward_light(direction, in[5], at) + ground;
      const auto size = [](float value) { return std::fabs(static_cast<Exact>(value)); };
      const Exact rise = size(in[1]) * (size(in[3]) + cell) + size(in[2]) * (size(in[4]) + cell);
      const Exact terms = size(in[0]) + size(in[1]) * size(in[3]) + size(in[2]) * size(in[4]) + 2.0L;
      const Exact error = 6 * 0x1p-24L * terms;
      const Exact least = static_cast<Exact>(6e-5f) + static_cast<Exact>(0.03f) * rise;
      if (std::fabs(above - least) <= error + 4 * 0x1p-24L * least) {
        ++skipped;
        continue;
      }
      if (above < least) {
        ASSERT_EQ(out[2 * i], 0.0f) << i;
        ++passing;
        continue;
      }
      const Exact slope = (1.0L + static_cast<Exact>(0.1f)) *
                          (size(in[1]) * size(in[1]) + size(in[2]) * size(in[2])) * cell * cell / 12.0L;
      const Exact own = slope + 2.0L * static_cast<Exact>(2e-5f) * deviation;
      const Exact square = above * above + std::max(deviation * deviation - own, Exact{0});
      const Exact gap = square / above - ground + toward_light(direction, at, in[0]);
      const Exact share = above * above / square;
      // `above` is off by `error`, and the squares by roundings of their terms.
      const Exact squares = 4 * 0x1p-24L * (deviation * deviation + own);
      const Exact share_error = (3 * error / above + squares / square) * share + 8 * 0x1p-24L;
      const Exact gap_error =
          (2 * error / above + squares / square) * (square / above) + 2 * error + 8 * 0x1p-24L;
      ASSERT_NEAR(out[2 * i + 1], static_cast<double>(gap), static_cast<double>(gap_error)) << i;
      if (std::fabs(gap) <= gap_error) continue;
      ASSERT_NEAR(out[2 * i], static_cast<double>(gap > 0.0L ? share : 0.0L),
                  static_cast<double>(share_error))
          << i;
      ++(gap > 0.0L ? blocking : passing);
    }
    EXPECT_GT(blocking, kRandomCases / 10);
    EXPECT_GT(passing, kRandomCases / 10);
    EXPECT_LT(skipped, kRandomCases / 20);
  }
}

// A share of the cell at one height and the rest on the ground: both come out.
TEST(DepthRings, ACellOfTwoHeightsHasTheShareAndTheHeight) {
  for (const DepthDirection direction : kDepthDirections) {
    Random random(207);
    std::vector<float> inputs;
    std::vector<std::pair<Exact, Exact>> known;
    for (int i = 0; i < kRandomCases; ++i) {
      const float depth = random.between(0.3f, 0.7f), ground = std::fabs(random.magnitude(-5.0f, -3.0f));
      const float height = random.between(0.01f, 0.25f), share = random.between(0.05f, 1.0f);
      const Exact sign = direction == DepthDirection::reversed ? 1.0L : -1.0L;
      const Exact mean = static_cast<Exact>(depth) +
                         sign * (static_cast<Exact>(share) * height - static_cast<Exact>(ground));
      const Exact deviation = height * std::sqrt(static_cast<Exact>(share) * (1.0L - share));
      inputs.insert(inputs.end(),
                    {depth, 0.0f, 0.0f, random.between(-9.0f, 9.0f), random.between(-9.0f, 9.0f),
                     static_cast<float>(mean), static_cast<float>(deviation), 4.0f, ground});
      known.emplace_back(share, static_cast<Exact>(height) - ground);
    }
    const std::vector<float> out = run(depth_rings(kOfCell, 9, 2), direction, inputs);
    for (std::size_t i = 0; i < known.size(); ++i) {
      const auto [share, gap] = known[i];
      // The mean is a float, which is off by 2^-25. A deviation's error takes 2 e s from its square, and so
      // lowers the square that the share is a quotient by.
      const Exact above = share * (gap + static_cast<Exact>(inputs[9 * i + 8]));
      const Exact square = above * (gap + static_cast<Exact>(inputs[9 * i + 8]));
      const Exact deviation = inputs[9 * i + 6];
      const Exact of_square =
          (2 * 2.1e-5L * deviation + 4 * 0x1p-24L * square) / (square - 4.2e-5L * deviation);
      const Exact of_mean = 4 * 0x1p-24L / above;
      ASSERT_NEAR(out[2 * i], static_cast<double>(share),
                  static_cast<double>(share * (of_square + 2 * of_mean) + 1e-6L))
          << i;
      ASSERT_NEAR(out[2 * i + 1], static_cast<double>(gap),
                  static_cast<double>(square / above * (of_square + 2 * of_mean) + 1e-6L))
          << i;
    }
  }
}

// The ground is the nearest texel below the plane, of those less deep than eight texels are wide, in whatever
// order they come.
TEST(DepthRings, TheGroundIsTheNearestTexelBelowThePlane) {
  for (const DepthDirection direction : kDepthDirections) {
    Random random(208);
    constexpr int kTexels = 6;
    std::vector<float> inputs;
    for (int i = 0; i < kRandomCases; ++i) {
      const float texels_per_metre = i % 50 == 0 ? 0.0f : std::fabs(random.magnitude(0.0f, 2.0f));
      inputs.insert(inputs.end(), {random.between(0.2f, 0.8f), texels_per_metre});
      const float usual = 1e-3f / std::max(texels_per_metre, 1e-9f);
      for (int k = 0; k < kTexels; ++k)
        inputs.push_back(std::clamp(inputs[inputs.size() - 2 - static_cast<std::size_t>(k)] +
                                        random.between(-12.0f, 12.0f) * std::min(usual, 0.1f),
                                    0.0f, 1.0f));
    }
    const std::string texels =
        kRingReceiver + ring_scales("1.0", "In(1)") +
        "r.depth = In(0); r.gradient = float2(0.0, 0.0); bool found = false, other = false; float ground = "
        "UsualGround(s), backward = UsualGround(s); Out(1, ground);for (int k = 0; k < 6; ++k) { ground = "
        "GroundWithTexel(ground, found, In(2 + k), float2(k, 1.0), r, s); backward = "
        "GroundWithTexel(backward, other, In(7 - k), float2(k, 1.0), r, s); }Out(0, ground); Out(2, "
        "backward); Out(3, found ? 1.0 : 0.0);";
    const std::vector<float> out = run(depth_rings(texels, 2 + kTexels, 4), direction, inputs);
    int with_ground = 0;
    for (std::size_t i = 0; i < out.size() / 4; ++i) {
      const float* in = &inputs[(2 + kTexels) * i];
      const Exact usual = static_cast<Exact>(1e-3f) / std::max(static_cast<Exact>(in[1]), Exact{1e-9f});
      ASSERT_NEAR(out[4 * i + 1], static_cast<double>(usual), static_cast<double>(usual * 0x1p-22L)) << i;
      Exact ground = usual;
      bool found = false, close = false;
      for (int k = 0; k < kTexels; ++k) {
        const Exact below = toward_light(direction, in[0], in[2 + k]);
        close = close || std::fabs(below - 8 * usual) < 0x1p-20L * usual + 0x1p-24L;
        if (!(below > 0.0L) || !(below < 8 * usual)) continue;
        ground = found ? std::min(ground, below) : below;
        found = true;
      }
      ASSERT_EQ(out[4 * i], out[4 * i + 2]) << i << ": another order";
      if (close) continue;
      ASSERT_EQ(out[4 * i + 3], found ? 1.0f : 0.0f) << i;
      ASSERT_NEAR(out[4 * i], static_cast<double>(ground), static_cast<double>(ground * 0x1p-22L) + 0x1p-24)
          << i;
      with_ground += found ? 1 : 0;
    }
    EXPECT_GT(with_ground, kRandomCases / 2);
  }
}

TEST(DepthRings, SumsWeighBlockersByTheShareOfTheDiscThatTheyHide) {
  const std::vector<float> inputs = random_cases(209, [&](Random& random) {
    const float cell = std::exp2(static_cast<float>(random.integer(0, 8)));
    const float own = std::fabs(random.magnitude(-2.0f, 2.5f));
    const float depth_per_texel = std::fabs(random.magnitude(-6.0f, -2.0f));
    return Case{random.between(0.0f, 1.0f),
                own * depth_per_texel,
                random.between(0.0f, 6.0f) * own,
                cell,
                random.between(0.0f, 1.0f) * cell * cell,
                depth_per_texel};
  });
  const std::vector<float> out =
      run(depth_rings(ring_scales("In(5)", "10.0") +
                          "CellBlockers b; b.share = In(0); b.gap = In(1); RingSums sums = NoBlockers(); "
                          "Out(4, abs(sums.inside.x) + abs(sums.inside.y) + abs(sums.nearby.x) + "
                          "abs(sums.nearby.y)); sums = AddBlockers(sums, b, In(2), In(3), In(4), s); "
                          "Out(0, sums.inside.x); Out(1, sums.inside.y); Out(2, sums.nearby.x); Out(3, "
                          "sums.nearby.y);",
                      6, 5),
          inputs);
  int inside = 0;
  for (std::size_t i = 0; i < out.size() / 5; ++i) {
    const float* in = &inputs[6 * i];
    ASSERT_EQ(out[5 * i + 4], 0.0f) << "nothing before the first blocker";
    const Exact own = static_cast<Exact>(in[1]) / static_cast<Exact>(in[5]);
    const Exact radius = std::max(own, Exact{1}), cell = in[3];
    const auto weight = [&](Exact reach) {
      return std::clamp((reach - static_cast<Exact>(in[2])) / cell + 0.5L, Exact{0}, Exact{1});
    };
    const Exact blocked = static_cast<Exact>(in[4]) * static_cast<Exact>(in[0]);
    const Exact near_reach = std::max(5 * own, Exact{1});
    const Exact expected[] = {weight(radius) / (radius * radius), weight(radius) / radius,
                              weight(near_reach) / (radius * radius), weight(near_reach) / radius};
    for (std::size_t k = 0; k < 4; ++k) {
      const Exact reach = k < 2 ? radius : near_reach;
      // The weight has the roundings of the reach and of the distance from it, in cells, and of four factors.
      const Exact of_weight = 8 * 0x1p-24L * (1.0L + (reach + static_cast<Exact>(in[2])) / cell);
      const Exact scale = blocked / (k % 2 == 0 ? radius * radius : radius);
      ASSERT_NEAR(out[5 * i + k], static_cast<double>(blocked * expected[k]),
                  static_cast<double>(scale * (of_weight + 12 * 0x1p-24L)))
          << i << ", sum " << k;
    }
    inside += weight(radius) > 0.0L ? 1 : 0;
  }
  EXPECT_GT(inside, kRandomCases / 10);
}

// The quads of all levels hold each cell of the tile's rings once, and no cell outside of the tile.
TEST(DepthRingSums, QuadsHoldTheAreaOfEveryCellOfTheRings) {
  Random random(210);
  std::vector<float> inputs;
  constexpr int kCases = 400;
  for (int i = 0; i < kCases; ++i) {
    const float low = i % 2 == 0 ? 0.0f : 96.0f;
    inputs.insert(inputs.end(), {low, random.between(low, low + 96.0f), random.between(low, low + 96.0f),
                                 i % 5 == 0 ? random.between(0.0f, 2.0f) : random.between(0.0f, 60.0f),
                                 i % 3 == 0 ? 3.0f : 5.0f});
  }
  const std::vector<float> out =
      run(depth_ring_sums(
              kRingReceiver +
                  "r.bounds.minimum = float2(In(0), In(0)); r.bounds.maximum = r.bounds.minimum + 96.0; "
                  "r.centre = float2(In(1), In(2)); float sum = 0.0; bool any = false;const int levels = "
                  "RingLevels(In(3), In(4), kMostRingLevels);for (int level = 0; level <= levels; ++level) "
                  "{const QuadRange quads = QuadsAround(r, level, In(3), In(4));for (int i = 0; i < "
                  "CountOf(quads); ++i) {const float4 areas = AreasInRing(QuadAt(quads, i), level, In(3), "
                  "In(4), r);any = any || AnyArea(areas);sum += (areas.x + areas.y) + (areas.z + areas.w); } "
                  "} Out(0, sum); Out(1, any ? 1.0 : 0.0);",
              5, 2),
          inputs);
  for (std::size_t i = 0; i < kCases; ++i) {
    const float* in = &inputs[5 * i];
    const Exact radius = in[3], cells = in[4];
    int levels = 0;
    while (std::ldexp(cells, levels) < radius) ++levels;
    Exact sum = 0.0L;
    for (int level = 0; level <= levels; ++level) {
      const int width = 1 << level;
      const int first = (static_cast<int>(in[0]) + width - 1) / width;
      const int end = (static_cast<int>(in[0]) + 96) / width;
      for (int y = first; y < end; ++y)
        for (int x = first; x < end; ++x) {
          const Exact dx = (x + 0.5L) * width - in[1], dy = (y + 0.5L) * width - in[2];
          sum += share_of_ring(std::sqrt(dx * dx + dy * dy), level, radius, cells) * width * width;
        }
    }
    // A cell's share is off by the roundings of its distance, 1e-6 of a cell or so; some hundred are summed.
    ASSERT_NEAR(out[2 * i], static_cast<double>(sum), static_cast<double>(2e-5L * (sum + 1.0L))) << i;
    ASSERT_EQ(out[2 * i + 1], out[2 * i] > 0.0f ? 1.0f : 0.0f) << i;
  }
}

// The search goes over quads of texels, and the filter over what it finds: a wall above the receiver's right
// half.
TEST(DepthRingSums, AWallOverHalfOfTheDiscHidesHalfOfIt) {
  for (const DepthDirection direction : kDepthDirections) {
    const float wall = direction == DepthDirection::reversed ? 0.6f : 0.4f;
    const float empty = direction == DepthDirection::reversed ? 0.0f : 1.0f;
    std::vector<float> inputs;
    // The cases are the penumbra's radius in texels, and whether the wall begins at the receiver or is
    // everywhere.
    for (const float radius : {1.2f, 2.5f, 4.0f})
      for (const float first : {64.0f, 0.0f, 128.0f})
        inputs.insert(inputs.end(), {radius, first, wall, empty});
    const std::string body =
        kRingReceiver + ring_scales("0.1 / In(0)", "10.0") +
        "r.bounds.maximum = float2(128.0, 128.0); r.centre = float2(64.0, 64.0); r.depth = 0.5; r.gradient = "
        "float2(0.0, 0.0); RingSearch search = BeginSearch(s); int i; int k; float4 depths; const float "
        "reach = 5.0;QuadRange quads = QuadsAround(r, 0, reach, 5.0);for (i = 0; i < CountOf(quads); ++i) { "
        "for (k = 0; k < 4; ++k) depths[k] = float(CellOfQuad(QuadAt(quads, i), k).x) >= In(1) ? In(2) : "
        "In(3);search = SearchTexels(search, depths, QuadAt(quads, i), AreasInRing(QuadAt(quads, i), 0, "
        "reach, 5.0, r), r, s); }const RingPenumbra penumbra = PenumbraOf(search, reach, s); float2 sums = "
        "float2(0.0, 0.0);if (penumbra.readsDisc) { quads = QuadsAround(r, 0, penumbra.radius, 5.0);for (i = "
        "0; i < CountOf(quads); ++i) { for (k = 0; k < 4; ++k) depths[k] = float(CellOfQuad(QuadAt(quads, "
        "i), k).x) >= In(1) ? In(2) : In(3);sums = FilterTexels(sums, depths, QuadAt(quads, i), "
        "AreasInRing(QuadAt(quads, i), 0, penumbra.radius, 5.0, r), penumbra, r); } }else for (i = 0; i < 4; "
        "++i) { const int2 first = QuadOfBlock(r, i); for (k = 0; k < 4; ++k) depths[k] = float(first.x + (k "
        "& 1)) >= In(1) ? In(2) : In(3); sums = FilterBlockQuad(sums, depths, first, penumbra, r); }Out(0, "
        "penumbra.blocked ? LitShare(sums.x, sums.y) : 1.0); Out(1, penumbra.radius);";
    const std::vector<float> out = run(depth_ring_sums(body, 4, 2), direction, inputs);
    for (std::size_t i = 0; i < out.size() / 2; ++i) {
      const float first = inputs[4 * i + 1];
      // The receiver stands on the edge, between texels: both halves have the same texels.
      const double expected = first == 64.0f ? 0.5 : first == 0.0f ? 0.0 : 1.0;
      ASSERT_NEAR(out[2 * i], expected, 1e-5) << i;
      if (first < 128.0f) {
        ASSERT_NEAR(out[2 * i + 1], inputs[4 * i], 2e-5 * inputs[4 * i]) << i;
      }
    }
  }
}

// A texel close to the receiver and a little below it is the ground; one farther away is not looked at.
TEST(DepthRingSums, TheSearchFindsTheGroundAmongTheTexelsNearby) {
  for (const DepthDirection direction : kDepthDirections) {
    const float sign = direction == DepthDirection::reversed ? 1.0f : -1.0f;
    std::vector<float> inputs;
    for (const float column : {63.0f, 64.0f, 65.0f, 67.0f})  // 2.5 texels and more away, the last one
      inputs.insert(inputs.end(),
                    {column, 0.5f - sign * 3e-4f, direction == DepthDirection::reversed ? 0.0f : 1.0f});
    const std::string body =
        kRingReceiver + ring_scales("1e-3", "10.0") +
        "r.bounds.maximum = float2(128.0, 128.0); r.centre = float2(64.0, 64.0); r.depth = 0.5; r.gradient = "
        "float2(0.0, 0.0); RingSearch search = BeginSearch(s); const QuadRange quads = QuadsAround(r, 0, "
        "6.0, 5.0); for (int i = 0; i < CountOf(quads); ++i) { const int2 quad = QuadAt(quads, i); float4 "
        "depths;for (int k = 0; k < 4; ++k) depths[k] = float(CellOfQuad(quad, k).x) == In(0) ? In(1) : "
        "In(2);search = SearchTexels(search, depths, quad, AreasInRing(quad, 0, 6.0, 5.0, r), r, s); }Out(0, "
        "search.ground); Out(1, search.groundFound ? 1.0 : 0.0); Out(2, UsualGround(s));";
    const std::vector<float> out = run(depth_ring_sums(body, 3, 3), direction, inputs);
    for (std::size_t i = 0; i < out.size() / 3; ++i) {
      const bool is_near = i < 3;
      EXPECT_EQ(out[3 * i + 1], is_near ? 1.0f : 0.0f) << i;
      EXPECT_NEAR(out[3 * i], is_near ? 3e-4f : out[3 * i + 2], 1e-7) << i;
    }
  }
}

// Four cells of the same mean and no deviation are four times as much area of one blocker.
TEST(DepthRingSums, CellsWithoutDeviationAreTheirMeans) {
  for (const DepthDirection direction : kDepthDirections) {
    const std::vector<float> inputs = random_cases(
        211,
        [&](Random& random) {
          return Case{random.between(0.2f, 0.8f), std::round(65535.0f * random.between(0.0f, 1.0f))};
        },
        2000);
    const std::string body =
        kRingReceiver + ring_scales("1e-3", "1e9") +
        "r.bounds.maximum = float2(128.0, 128.0); r.centre = float2(64.0, 64.0); r.depth = In(0); r.gradient "
        "= float2(0.0, 0.0); RingSearch search = BeginSearch(s); const uint4 cells = uint4(1, 1, 1, 1) * "
        "(uint(In(1)) << 16); const float4 areas = float4(4.0, 4.0, 4.0, 4.0);search = SearchCells(search, "
        "cells, int2(16, 16), 1, areas, r, s);RingPenumbra penumbra = PenumbraOf(search, 2000.0, s); "
        "penumbra.cone.largestOffset = 0.0;const float2 sums = FilterCells(float2(0.0, 0.0), cells, int2(16, "
        "16), 1, areas, penumbra, r);Out(0, search.sums.nearby.x > 0.0 ? search.sums.nearby.y / "
        "search.sums.nearby.x : 0.0); Out(1, sums.x); Out(2, sums.y);";
    const std::vector<float> out = run(depth_ring_sums(body, 2, 3), direction, inputs);
    int blocked = 0;
    for (std::size_t i = 0; i < out.size() / 3; ++i) {
      const Exact gap =
          toward_light(direction, static_cast<Exact>(inputs[2 * i + 1]) / 65535.0L, inputs[2 * i]);
      ASSERT_NEAR(out[3 * i + 1] + out[3 * i + 2], 16.0, 1e-5) << i;
      if (std::fabs(gap - 6e-5L) < 1e-6L) continue;
      ASSERT_EQ(out[3 * i + 2], gap > 6e-5L ? 16.0f : 0.0f) << i;
      if (5.0L * gap / 1e-3L < 1.0L + 4.0L) continue;  // the cells lie beside the wider cone
      ASSERT_NEAR(out[3 * i], static_cast<double>(gap / 1e-3L),
                  static_cast<double>(gap / 1e-3L) * 1e-5 + 1e-3)
          << i;
      ++blocked;
    }
    EXPECT_GT(blocked, 500);
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
