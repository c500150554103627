#include <gmock/gmock.h>

#include "has_substrs.h"
#include "scene/content_hash.h"
#include "scene/textured_model.h"

namespace penumbra::scene {
namespace {

using testing::ElementsAre;

const ImportOptions kBare{.ground = false};
const std::string kPicture = tga(2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {9, 8, 7}});

class ImportMaterials : public ImportTest {
 protected:
  Scene with_texture(const std::string& uri) const {
    return import(write("model.gltf", textured_square(kColourTexture, R"({"uri":")" + uri + "\"}")), kBare);
  }
  // Expects an import in plain colour, with one note about the texture.
  static void expect_left_out(const Scene& scene, const std::string& reason) {
    EXPECT_EQ(scene.mesh.triangle_count(), 2U);
    EXPECT_TRUE(scene.textures.empty());
    EXPECT_EQ(scene.materials.at(scene.mesh.material_of(0)).base_colour_texture, -1);
    EXPECT_THAT(scene.notes, ElementsAre(HasSubstrs("model.gltf: ", reason)));
  }
};

TEST_F(ImportMaterials, ReadsColourRoughnessAndTextureOfGltf) {
  write("paint.tga", kPicture);
  const Scene scene = with_texture("paint.tga");
  EXPECT_THAT(scene.notes, ElementsAre());
  const Material& material = scene.materials.at(scene.mesh.material_of(0));
  EXPECT_EQ(material.name, "painted");
  EXPECT_EQ(material.base_colour, glm::vec3(0.5F, 0.25F, 0.125F));
  EXPECT_FLOAT_EQ(material.roughness, 0.375F);
  ASSERT_EQ(material.base_colour_texture, 0);
  EXPECT_EQ(material.normal_texture, -1);
  const Texture& texture = scene.textures.at(0);
  EXPECT_EQ(texture.width, 2);
  EXPECT_EQ(texture.height, 2);
  EXPECT_THAT(std::vector<int>(texture.rgba.begin(), texture.rgba.begin() + 8),
              ElementsAre(255, 0, 0, 255, 0, 255, 0, 255));
}

TEST_F(ImportMaterials, LaysTheTexturesFirstCornerWhereGltfDoes) {
  write("paint.tga", kPicture);
  const Scene scene = with_texture("paint.tga");
  ASSERT_EQ(scene.mesh.uvs.size(), scene.mesh.positions.size());
  for (std::size_t i = 0; i < scene.mesh.uvs.size(); ++i) {
    // x is mirrored and the texture with it: its first column lay at the file's least x.
    EXPECT_EQ(scene.mesh.uvs[i].x, scene.mesh.positions[i].x > 0.0F ? 0.0F : 1.0F);
    EXPECT_EQ(scene.mesh.uvs[i].y, scene.mesh.positions[i].z < 0.0F ? 0.0F : 1.0F);
  }
}

TEST_F(ImportMaterials, GroundUnderATexturedModelKeepsTheMeshWhole) {
  write("paint.tga", kPicture);
  const Scene scene =
      import(write("model.gltf", textured_square(kColourTexture, R"({"uri":"paint.tga"})")), {});
  EXPECT_EQ(scene.mesh.uvs.size(), scene.mesh.positions.size());
  EXPECT_EQ(scene.mesh.triangle_materials.size(), scene.mesh.triangle_count());
  EXPECT_EQ(scene.materials.at(scene.mesh.triangle_materials.back()).name, "concrete");
}

TEST_F(ImportMaterials, ReadsEmbeddedTexturesAndEachFileOnce) {
  std::vector<float> bytes((kPicture.size() + 11) / 12 * 3);
  std::copy(kPicture.begin(), kPicture.end(), reinterpret_cast<char*>(bytes.data()));
  const Scene scene = with_texture("data:image/png;base64," + base64(bytes));
  ASSERT_EQ(scene.textures.size(), 1U);
  EXPECT_EQ(scene.textures[0].width, 2);

  write("paint.tga", kPicture);
  const std::string both = kColourTexture + R"(,"normalTexture":{"index":1})";
  const Scene shared =
      import(write("model.gltf", textured_square(both, R"({"uri":"paint.tga"},{"uri":"paint.tga"})")), kBare);
  EXPECT_EQ(shared.textures.size(), 1U);
  EXPECT_EQ(shared.materials.at(shared.mesh.material_of(0)).normal_texture, 0);
}

