// Tests which parts of a model's surfaces are open, as its file says it.
#include <gmock/gmock.h>

#include "has_substrs.h"
#include "scene/cut_out.h"
#include "scene/textured_model.h"

namespace penumbra::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const ImportOptions kBare{.ground = false};

// An uncompressed TGA of 32 bits with rows from the top.
std::string tga_with_alpha(int width, const std::vector<std::array<int, 4>>& rgba) {
  std::vector<std::array<int, 3>> opaque(rgba.size());
  std::string file = tga(width, opaque).substr(0, 18);
  file[16] = 32;
  file[17] = 0x28;
  for (const std::array<int, 4>& pixel : rgba) {
    for (const int channel : {2, 1, 0, 3})
      file += static_cast<char>(pixel[static_cast<std::size_t>(channel)]);
  }
  return file;
}

const std::string kLeaf = tga_with_alpha(
    3, {{0, 255, 0, 255}, {0, 255, 0, 0}, {0, 255, 0, 255}, {9, 9, 9, 0}, {9, 9, 9, 255}, {9, 9, 9, 0}});

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

class ImportCutOuts : public ImportTest {
 protected:
  static std::string square(const std::string& more) {
    return textured_square(kColourTexture + more, R"({"uri":"leaf.tga"})");
  }
  Scene imported(const std::string& gltf_text) const { return import(write("model.gltf", gltf_text), kBare); }

  static const std::optional<CutOut>& cut_out_of(const Scene& scene, std::size_t triangle = 0) {
    return scene.materials.at(scene.mesh.material_of(triangle)).cut_out;
  }
};

TEST_F(ImportCutOuts, MaskOfGltfIsTheAlphaOfItsColourTexture) {
  write("leaf.tga", kLeaf);
  const Scene scene = imported(square(R"(,"alphaMode":"MASK","alphaCutoff":0.25)"));
  EXPECT_THAT(scene.notes, IsEmpty());
  const CutOut expected{.texture = 0, .cutoff = 0.25F};
  EXPECT_EQ(cut_out_of(scene), expected);
  const CutOuts cut_outs(scene);
  ASSERT_TRUE(cut_outs.cuts(0) && cut_outs.cuts(1));
  // The places are the centres of the texels, on the triangle that holds them.
  for (int texel = 0; texel < 6; ++texel) {
    const glm::vec2 uv((float(texel % 3) + 0.5F) / 3.0F, texel < 3 ? 0.25F : 0.75F);
    int triangles = 0;
    for (std::size_t triangle = 0; triangle < 2; ++triangle) {
      const std::uint32_t* corner = &scene.mesh.indices[3 * triangle];
      const glm::vec2 a = scene.mesh.uvs[corner[0]], b = scene.mesh.uvs[corner[1]] - a,
                      c = scene.mesh.uvs[corner[2]] - a;
      const float area = b.x * c.y - b.y * c.x;
      const float u = ((uv.x - a.x) * c.y - (uv.y - a.y) * c.x) / area;
      const float v = (b.x * (uv.y - a.y) - b.y * (uv.x - a.x)) / area;
      if (u < -1e-4F || v < -1e-4F || u + v > 1.0001F) continue;
      ++triangles;
      EXPECT_EQ(cut_outs.open(triangle, u, v), texel % 2 == 1) << texel;
    }
    EXPECT_GT(triangles, 0);
  }
}

TEST_F(ImportCutOuts, DefaultsAreGltfs) {
  write("leaf.tga", kLeaf);
  EXPECT_EQ(cut_out_of(imported(square(R"(,"alphaMode":"MASK")"))), CutOut{.texture = 0});
  EXPECT_EQ(cut_out_of(imported(square(R"(,"alphaMode":"OPAQUE","alphaCutoff":0.25)"))), std::nullopt);
  EXPECT_EQ(cut_out_of(imported(square(""))), std::nullopt);
}

