#include "scene/cut_out.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "input/input_error_matcher.h"
#include "scene/content_hash.h"
#include "scene/cut_out_alpha.h"

namespace penumbra::scene {
namespace {

using testing::HasSubstr;

// The weights of the triangle's second and third corner are the coordinates -3 .. 5, divided by 8.
Scene one_triangle(const CutOut& cut_out) {
  Scene scene;
  scene.name = "card";
  scene.mesh.positions = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  scene.mesh.normals.assign(3, {0, 0, 1});
  scene.mesh.uvs = {{-3, -3}, {5, -3}, {-3, 5}};
  scene.mesh.indices = {0, 1, 2};
  scene.mesh.triangle_materials = {add_cut_out(scene, cut_out)};
  return scene;
}

bool open_at(const CutOuts& cut_outs, double u, double v) {
  return cut_outs.open(0, static_cast<float>((u + 3.0) / 8.0), static_cast<float>((v + 3.0) / 8.0));
}

double open_share(const CutOut& cut_out) {
  const Scene scene = one_triangle(cut_out);
  const CutOuts cut_outs(scene);
  constexpr int side = 1009;  // a prime, so that no edge of a pattern runs along its points
  int open = 0;
  for (int i = 0; i < side * side; ++i) {
    open += open_at(cut_outs, (i % side + 0.5) / side, (i / side + 0.5) / side) ? 1 : 0;  // NOLINT
  }
  return double(open) / (side * side);
}

TEST(CutOuts, PatternsAreAsOpenAsTheirFormulasSay) {
  constexpr double allowed = 2e-3;  // a wire's width is off by a point's, one of 1009, each way
  for (const float cutoff : {0.5F, 0.75F, 0.25F}) {
    const double wire = (1.0 - cutoff) / 4.0;
    EXPECT_NEAR(open_share({.pattern = AlphaPattern::wire_grid, .cutoff = cutoff}),
                (1.0 - wire) * (1.0 - wire), allowed)
        << cutoff;
    const double radius = 0.375 + (cutoff - 0.5) / 4.0;
    EXPECT_NEAR(open_share({.pattern = AlphaPattern::holes, .cutoff = cutoff}),
                std::numbers::pi * radius * radius, allowed)
        << cutoff;
    if (cutoff < 0.5F) continue;  // a leaf so wide reaches its neighbours
    const double chord = std::sqrt(1.0 - (cutoff - 0.5));
    EXPECT_NEAR(open_share({.pattern = AlphaPattern::leaf, .cutoff = cutoff}),
                1.0 - chord * chord * chord / 3.0, allowed)
        << cutoff;
  }
  EXPECT_NEAR(open_share({.pattern = AlphaPattern::wire_grid}), 49.0 / 64.0, allowed);
  EXPECT_NEAR(open_share({.pattern = AlphaPattern::leaf}), 2.0 / 3.0, allowed);
}

TEST(CutOuts, AreOpenWhereAlphaInLongDoubleIsBelowTheCutoff) {
  for (const NamedCutOut& one : cut_outs_of_all_kinds()) {
    const Scene scene = one_triangle(one.cut_out);
    const CutOuts cut_outs(scene);
    int open = 0, asked = 0, near_the_edge = 0;
    for (int i = 0; i < 60000; ++i) {
      // The places lie in squares of negative and positive coordinates, within the triangle.
      const double u = -2.9 + 3.7 * std::fmod(i * 0.754877666, 1.0);
      const double v = -2.9 + 3.7 * std::fmod(i * 0.569840291, 1.0);
      const long double alpha = exact_alpha(scene, one.cut_out, {u, v});
      if (std::abs(alpha - one.cut_out.cutoff) < 1e-4L) {
        ++near_the_edge;
        continue;
      }
      ++asked;
      open += open_at(cut_outs, u, v) ? 1 : 0;
      ASSERT_EQ(open_at(cut_outs, u, v), alpha < one.cut_out.cutoff) << one.name << " at " << u << ", " << v;
    }
    EXPECT_GT(open, asked / 20) << one.name;
    EXPECT_LT(open, asked - asked / 20) << one.name;
    EXPECT_LT(near_the_edge, 200) << one.name;
  }
}

TEST(CutOuts, BlendedSurfacesStopTheirAlphaAndAreDrawnNowhere) {
  for (const NamedCutOut& one : cut_outs_of_all_kinds()) {
    CutOut blended = one.cut_out;
    blended.mode = AlphaMode::blended;
    const Scene scene = one_triangle(blended), cut = one_triangle(one.cut_out);
    const CutOuts of_blended(scene), of_cut(cut);
    EXPECT_TRUE(of_blended.any_blended() && of_blended.blends(0)) << one.name;
    EXPECT_FALSE(of_cut.any_blended() || of_cut.blends(0)) << one.name;
    for (int i = 0; i < 5000; ++i) {
      const LongVec2 uv(-2.9 + 3.7 * std::fmod(i * 0.754877666, 1.0),
                        -2.9 + 3.7 * std::fmod(i * 0.569840291, 1.0));
      const auto u = static_cast<float>((uv.x + 3) / 8), v = static_cast<float>((uv.y + 3) / 8);
      ASSERT_TRUE(of_blended.open(0, u, v)) << one.name;
      ASSERT_NEAR(of_blended.opacity(0, u, v), double(exact_alpha(scene, blended, uv)), 1e-4) << one.name;
      ASSERT_EQ(of_cut.opacity(0, u, v), of_cut.open(0, u, v) ? 0.0F : 1.0F) << one.name;
    }
  }
  Scene bright = one_triangle({.factor = 1.5F, .mode = AlphaMode::blended});
  EXPECT_EQ(CutOuts(bright).opacity(0, 0.25F, 0.25F), 1.0F);
  bright.materials.back().cut_out->factor = -1.0F;
  EXPECT_EQ(CutOuts(bright).opacity(0, 0.25F, 0.25F), 0.0F);
}

// The integral over a square is taken by points.
TEST(CutOuts, WiresAndSmokeStopAThirdAndATwentiethOfPi) {
  for (const auto& [pattern, mean] :
       {std::pair{AlphaPattern::wire, 1.0 / 3.0}, {AlphaPattern::smoke, std::numbers::pi / 20.0}}) {
    double sum = 0.0;
    constexpr int side = 500;
    for (int i = 0; i < side * side; ++i)
      sum += pattern_alpha(pattern, {(static_cast<float>(i % side) + 0.5F) / side,
                                     (static_cast<float>(i / side) + 0.5F) / side});
    EXPECT_NEAR(sum / (side * side), mean, 1e-4);
  }
}

TEST(CutOuts, AlphaAtTheCutoffIsSolidAndAFactorAloneDecidesAll) {
  Scene scene = one_triangle({.factor = 0.5F, .cutoff = 0.5F});
  EXPECT_FALSE(CutOuts(scene).open(0, 0.25F, 0.25F));
  scene.materials.back().cut_out->factor = 0.49F;
  EXPECT_TRUE(CutOuts(scene).open(0, 0.25F, 0.25F));
  scene.mesh.uvs.clear();  // no such cut-out reads them
  EXPECT_TRUE(CutOuts(scene).open(0, 0.25F, 0.25F));
}

TEST(CutOuts, SeveralTexturesStandApartAndOtherTrianglesAreSolid) {
  Scene scene = one_triangle({.texture = 0});
  scene.textures.push_back({1, 1, {255, 255, 255, 0}});
  scene.mesh.indices = {0, 1, 2, 0, 1, 2, 0, 1, 2};
  const std::uint16_t second = add_cut_out(scene, {.texture = 1});
  scene.mesh.triangle_materials = {0, second, 1};
  const CutOuts cut_outs(scene);
  EXPECT_TRUE(cut_outs.any());
  EXPECT_FALSE(cut_outs.cuts(0));
  EXPECT_TRUE(cut_outs.cuts(1));
  for (int i = 0; i < 100; ++i) {
    const float u = 0.004F * float(i), v = 0.5F - u;
    EXPECT_FALSE(cut_outs.open(0, u, v));
    EXPECT_TRUE(cut_outs.open(1, u, v));
  }
  for (int i = 0; i < 200; ++i) {
    const LongVec2 uv(-2.9L + 0.017L * i, 0.5L - 0.011L * i);
    const long double alpha = exact_texture(scene.textures[0], *scene.materials[1].cut_out, uv);
    if (std::abs(alpha - 0.5L) < 1e-4L) continue;
    EXPECT_EQ(cut_outs.open(2, float((uv.x + 3) / 8), float((uv.y + 3) / 8)), alpha < 0.5L) << i;
  }
  scene.mesh.triangle_materials = {0, 0, 0};
  EXPECT_FALSE(CutOuts(scene).any());
}

TEST(CutOuts, WhatCannotBeReadIsRefusedWithItsName) {
  const auto problem_of = [](const std::function<void(Scene&)>& change) -> std::string {
    Scene scene = one_triangle({.pattern = AlphaPattern::leaf, .texture = 0});
    change(scene);
    return input_error_of([&] { const CutOuts cut_outs(scene); });
  };
  EXPECT_EQ(problem_of([](Scene&) {}), "no error");
  EXPECT_THAT(problem_of([](Scene& s) { s.mesh.uvs.clear(); }),
              HasSubstr("scene 'card': material 'cut out'"));
  EXPECT_THAT(problem_of([](Scene& s) { s.mesh.uvs.pop_back(); }),
              HasSubstr("texture coordinate per vertex"));
  EXPECT_THAT(problem_of([](Scene& s) { s.mesh.uvs[1].y = std::numeric_limits<float>::quiet_NaN(); }),
              HasSubstr("not finite or exceeds a million"));
  EXPECT_THAT(problem_of([](Scene& s) { s.mesh.uvs[1].x = -2e6F; }), HasSubstr("exceeds a million"));
  EXPECT_THAT(problem_of([](Scene& s) { s.materials[1].cut_out->texture = 1; }),
              HasSubstr("with a texture index out of range"));
  EXPECT_THAT(problem_of([](Scene& s) { s.textures[0].rgba.pop_back(); }),
              HasSubstr("whose texture lacks texels"));
  EXPECT_THAT(problem_of([](Scene& s) {
                s.textures[0] = {0, 3, {}};
              }),
              HasSubstr("whose texture lacks texels"));
  EXPECT_THAT(problem_of([](Scene& s) { s.materials[1].cut_out->factor = INFINITY; }), HasSubstr("finite"));
  EXPECT_THAT(problem_of([](Scene& s) { s.materials[1].cut_out->cutoff = NAN; }), HasSubstr("finite"));
  EXPECT_THAT(problem_of([](Scene& s) { s.mesh.triangle_materials[0] = 2; }),
              HasSubstr("a material index out of range"));
  EXPECT_THAT(problem_of([](Scene& s) { s.mesh.triangle_materials.push_back(0); }),
              HasSubstr("one material per triangle"));
}

TEST(CutOuts, EveryPartOfThemNamesTheContent) {
  const Scene scene = one_triangle({.pattern = AlphaPattern::leaf, .texture = 0});
  const std::vector<std::function<void(Scene&)>> changes{
      [](Scene& s) { s.materials[1].cut_out.reset(); },
      [](Scene& s) { s.materials[1].cut_out->pattern = AlphaPattern::holes; },
      [](Scene& s) { s.materials[1].cut_out->texture = -1; },
      [](Scene& s) { s.materials[1].cut_out->channel = TextureChannel::red; },
      [](Scene& s) { s.materials[1].cut_out->wrap_u = TextureWrap::mirror; },
      [](Scene& s) { s.materials[1].cut_out->wrap_v = TextureWrap::clamp; },
      [](Scene& s) { s.materials[1].cut_out->factor = 0.9F; },
      [](Scene& s) { s.materials[1].cut_out->cutoff = 0.4F; },
      [](Scene& s) { s.materials[1].cut_out->mode = AlphaMode::blended; },
      [](Scene& s) { s.textures[0].rgba[7] ^= 1; },
      [](Scene& s) { s.mesh.uvs[2].x += 0.5F; },
  };
  std::set<std::string> hashes{content_hash(scene)};
  for (const auto& change : changes) {
    Scene changed = scene;
    change(changed);
    hashes.insert(content_hash(changed));
  }
  EXPECT_EQ(hashes.size(), changes.size() + 1);
  Scene painted = scene;
  painted.textures[0].rgba[4] ^= 1;  // the cut-out does not read red
  painted.materials[1].base_colour = {1, 0, 0};
  EXPECT_EQ(content_hash(painted), content_hash(scene));
}

}  // namespace
}  // namespace penumbra::scene