TEST_F(ImportMaterials, ReadsNamesWithBlanksAndFoldersInsideTheModels) {
  std::filesystem::create_directories(folder_ / "my textures");
  write("my textures/paint.tga", kPicture);
  EXPECT_EQ(with_texture("my%20textures/paint.tga").textures.size(), 1U);
  EXPECT_EQ(with_texture("./my%20textures/../my%20textures/paint.tga").textures.size(), 1U);
}

TEST_F(ImportMaterials, LeavesOutTexturesThatAreMissingBrokenHugeOrElsewhere) {
  expect_left_out(with_texture("missing.png"), "missing.png: no such file");
  write("broken.png", "no picture at all");
  expect_left_out(with_texture("broken.png"), "broken.png: cannot be read as a picture");
  std::string huge = kPicture;
  huge[13] = huge[15] = 0x40;  // 16,386 pixels per side
  write("huge.tga", huge);
  expect_left_out(with_texture("huge.tga"), "huge.tga");
}

TEST_F(ImportMaterials, TexturesComeFromTheModelsOwnFolderOnly) {
  const std::filesystem::path outside = folder_.string() + "_outside.tga";
  std::ofstream(outside, std::ios::binary) << kPicture;
  expect_left_out(with_texture("../" + outside.filename().string()), "outside the model's folder");
  expect_left_out(with_texture(outside.string()), "outside the model's folder");
  std::filesystem::create_symlink(outside, folder_ / "link.tga");
  expect_left_out(with_texture("link.tga"), "outside the model's folder");
  std::filesystem::remove(outside);
}

TEST_F(ImportMaterials, ReadsColoursAndTexturesOfObj) {
  write("paint.tga", kPicture);
  write("paint.mtl", "newmtl red\nKd 0.5 0.1 0.2\nnewmtl wood\nKd 1 1 1\nmap_Kd paint.tga\n");
  const Scene scene = import(
      write("model.obj",
            "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl red\n"
            "f 1/1 3/2 2/3\nusemtl wood\nf 1/1 2/2 4/3\nf 1/1 4/2 3/3\nf 2/1 3/2 4/3\n"),
      kBare);
  std::map<std::string, int> triangles;
  for (std::size_t i = 0; i < 4; ++i) ++triangles[scene.materials.at(scene.mesh.material_of(i)).name];
  EXPECT_EQ(triangles, (std::map<std::string, int>{{"red", 1}, {"wood", 3}}));
  for (const Material& material : scene.materials) {
    if (material.name == "red") {
      EXPECT_EQ(material.base_colour, glm::vec3(0.5F, 0.1F, 0.2F));
    }
    EXPECT_EQ(material.base_colour_texture, material.name == "wood" ? 0 : -1) << material.name;
  }
  // OBJ counts rows from the bottom: vt 0 0 is the last row's first corner.
  EXPECT_THAT(scene.mesh.uvs, testing::Contains(glm::vec2(0.0F, 1.0F)));
  EXPECT_THAT(scene.mesh.uvs, testing::Not(testing::Contains(glm::vec2(1.0F, 0.0F))));
}

TEST_F(ImportMaterials, PaintChangesNoShadow) {
  write("paint.tga", kPicture);
  const std::string painted = content_hash(with_texture("paint.tga"));
  std::filesystem::remove(folder_ / "paint.tga");
  EXPECT_EQ(content_hash(with_texture("paint.tga")), painted);
}

}  // namespace
}  // namespace penumbra::scene
