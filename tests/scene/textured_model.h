// Writes a textured square as glTF, and the smallest of picture files, for tests.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/import_fixture.h"

namespace penumbra::scene {

// An uncompressed TGA of 24 bits with rows from the top.
inline std::string tga(int width, const std::vector<std::array<int, 3>>& rgb) {
  const int height = static_cast<int>(rgb.size()) / width;
  std::string file(18, '\0');
  file[2] = 2;
  file[12] = static_cast<char>(width & 255);
  file[13] = static_cast<char>(width >> 8);
  file[14] = static_cast<char>(height & 255);
  file[15] = static_cast<char>(height >> 8);
  file[16] = 24;
  file[17] = 0x20;
  for (const std::array<int, 3>& pixel : rgb) {
    for (const int channel : {2, 1, 0}) file += static_cast<char>(pixel[static_cast<std::size_t>(channel)]);
  }
  return file;
}

// A square of 6 m that lies in y = 0 and looks up, in the file's right-handed space. The texture's first row
// lies at the least z, its first column at the least x. material is more of the material's JSON, images the
// array's content, and node more of the node's JSON.
inline std::string textured_square(const std::string& material, const std::string& images,
                                   const std::string& node = {}) {
  std::vector<float> numbers;
  const std::array<std::array<float, 4>, 4> corner{
      {{-3, 3, 0, 1}, {3, 3, 1, 1}, {3, -3, 1, 0}, {-3, -3, 0, 0}}};  // x, z, u, v
  constexpr std::array order{0, 1, 2, 0, 2, 3};
  for (const int i : order) numbers.insert(numbers.end(), {corner[i][0], 0.0F, corner[i][1]});
  for (const int i : order) numbers.insert(numbers.end(), {corner[i][2], corner[i][3]});
  std::string textures;
  for (std::size_t i = 0, at = 0; (at = images.find('{', at)) != std::string::npos; ++at, ++i) {
    textures += (i == 0 ? "" : ",") + (R"({"source":)" + std::to_string(i) + "}");
  }
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" + node +
         R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],)" +
         R"("materials":[{"name":"painted",)" + material + R"(}],"images":[)" + images + R"(],"textures":[)" +
         textures + R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"},)" +
         R"({"bufferView":1,"componentType":5126,"count":6,"type":"VEC2"}],)" +
         R"("bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":48}],)" +
         R"("buffers":[{"byteLength":120,"uri":"data:application/octet-stream;base64,)" + base64(numbers) +
         "\"}]}";
}

inline const std::string kColourTexture =
    R"("pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0.125,1],"roughnessFactor":0.375,)"
    R"("baseColorTexture":{"index":0}})";

}  // namespace penumbra::scene
