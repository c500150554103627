// Compares cut-outs in the shadow map and before the camera with their alpha in long double at texel and
// pixel centres.
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "scene/cut_out_alpha.h"
#include "scene/frame_scene.h"

namespace penumbra::scene {
namespace {

// The card is a square of 4 m over the ground, with coordinates -1.5 .. 1.5.
struct Card {
  glm::dvec3 centre;
  glm::dvec3 u, v;  // vectors of half of its edges
  static constexpr double half_coordinates = 1.5;

  glm::dvec3 normal() const { return glm::normalize(glm::cross(u, v)); }
  // The coordinates of the texture where a line meets the card's plane.
  LongVec2 uv(const glm::dvec3& start, const glm::dvec3& direction) const {
    const double along = glm::dot(centre - start, normal()) / glm::dot(direction, normal());
    const glm::dvec3 from_centre = start + along * direction - centre;
    return LongVec2(glm::dot(from_centre, u) / glm::dot(u, u), glm::dot(from_centre, v) / glm::dot(v, v)) *
           static_cast<long double>(half_coordinates);
  }
};

const Card kCard{{0.3, 2.0, 6.0}, {2.0, 0.0, 0.3}, {-0.18, 1.4, 1.2}};

// Lower, its plane meets the ground.
bool is_on_card(const glm::dvec3& caster) {
  return std::abs(glm::dot(caster - kCard.centre, kCard.normal())) < 1e-3 && caster.y > 0.1;
}

void add_card(Scene& scene, const Card& card, const CutOut& cut_out) {
  const std::size_t before = scene.mesh.triangle_count();
  add_sheet(scene.mesh, card.centre, card.u, card.v, card.normal());
  scene.mesh.uvs.resize(scene.mesh.positions.size() - 4);
  const auto half = static_cast<float>(Card::half_coordinates);
  for (const glm::vec2& uv : {glm::vec2(-half, -half), {half, -half}, {half, half}, {-half, half}}) {
    scene.mesh.uvs.push_back(uv);
  }
  scene.mesh.triangle_materials.resize(before, 0);
  scene.mesh.triangle_materials.resize(before + 2, add_cut_out(scene, cut_out));
}

enum class Seen { solid, open, undecided };

// margin is that of the coordinates, for snapped vertices and interpolation in floats.
Seen seen_of(const Scene& scene, const CutOut& cut_out, const LongVec2& uv, long double margin) {
  const long double edge = Card::half_coordinates;
  if (std::max(std::abs(uv.x), std::abs(uv.y)) > edge + margin) return Seen::open;
  if (std::max(std::abs(uv.x), std::abs(uv.y)) > edge - margin) return Seen::undecided;
  const bool solid = exact_alpha(scene, cut_out, uv) >= cut_out.cutoff;
  for (int neighbour = 0; neighbour < 9; ++neighbour) {
    const LongVec2 beside(uv.x + margin * (neighbour % 3 - 1),
                          uv.y + margin * (neighbour / 3 - 1));  // NOLINT
    if ((exact_alpha(scene, cut_out, beside) >= cut_out.cutoff) != solid) return Seen::undecided;
  }
  return solid ? Seen::solid : Seen::open;
}

// Expects a picture to show the card where the line through a texel's centre meets a solid place, and at
// least as many of both as are asked for; no more than a part are so near to an edge that they are undecided.
template <typename Coordinates, typename ShowsCard>
void expect_card(const Scene& scene, const NamedCutOut& one, int width, int height, int solid, int open,
                 int part, const Coordinates& coordinates, const ShowsCard& shows_card) {
  int found[3] = {};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const Seen seen = seen_of(scene, one.cut_out, coordinates(column, row), 1e-3L);
      ++found[static_cast<int>(seen)];
      if (seen == Seen::undecided) continue;
      ASSERT_EQ(shows_card(column, row), seen == Seen::solid) << one.name << " at " << column << ", " << row;
    }
  }
  EXPECT_GT(found[0], solid) << one.name;
  EXPECT_GT(found[1], open) << one.name;
  EXPECT_LT(found[2], (found[0] + found[1]) / part) << one.name;
}

