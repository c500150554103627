// Compares the single-loop soft shadow with its formulae in C++, and its early exits with itself without
// them, and counts what each reads.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <random>

#include "resolve/kept_runners.h"
#include "resolve/run_once.h"
#include "resolve/shadow_shader.h"
#include "resolve/synthetic_frame.h"

namespace penumbra::resolve {
namespace {

using testing_frames::FrameSetup;
using testing_frames::TexelDepth;
using testing_frames::TilePoint;

constexpr int kColumns = 32;

class SingleLoop : public testing::TestWithParam<bool> {
 protected:
  static FrameSetup setup(bool reversed, int cascades, int cascade, double degrees) {
    FrameSetup setup;
    setup.shadows.cascades = cascades;
    setup.shadows.resolution = cascades == 1 ? 256 : 512;
    setup.shadows.reversed_z = reversed;
    setup.light.angular_diameter_degrees = degrees;
    setup.cascade = cascade;
    return setup;
  }
  static double depth(double distance) { return GetParam() ? 1.0 - distance : distance; }

  static GraphResult run(const std::string& name, const scene::Frame& frame,
                         const std::map<std::string, double>& values) {
    techniques::Technique technique = library_techniques().find(name);
    for (const auto& [field, value] : values) technique.values.at(field) = {value};
    static KeptRunners runners;
    GraphRunner& runner = runners.of(name, GetParam(), [&] {
      return technique_graph(library_techniques(), technique, Taps::as_listed, GetParam());
    });
    runner.set_parameters(parameter_uniforms(library_techniques(), technique));
    return runner.run(FrameOnDevice(test_device(), frame), kCountedOnce);
  }

  // The receivers are all over the tile, its borders included, at two depths, one below the other.
  static scene::Frame frame_of(const FrameSetup& setup, const TexelDepth& map, double tilt) {
    std::vector<TilePoint> receivers;
    for (int i = 0; i < kColumns * kColumns; ++i)
      receivers.emplace_back(std::clamp((i % kColumns + 0.37) / (kColumns - 0.2) - 0.005, 0.0, 1.0),
                             std::clamp((i / kColumns + 0.41) / (kColumns - 0.2) - 0.005, 0.0, 1.0),
                             depth(i % 3 == 0 ? 0.75 : 0.6));
    scene::Frame frame = testing_frames::make_frame(setup, map, receivers, kColumns);
    for (glm::vec4& normal : frame.receivers.normal_ws) {
      const glm::vec3 tilted =
          glm::normalize(glm::vec3(normal) + static_cast<float>(tilt) * glm::vec3(0.8f, 0.3f, -0.5f));
      normal = glm::vec4(tilted, 0.0f);
    }
    return frame;
  }

  // The map has squares of 8 texels: nothing, or a wall at one of four heights, two of them as low as the
  // slopes' own rise.
  static TexelDepth walls(int texels) {
    return [texels](double u, double v, int tile) {
      const auto square = [&](double at) { return static_cast<unsigned>(at * texels / 8.0); };
      std::minstd_rand engine(square(u) * 1009u + square(v) * 31u + static_cast<unsigned>(tile) * 7u + 3u);
      engine.discard(3);
      const unsigned kind = engine() % 8u;
      constexpr std::array<double, 4> kWalls{0.597, 0.594, 0.4, 0.2};
      return static_cast<float>(depth(kind < 4 ? 1.0 : kWalls[kind - 4U]));
    };
  }

  // The map has large areas without blockers, large areas below a roof, and walls between.
  static TexelDepth quarters(int texels) {
    return [texels](double u, double v, int tile) {
      if (u < 0.4) return static_cast<float>(depth(v < 0.5 ? 1.0 : 0.8));
      if (u > 0.6) return static_cast<float>(depth(v < 0.5 ? 0.3 : 0.2 + 0.1 * u));
      return walls(texels)(u, v, tile);
    };
  }
};

// --- the formulae
// -------------------------------------------------------------------------------------------

float frac(float x) {
  return x - std::floor(x);
}
// The rotation is that of Core/Noise.hlsl at frame 0, in floats.
double rotation_of(int pixel_x, int pixel_y) {
  const float dot =
      (static_cast<float>(pixel_x) + 0.5f) * 0.06711056f + (static_cast<float>(pixel_y) + 0.5f) * 0.00583715f;
  return 2.0 * M_PI * frac(52.9829189f * frac(dot));
}

struct Formulae {
  const scene::Frame& frame;
  const parameters::Cascade& cascade;
  bool reversed;
  double disc_metres, smallest;
  int taps;
  int exponent = 1;