TEST_F(ImportCutOuts, TheColoursAlphaCountsWithAndWithoutATexture) {
  write("leaf.tga", kLeaf);
  const std::string thin = replaced(square(R"(,"alphaMode":"MASK")"), "0.125,1]", "0.125,0.75]");
  const CutOut expected{.texture = 0, .factor = 0.75F};
  EXPECT_EQ(cut_out_of(imported(thin)), expected);
  const std::string alone = R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.4]},"alphaMode":"MASK")";
  const Scene scene = imported(textured_square(alone, ""));
  EXPECT_EQ(cut_out_of(scene), CutOut{.factor = 0.4F});
  EXPECT_TRUE(CutOuts(scene).open(0, 0.3F, 0.3F));
}

TEST_F(ImportCutOuts, RepeatModesAreTheSamplers) {
  write("leaf.tga", kLeaf);
  const std::string text =
      replaced(square(R"(,"alphaMode":"MASK")"), R"("textures":[{"source":0})",
               R"("samplers":[{"wrapS":33648,"wrapT":33071}],"textures":[{"source":0,"sampler":0})");
  const CutOut expected{.texture = 0, .wrap_u = TextureWrap::mirror, .wrap_v = TextureWrap::clamp};
  EXPECT_EQ(cut_out_of(imported(text)), expected);
}

TEST_F(ImportCutOuts, WithoutItsTextureASurfaceIsSolidAndSaysSo) {
  const auto expect_solid = [&](const std::string& reason) {
    const Scene scene = imported(square(R"(,"alphaMode":"MASK")"));
    EXPECT_EQ(cut_out_of(scene), std::nullopt);
    EXPECT_THAT(
        scene.notes,
        ElementsAre(HasSubstrs("model.gltf: ", "leaf.tga", reason),
                    HasSubstr("material 'painted': without the texture that cuts it out it is solid")));
  };
  expect_solid("no such file");
  write("leaf.tga", kLeaf.substr(0, 11));
  expect_solid("cannot be read as a picture");
}

TEST_F(ImportCutOuts, BlendOfGltfIsBlendedAndNotedOnce) {
  write("leaf.tga", kLeaf);
  const Scene scene = imported(square(R"(,"alphaMode":"BLEND")"));
  const CutOut expected{.texture = 0, .mode = AlphaMode::blended};
  EXPECT_EQ(cut_out_of(scene), expected);
  EXPECT_TRUE(CutOuts(scene).blends(0));
  EXPECT_THAT(scene.notes, ElementsAre(HasSubstr("1 of its materials, 'painted' for one, are blended")));
}

TEST_F(ImportCutOuts, BlendWithoutAlphaIsSolid) {
  write("leaf.tga", tga_with_alpha(1, {{0, 255, 0, 255}}));
  const Scene scene = imported(square(R"(,"alphaMode":"BLEND")"));
  EXPECT_EQ(cut_out_of(scene), std::nullopt);
  EXPECT_THAT(scene.notes, IsEmpty());
}

TEST_F(ImportCutOuts, AMeshWithoutCoordinatesIsSolid) {
  write("leaf.tga", kLeaf);
  const Scene scene = imported(
      replaced(square(R"(,"alphaMode":"MASK")"), R"("POSITION":0,"TEXCOORD_0":1)", R"("POSITION":0)"));
  EXPECT_EQ(cut_out_of(scene), std::nullopt);
  EXPECT_FALSE(CutOuts(scene).any());
  EXPECT_THAT(scene.notes, ElementsAre(HasSubstr("is solid: material 'painted' cuts it out")));
}

TEST_F(ImportCutOuts, ATransformOfCoordinatesIsNoted) {
  write("leaf.tga", kLeaf);
  const std::string text =
      replaced(square(R"(,"alphaMode":"MASK")"), R"("baseColorTexture":{"index":0})",
               R"("baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"scale":[2,2]}}})");
  const Scene scene =
      imported(replaced(text, R"({"asset")", R"({"extensionsUsed":["KHR_texture_transform"],"asset")"));
  EXPECT_TRUE(cut_out_of(scene).has_value());
  EXPECT_THAT(scene.notes, ElementsAre(HasSubstr("the transform of its coordinates is not read")));
}

