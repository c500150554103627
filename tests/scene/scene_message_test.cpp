// Tests what the process that read a model says of it, and what is believed of that.
#include "scene/scene_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

#include "scene/content_hash.h"
#include "scene/textured_model.h"

namespace penumbra::scene {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class SceneMessage : public ImportTest {
 protected:
  Scene textured() const {
    write("paint.tga", tga(2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {9, 8, 7}}));
    return import(write("model.gltf", textured_square(kColourTexture, R"({"uri":"paint.tga"})")), {});
  }
};

TEST_F(SceneMessage, GivesBackAllOfAScene) {
  Scene scene = textured();
  scene.notes = {"one", "two"};
  scene.materials[0].cut_out = CutOut{
      AlphaPattern::leaf, 0, TextureChannel::red, TextureWrap::mirror, TextureWrap::clamp, 0.75F, 0.25F,
      AlphaMode::blended};
  const Scene back = decode_scene(encode(scene));
  EXPECT_EQ(content_hash(back), content_hash(scene));
  EXPECT_EQ(back.name, scene.name);
  EXPECT_EQ(back.description, scene.description);
  EXPECT_EQ(back.notes, scene.notes);
  EXPECT_EQ(back.mesh.uvs, scene.mesh.uvs);
  EXPECT_EQ(back.mesh.triangle_materials, scene.mesh.triangle_materials);
  ASSERT_EQ(back.materials.size(), scene.materials.size());
  for (std::size_t i = 0; i < back.materials.size(); ++i) {
    const Material &a = back.materials[i], &b = scene.materials[i];
    EXPECT_EQ(
        std::tie(a.name, a.base_colour, a.roughness, a.base_colour_texture, a.normal_texture, a.translucency),
        std::tie(b.name, b.base_colour, b.roughness, b.base_colour_texture, b.normal_texture,
                 b.translucency));
    EXPECT_EQ(a.cut_out, b.cut_out);
  }
  ASSERT_EQ(back.textures.size(), 1U);
  EXPECT_EQ(back.textures[0].width, 2);
  EXPECT_EQ(back.textures[0].rgba, scene.textures[0].rgba);
}

TEST_F(SceneMessage, GivesBackAllOptions) {
  platform::ByteWriter out;
  scene::write(
      out,
      {.metres_per_unit = 0.25, .z_up = true, .height_metres = 3.0, .ground = false, .triangle_limit = 77});
  const std::string bytes = out.take();
  platform::ByteReader in(bytes);
  const ImportOptions options = read_import_options(in);
  EXPECT_TRUE(in.exhausted());
  EXPECT_EQ(options.metres_per_unit, 0.25);
  EXPECT_TRUE(options.z_up);
  EXPECT_FALSE(options.minus_z_up);
  EXPECT_EQ(options.height_metres, 3.0);
  EXPECT_FALSE(options.ground);
  EXPECT_EQ(options.triangle_limit, 77U);
}

TEST_F(SceneMessage, TruncatedBytesAreRefusedAtEveryLength) {
  const std::string bytes = encode(textured());
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(decode_scene(std::string_view(bytes).substr(0, length)), std::invalid_argument) << length;
}

TEST_F(SceneMessage, WhatNoImportSaysIsRefused) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> changes{
      {"a triangle with a vertex index out of range",
       [](Scene& scene) { scene.mesh.indices[1] = static_cast<std::uint32_t>(scene.mesh.positions.size()); }},
      {"a triangle with a material index out of range",
       [](Scene& scene) {
         scene.mesh.triangle_materials[0] = static_cast<std::uint16_t>(scene.materials.size());
       }},
      {"arrays differ in length", [](Scene& scene) { scene.mesh.normals.pop_back(); }},
      {"arrays differ in length", [](Scene& scene) { scene.mesh.uvs.pop_back(); }},
      {"arrays differ in length", [](Scene& scene) { scene.mesh.indices.pop_back(); }},
      {"arrays differ in length", [](Scene& scene) { scene.mesh.triangle_materials.pop_back(); }},
      {"a vertex that is not finite", [nan](Scene& scene) { scene.mesh.positions[2].y = nan; }},
      {"a vertex that is not finite", [nan](Scene& scene) { scene.mesh.uvs[2].x = nan; }},
      {"a material with a number that is not finite",
       [nan](Scene& scene) { scene.materials[0].roughness = nan; }},
      {"a material with a texture index out of range",
       [](Scene& scene) { scene.materials[0].base_colour_texture = 1; }},
      {"a material with a texture index out of range",
       [](Scene& scene) { scene.materials[0].normal_texture = -2; }},
      {"a material with a texture index out of range",
       [](Scene& scene) { scene.materials[0].cut_out = CutOut{.texture = 1}; }},
      {"a cut-out without texture coordinates",
       [](Scene& scene) {
         scene.materials[0].cut_out = CutOut{.texture = 0};
         scene.mesh.uvs.clear();
       }},
      {"a cut-out with a number that is not finite",
       [nan](Scene& scene) { scene.materials[0].cut_out = CutOut{.cutoff = nan}; }},
      {"damaged",
       [](Scene& scene) { scene.materials[0].cut_out = CutOut{.pattern = static_cast<AlphaPattern>(6)}; }},
      {"damaged",
       [](Scene& scene) { scene.materials[0].cut_out = CutOut{.wrap_v = static_cast<TextureWrap>(3)}; }},
      {"damaged",
       [](Scene& scene) { scene.materials[0].cut_out = CutOut{.mode = static_cast<AlphaMode>(2)}; }},
      {"without all of its pixels", [](Scene& scene) { scene.textures[0].rgba.pop_back(); }},
      {"a texture whose size is out of range", [](Scene& scene) { scene.textures[0].height = 8193; }},
      {"a texture whose size is out of range", [](Scene& scene) { scene.textures[0].width = -2; }},
      {"a scene without materials", [](Scene& scene) { scene.materials.clear(); }},
      {"a position or direction that is not finite", [nan](Scene& scene) { scene.camera.position.x = nan; }},
      {"a camera value that is not positive and finite", [](Scene& scene) { scene.camera.far_plane = 0.0; }},
  };
  for (const auto& [problem, change] : changes) {
    Scene scene = textured();
    change(scene);
    EXPECT_THAT([&] { decode_scene(encode(scene)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(problem)));
  }
}

}  // namespace
}  // namespace penumbra::scene