  int tile() const { return frame.cascades.tile_resolution; }
  double nearer(double a, double b) const { return reversed ? a - b : b - a; }
  double map_depth(int x, int y) const {
    return frame.atlas.depth[static_cast<std::size_t>(y * frame.atlas.width + x)];
  }
  // The stored depth per texel along the receiver's plane, from the world positions of three of its points.
  glm::dvec2 gradient(const glm::dvec3& normal) const {
    const glm::dmat4 to_world = glm::inverse(cascade.world_to_shadow);
    const glm::dvec3 x(to_world[0] / static_cast<double>(frame.atlas.width));
    const glm::dvec3 y(to_world[1] / static_cast<double>(frame.atlas.height));
    const glm::dvec3 z(to_world[2]);
    return {-glm::dot(normal, x) / glm::dot(normal, z), -glm::dot(normal, y) / glm::dot(normal, z)};
  }

  // The borders are those of rings of equal area, or of equal width.
  double ring_border(double ring) const { return exponent == 1 ? std::sqrt(ring / taps) : ring / taps; }

  struct Answer {
    double visibility = 1.0;
    bool certain =
        true;  // no tap near enough to another texel, or to the plane, for floats to decide otherwise
  };
  Answer of(std::size_t i) const {
    const glm::dvec4 shadow =
        cascade.world_to_shadow * glm::dvec4(glm::dvec3(frame.receivers.position_ws[i]), 1.0);
    const glm::dvec2 centre(shadow.x * frame.atlas.width, shadow.y * frame.atlas.height);
    const glm::dvec2 slope = gradient(glm::dvec3(frame.receivers.normal_ws[i]));
    const double to_texels = cascade.depth_to_radial * tile();
    const double nearest = reversed ? 1.0 : 0.0;
    const double radius = std::max(
        smallest, std::min(nearer(nearest, shadow.z) * to_texels, disc_metres / cascade.texel_size_metres));
    const double rotation = rotation_of(static_cast<int>(i) % kColumns, static_cast<int>(i) / kColumns);
    const double golden = M_PI * (3.0 - std::sqrt(5.0));
    const glm::dvec4 rect = cascade.offset_scale;
    const glm::dvec2 low(rect.x * frame.atlas.width, rect.y * frame.atlas.height);

    Answer answer;
    std::vector<bool> blocked;
    double gaps = 0.0;
    int blockers = 0;
    for (int tap = 0; tap < taps; ++tap) {
      const double r = radius * ring_border(tap + 0.5);
      const glm::dvec2 at =
          centre + r * glm::dvec2(std::cos(golden * tap + rotation), std::sin(golden * tap + rotation));
      const auto gap_at = [&](const glm::dvec2& position) {
        const glm::dvec2 texel = glm::clamp(glm::floor(position), low, low + static_cast<double>(tile() - 1));
        const double stored = map_depth(static_cast<int>(texel.x), static_cast<int>(texel.y));
        const double above = nearer(stored, shadow.z + glm::dot(slope, texel + 0.5 - centre));
        answer.certain =
            answer.certain && std::fabs(above) > 1e-4 && std::fabs(nearer(stored, shadow.z)) > 1e-4;
        return above > 0.0 ? std::max(nearer(stored, shadow.z), 0.0) : 0.0;
      };
      const double gap = gap_at(at);
      for (const double x : {-0.02, 0.02})
        for (const double y : {-0.02, 0.02})
          answer.certain = answer.certain && std::fabs(gap_at(at + glm::dvec2(x, y)) - gap) < 1e-6;
      blocked.push_back(gap > 0.0);
      gaps += gap;
      blockers += gap > 0.0 ? 1 : 0;
    }
    if (blockers == 0) return answer;
    const double penumbra =
        std::clamp(std::max(gaps / blockers * to_texels, smallest), radius * ring_border(1.0), radius);
    double dark = 0.0;
    for (int ring = 0; ring < taps; ++ring) {
      const double inner = radius * ring_border(ring),
                   outer = std::min(radius * ring_border(ring + 1.0), penumbra);
      if (blocked[static_cast<std::size_t>(ring)]) dark += std::max(outer * outer - inner * inner, 0.0);
    }
    answer.visibility = 1.0 - dark / (penumbra * penumbra);
    return answer;
  }
};

TEST_P(SingleLoop, IsTheLitAreaOfTheRingsOfThePenumbra) {
  for (const double degrees : {6.0, 12.0, 20.0}) {
    for (const int taps : {32, 31}) {
      for (const double tilt : {0.0, 0.8}) {
        const FrameSetup frame_setup = setup(GetParam(), 4, 1, degrees);
        const scene::Frame frame = frame_of(frame_setup, walls(256), tilt);
        const double disc = 24.0 * frame.cascades.cascades[1].texel_size_metres;
        const int exponent = taps == 32 ? 1 : 2;
        const Formulae formulae{frame, frame.cascades.cascades[1], GetParam(), disc, 1.25, taps, exponent};
        const GraphResult result =
            run("single-loop-32", frame,
                {{"samples", taps}, {"ringExponent", exponent}, {"discRadiusMetres", disc}});
        int certain = 0, partly = 0;
        for (std::size_t i = 0; i < kColumns * kColumns; ++i) {
          ASSERT_EQ(result.fetches[i], static_cast<std::uint32_t>(taps));
          const Formulae::Answer answer = formulae.of(i);
          if (!answer.certain) continue;
          ++certain;
          partly += answer.visibility > 0.02 && answer.visibility < 0.98 ? 1 : 0;
          ASSERT_NEAR(result.visibility[0][i], answer.visibility, 2e-4)
              << degrees << " degrees, " << taps << " taps, tilt " << tilt << ", receiver " << i;
        }
        EXPECT_GT(certain, 250) << degrees << ", " << tilt;
        EXPECT_GT(partly, 40) << degrees << ", " << tilt;
      }
    }
  }
}

// --- the exits
// ----------------------------------------------------------------------------------------------

// The map has every depth, NaN and infinities among them.
float rough_depth(double u, double v, int tile) {
  std::minstd_rand engine(static_cast<unsigned>(u * 9973.0) * 977u + static_cast<unsigned>(v * 7919.0) * 31u +
                          static_cast<unsigned>(tile) + 1u);
  engine.discard(3);
  const auto kind = engine() % 50u;
  if (kind == 0) return std::numeric_limits<float>::quiet_NaN();
  if (kind == 1) return std::numeric_limits<float>::infinity();
  return std::generate_canonical<float, 24>(engine);
}

// This takes the place of a map that is known already.
float no_map(double, double, int) {
  return 0.0F;
}

// The lit share of the texels at (+-1, +-1) / sqrt(2) from a receiver that faces the light.
double four_taps(const scene::Frame& frame, int cascade, std::size_t receiver) {
  const parameters::Cascade& used = frame.cascades.cascades[static_cast<std::size_t>(cascade)];
  const glm::dvec4 shadow =
      used.world_to_shadow * glm::dvec4(glm::dvec3(frame.receivers.position_ws[receiver]), 1.0);
  const glm::dvec2 size(frame.atlas.width, frame.atlas.height);
  const glm::dvec2 low = glm::dvec2(used.offset_scale) * size;
  double lit = 0.0;
  for (const double x : {-std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0}) {
    for (const double y : {-std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0}) {
      const glm::dvec2 texel = glm::clamp(glm::floor(glm::dvec2(shadow) * size + glm::dvec2(x, y)), low,
                                          low + (frame.cascades.tile_resolution - 1.0));
      const double stored =
          frame.atlas.depth[static_cast<std::size_t>(texel.y) * static_cast<std::size_t>(frame.atlas.width) +
                            static_cast<std::size_t>(texel.x)];
      const bool blocks = frame.settings.shadows.reversed_z ? stored > shadow.z : stored < shadow.z;
      lit += blocks ? 0.0 : 0.25;
    }
  }
  return lit;
}

class SingleLoopExits : public SingleLoop {
 protected:
  struct Counts {
    int lit = 0, dark = 0, looped = 0;
  };