Scene card_scene(const CutOut& cut_out) {
  Scene scene = ground_scene();
  scene.camera.forward = {0.05, 0.05, 1.0};
  scene.textures = {odd_texture(), {3, 1, std::vector<std::uint8_t>(12, 255)}};
  // This card is under the ground.
  add_card(scene, {{0.0, -1.0, 9.0}, {0.1, 0.0, 0.0}, {0.0, 0.0, 0.1}}, {.texture = 1});
  add_card(scene, kCard, cut_out);
  return scene;
}

TEST_F(RasterisedFrame, TheMapIsOpenWhereACutOutIs) {
  for (const NamedCutOut& one : cut_outs_of_all_kinds()) {
    for (const bool reversed_z : {false, true}) {
      const Scene scene = card_scene(one.cut_out);
      FrameSettings settings = unbiased_settings(reversed_z, DepthFormat::d32, 1);
      settings.shadows.distance_metres = 12.0;
      const Frame frame = rasterise(*device, scene, settings);
      const glm::dmat4 to_world = glm::inverse(frame.cascades.cascades[0].world_to_shadow);
      const auto at = [&](int column, int row, double depth) {
        return glm::dvec3(to_world * glm::dvec4((column + 0.5) / frame.atlas.width,
                                                (row + 0.5) / frame.atlas.height, depth, 1.0));
      };
      expect_card(
          scene, one, frame.atlas.width, frame.atlas.height, 400, 500, 40,
          [&](int column, int row) {
            return kCard.uv(at(column, row, 0.0), at(column, row, 1.0) - at(column, row, 0.0));
          },
          [&](int column, int row) {
            return is_on_card(
                at(column, row, frame.atlas.depth[texel_index(row, frame.atlas.width, column)]));
          });
    }
  }
}

TEST_F(RasterisedFrame, TheCameraSeesThroughOpenings) {
  for (const NamedCutOut& one : cut_outs_of_all_kinds()) {
    const Scene scene = card_scene(one.cut_out);
    FrameSettings settings = unbiased_settings(true, DepthFormat::d32, 1);
    settings.width = 192;
    settings.height = 108;
    const Receivers seen = rasterise(*device, scene, settings).receivers;
    const glm::dvec3 forward = glm::normalize(scene.camera.forward);
    const glm::dvec3 right = glm::normalize(glm::cross(scene.camera.up, forward));
    const glm::dvec3 up = glm::cross(forward, right);
    const double tan_half = std::tan(0.5 * glm::radians(scene.camera.fov_y_degrees));
    expect_card(
        scene, one, seen.width, seen.height, 300, 300, 20,
        [&](int column, int row) {
          const double x = (2.0 * (column + 0.5) / seen.width - 1.0) * tan_half * scene.camera.aspect;
          const double y = (1.0 - 2.0 * (row + 0.5) / seen.height) * tan_half;
          return kCard.uv(scene.camera.position, forward + right * x + up * y);
        },
        [&](int column, int row) {
          const std::uint32_t triangle = seen.triangle[texel_index(row, seen.width, column)];
          return triangle == 4 || triangle == 5;
        });
  }
}

TEST_F(RasterisedFrame, ACutOutThatIsSolidDrawsWhatNoneDraws) {
  const Scene cut = card_scene({.factor = 1.0F, .cutoff = 1.0F});
  Scene plain = cut;
  for (Material& material : plain.materials) material.cut_out.reset();
  const FrameSettings settings = unbiased_settings(true, DepthFormat::d32);
  const Frame with = rasterise(*device, cut, settings);
  const Frame without = rasterise(*device, plain, settings);
  EXPECT_EQ(with.atlas.texels, without.atlas.texels);
  EXPECT_EQ(with.receivers.position_ws, without.receivers.position_ws);
  EXPECT_EQ(with.receivers.triangle, without.receivers.triangle);
}

}  // namespace
}  // namespace penumbra::scene
