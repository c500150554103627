// Mirrors a file's tangent space into Unity's: the normal map has a known answer.
#include <gtest/gtest.h>

#include "lighting/hand_made.h"
#include "lighting/seen_materials.h"
#include "scene/textured_model.h"

namespace penumbra::lighting {
namespace {

class ImportedTextures : public scene::ImportTest {
 protected:
  SeenMaterials seen(const std::string& material, const std::string& node = {}) const {
    scene::Scene scene = hand_made::looking_down(10.0, {0, 1, 0});
    const scene::Scene square =
        scene::import(write("square.gltf", scene::textured_square(material, R"({"uri":"map.tga"})", node)),
                      {.ground = false});
    scene.mesh = square.mesh;
    scene.materials = square.materials;
    scene.textures = square.textures;
    return seen_materials(scene, hand_made::frame_of(scene, 8, 8));
  }
  glm::vec3 normal(int x, int y, const std::string& node = {}) const {
    write("map.tga", scene::tga(1, {{x, y, 218}}));
    return seen(R"("normalTexture":{"index":0})", node).points[27].normal;
  }
};

// In the file the texture's right is +x and its up is -z; x is mirrored on the way in.
TEST_F(ImportedTextures, NormalMapLeansTheMirroredWay) {
  EXPECT_LT(normal(218, 128).x, -0.6F);
  EXPECT_NEAR(normal(218, 128).z, 0.0F, 0.01F);
  EXPECT_LT(normal(128, 218).z, -0.6F);
  EXPECT_NEAR(normal(128, 218).x, 0.0F, 0.01F);
  EXPECT_GT(normal(218, 218).y, 0.4F);
}

TEST_F(ImportedTextures, NodeThatMirrorsMirrorsTheMapsLean) {
  const std::string mirrored = R"(,"scale":[-1,1,1])";
  EXPECT_GT(normal(218, 128, mirrored).x, 0.6F);
  EXPECT_LT(normal(128, 218, mirrored).z, -0.6F);
  EXPECT_GT(normal(128, 218, mirrored).y, 0.6F);
}

TEST_F(ImportedTextures, PictureLiesAsInTheFileSeenFromAbove) {
  write("map.tga", scene::tga(2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {0, 0, 0}}));
  const SeenMaterials picture = seen(R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})");
  // Rows of the frame go from +Z down to -Z; columns from -X to +X.
  const auto colour = [&](float x, float z) {
    const SurfacePoint* nearest = nullptr;
    for (std::size_t i = 0; i < picture.points.size(); ++i) {
      const glm::vec3 p = picture.points[i].position;
      if (picture.seen[i] != 0 && p.x * x > 0.0F && p.z * z > 0.0F) nearest = &picture.points[i];
    }
    return nearest == nullptr ? glm::vec3(-1.0F) : nearest->base_colour;
  };
  const glm::vec3 first = colour(1, -1), second = colour(-1, -1), third = colour(1, 1);
  // The colour at the file's least x and least z is red.
  EXPECT_GT(first.r, 2.0F * std::max(first.g, first.b));
  EXPECT_GT(second.g, 2.0F * std::max(second.r, second.b));  // the colour beside it is green
  EXPECT_GT(third.b, 2.0F * std::max(third.r, third.g));     // the colour below is blue
}

}  // namespace
}  // namespace penumbra::lighting