  // most is the number of fetches that an exit takes.
  static void expect_the_same(const GraphResult& exits, const GraphResult& plain, std::uint32_t most,
                              const std::string& what, Counts& counts) {
    for (std::size_t i = 0; i < kColumns * kColumns; ++i) {
      ASSERT_EQ(exits.visibility[0][i], plain.visibility[0][i]) << what << ", receiver " << i;
      const std::uint32_t fetches = exits.fetches[i];
      ASSERT_TRUE(fetches <= most || (fetches >= 32U && fetches <= 32U + most)) << what << ": " << fetches;
      (fetches > most ? counts.looped : plain.visibility[0][i] == 1.0f ? counts.lit : counts.dark) += 1;
    }
  }

  static void expect_each_often(const Counts& counts) {
    EXPECT_GT(counts.lit, 1000);
    EXPECT_GT(counts.dark, 1000);
    EXPECT_GT(counts.looped, 1000);
  }

  // The fetches of a technique with exits, whose bits are those of the loop.
  static std::vector<std::uint32_t> fetches_of_the_same(const std::string& technique,
                                                        const scene::Frame& frame, int cascade,
                                                        double disc_texels) {
    const double texel = frame.cascades.cascades[static_cast<std::size_t>(cascade)].texel_size_metres;
    const std::map<std::string, double> disc{{"discRadiusMetres", disc_texels * texel}};
    const GraphResult plain = run("single-loop-32", frame, disc);
    const GraphResult exits = run(technique, frame, disc);
    for (std::size_t i = 0; i < plain.fetches.size(); ++i)
      EXPECT_EQ(exits.visibility[0][i], plain.visibility[0][i]) << cascade << ", " << technique << ", " << i;
    return exits.fetches;
  }
};

constexpr const char* kWithExits[] = {"single-loop-32-mips", "single-loop-32-planes"};

TEST_P(SingleLoopExits, ChangeNoBit) {
  Counts levels, planes;
  for (const bool rough : {false, true}) {
    const TexelDepth map = rough ? TexelDepth(rough_depth) : quarters(256);
    const scene::ShadowAtlas atlas = frame_of(setup(GetParam(), 4, 0, 0.0), map, 0.0).atlas;
    for (int cascade = 0; cascade < 4; ++cascade) {
      for (const double degrees : {0.0, 0.53, 2.0, 8.0}) {
        for (const double tilt : {0.0, 0.1, 0.6}) {
          scene::Frame frame = frame_of(setup(GetParam(), 4, cascade, degrees), no_map, tilt);
          frame.atlas = atlas;
          const std::string what = "cascade " + std::to_string(cascade) + ", " + std::to_string(degrees) +
                                   " degrees, tilt " + std::to_string(tilt);
          const GraphResult plain = run("single-loop-32", frame, {});
          expect_the_same(run("single-loop-32-mips", frame, {}), plain, 4, "levels, " + what, levels);
          expect_the_same(run("single-loop-32-planes", frame, {}), plain, 9, "planes, " + what, planes);
          if (HasFatalFailure()) return;
        }
      }
    }
  }
  expect_each_often(levels);
  expect_each_often(planes);
}

// Places, depths and normals are random, steep ones too, above maps of every kind; a million in both
// directions.
TEST_P(SingleLoopExits, MissNoneOfAMillionReceivers) {
  constexpr int kSide = 354;
  std::minstd_rand engine(GetParam() ? 77 : 78);
  const auto random = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 32>(engine);
  };
  for (const int cascade : {0, 1, 2, 3}) {
    std::vector<TilePoint> receivers;
    for (int i = 0; i < kSide * kSide; ++i)
      receivers.emplace_back(random(0.0, 1.0), random(0.0, 1.0), random(0.0, 1.0));
    const TexelDepth map = [](double u, double v, int tile) {
      if (v > 0.9) return rough_depth(u, v, tile);
      if (v > 0.45 && v < 0.55) return static_cast<float>(depth(0.5 + 0.3 * u + 0.2 * v));
      return quarters(256)(u, v, tile);
    };
    scene::Frame frame =
        testing_frames::make_frame(setup(GetParam(), 4, cascade, random(0.5, 12.0)), map, receivers, kSide);
    for (glm::vec4& normal : frame.receivers.normal_ws) {
      const double tilt = std::pow(10.0, random(-3.0, 1.5));
      const glm::dvec3 aside(random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0));
      normal = glm::vec4(glm::vec3(glm::normalize(glm::dvec3(normal) + tilt * aside)), 0.0f);
    }
    for (const char* technique : kWithExits) {
      const std::vector<std::uint32_t> fetches = fetches_of_the_same(technique, frame, cascade, 20.0);
      EXPECT_GT(std::ranges::count_if(fetches, [](std::uint32_t count) { return count < 32U; }),
                kSide * kSide / 10)
          << cascade << ", " << technique;
    }
  }
}