TEST_F(ImportCutOuts, CoordinatesOfTheCutOutComeFirst) {
  write("leaf.tga", kLeaf);
  const std::string text =
      replaced(square(R"(,"alphaMode":"MASK","normalTexture":{"index":0,"texCoord":0})"),
               R"("baseColorTexture":{"index":0})", R"("baseColorTexture":{"index":0,"texCoord":1})");
  const Scene scene = imported(replaced(text, R"("TEXCOORD_0":1)", R"("TEXCOORD_0":1,"TEXCOORD_1":1)"));
  EXPECT_EQ(cut_out_of(scene), CutOut{.texture = 0});
  EXPECT_EQ(scene.materials.at(scene.mesh.material_of(0)).normal_texture, -1);
  EXPECT_THAT(scene.notes, ElementsAre(HasSubstr("its normal map uses other texture coordinates")));
}

class ImportOpacityMaps : public ImportCutOuts {
 protected:
  // A card with the material's lines.
  Scene card(const std::string& material) const {
    write("card.mtl", "newmtl leaf\nKd 1 1 1\n" + material);
    return import(
        write("card.obj",
              "mtllib card.mtl\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
              "usemtl leaf\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"),
        kBare);
  }
};

TEST_F(ImportOpacityMaps, OfObjAreReadByTheirAlphaElseTheirRed) {
  write("mask.tga", tga(2, {{255, 255, 255}, {0, 0, 0}, {0, 0, 0}, {255, 255, 255}}));
  write("leaf.tga", kLeaf);
  const CutOut grey{.texture = 0, .channel = TextureChannel::red};
  EXPECT_EQ(cut_out_of(card("map_d mask.tga\n")), grey);
  EXPECT_EQ(cut_out_of(card("map_d leaf.tga\n")), CutOut{.texture = 0});
  const Scene both = card("map_Kd leaf.tga\nmap_d leaf.tga\n");
  EXPECT_EQ(both.textures.size(), 1U);
  EXPECT_EQ(cut_out_of(both), CutOut{.texture = 0});
  EXPECT_EQ(cut_out_of(card("map_Kd leaf.tga\n")), std::nullopt) << "alpha of a colour alone says nothing";
  EXPECT_THAT(both.notes, IsEmpty());
}

TEST_F(ImportOpacityMaps, MayBeClampedAndMissing) {
  write("leaf.tga", kLeaf);
  const CutOut clamped{.texture = 0, .wrap_u = TextureWrap::clamp, .wrap_v = TextureWrap::clamp};
  EXPECT_EQ(cut_out_of(card("map_d -clamp on leaf.tga\n")), clamped);
  const Scene missing = card("map_d none.tga\n");
  EXPECT_EQ(cut_out_of(missing), std::nullopt);
  EXPECT_THAT(missing.notes, ElementsAre(HasSubstr("none.tga: no such file"), HasSubstr("it is solid")));
}

// (0, 0) of a texture is its first row's first corner. Where all vertices are there, they still have
// coordinates.
TEST_F(ImportOpacityMaps, AreReadAtTheirCornerToo) {
  write("leaf.tga", kLeaf);
  write("card.mtl", "newmtl leaf\nKd 1 1 1\nmap_d leaf.tga\n");
  const Scene scene = import(
      write("card.obj", "mtllib card.mtl\nv 0 0 0\nv 1 0 0\nv 1 2 0\nvt 0 1\nusemtl leaf\nf 1/1 2/1 3/1\n"),
      kBare);
  ASSERT_EQ(scene.mesh.uvs.size(), 3U);
  EXPECT_TRUE(CutOuts(scene).cuts(0));
}

}  // namespace
}  // namespace penumbra::scene