// A tile of 192 texels has three blocks of the highest level that divides it: not every disc has a level of
// few enough.
TEST_P(SingleLoopExits, OverATileOfThreeBlocksChangeNoBit) {
  FrameSetup odd = setup(GetParam(), 4, 0, 30.0);
  odd.shadows.resolution = 384;
  const scene::Frame frame = frame_of(odd, quarters(192), 0.1);
  ASSERT_EQ(frame.cascades.tile_resolution, 192);
  for (const std::string technique : kWithExits)
    EXPECT_EQ(std::ranges::count(fetches_of_the_same(technique, frame, 0, 80.0), 32U) > 0,
              technique == "single-loop-32-mips")
        << "2 x 2 blocks are too few, 3 x 3 are not";
}

TEST_P(SingleLoop, ExitsOverTheDilatedMapChangeNoBitWhereItReachesTheDisc) {
  constexpr std::array<double, 3> kReach{4.0 * (8.0 - std::numbers::sqrt2), 4.0 * (4.0 - std::numbers::sqrt2),
                                         4.0 * (3.0 - std::numbers::sqrt2)};
  double lit = 0.0, dark = 0.0, looped = 0.0;
  for (std::size_t cascade = 0; cascade < 3; ++cascade) {
    for (const double tilt : {0.0, 0.1, 0.6}) {
      const FrameSetup frame_setup = setup(GetParam(), 4, static_cast<int>(cascade), 8.0);
      const scene::Frame frame = frame_of(frame_setup, quarters(256), tilt);
      const double disc = 0.999 * kReach[cascade] * frame.cascades.cascades[cascade].texel_size_metres;
      const GraphResult plain = run("single-loop-32", frame, {{"discRadiusMetres", disc}});
      const GraphResult exits = run("single-loop-32-minmax", frame, {{"discRadiusMetres", disc}});
      for (std::size_t i = 0; i < kColumns * kColumns; ++i) {
        ASSERT_EQ(exits.visibility[0][i], plain.visibility[0][i])
            << "cascade " << cascade << ", tilt " << tilt << ", receiver " << i;
        ASSERT_TRUE(exits.fetches[i] == 1U || exits.fetches[i] == 33U)
            << "cascade " << cascade << ": " << exits.fetches[i];
        (exits.fetches[i] != 1U ? looped : plain.visibility[0][i] == 1.0f ? lit : dark) += 1.0;
      }
    }
  }
  EXPECT_GT(lit, 300.0);
  EXPECT_GT(dark, 300.0);
  EXPECT_GT(looped, 300.0);
}

// The disc is wider than the map reaches. Where the range decides, the answer is that of the four taps, and
// where it does not, that of the loop.
TEST_P(SingleLoop, ADecidedRangeIsBelievedForAWiderDisc) {
  for (const int cascade : {1, 3}) {
    const FrameSetup frame_setup = setup(GetParam(), 4, cascade, 20.0);
    const scene::Frame frame = frame_of(frame_setup, quarters(256), 0.0);
    const double disc = 60.0 * frame.cascades.cascades[static_cast<std::size_t>(cascade)].texel_size_metres;
    const GraphResult plain = run("single-loop-32", frame, {{"discRadiusMetres", disc}});
    const GraphResult exits = run("single-loop-32-minmax", frame, {{"discRadiusMetres", disc}});
    int cut = 0;
    for (std::size_t i = 0; i < kColumns * kColumns; ++i) {
      const float seen = exits.visibility[0][i];
      if (exits.fetches[i] == 33U) {
        ASSERT_EQ(seen, plain.visibility[0][i]) << cascade << ", " << i;
        continue;
      }
      ASSERT_EQ(exits.fetches[i], cascade == 3 ? 5U : 1U) << i;
      ASSERT_EQ(seen, four_taps(frame, cascade, i)) << cascade << ", " << i;
      cut += seen != plain.visibility[0][i] ? 1 : 0;
    }
    EXPECT_GT(cut, 0) << "the definition matters here: " << cascade;
  }
}

INSTANTIATE_TEST_SUITE_P(BothDirections, SingleLoopExits, testing::Bool(), direction_name);
INSTANTIATE_TEST_SUITE_P(BothDirections, SingleLoop, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
