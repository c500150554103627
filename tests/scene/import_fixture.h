// Writes small model files for tests, and tells what import says about them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "input/input_error_matcher.h"
#include "scene/scene.h"

namespace penumbra::scene {

class ImportTest : public testing::Test {
 protected:
  ImportTest() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("penumbra_" + std::string(test->test_suite_name()) + "_" + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~ImportTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::filesystem::path file = folder_ / name;
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }

  static std::string refusal(const std::filesystem::path& file, const ImportOptions& options = {}) {
    return input_error_of([&] { import(file, options); });
  }

  std::filesystem::path folder_;
};

// A tetrahedron with corners at the origin and 1, 2 and 3 units along x, y and z; faces look outward.
inline const std::string kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n"
    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

inline std::string base64(const std::vector<float>& numbers) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
  std::string text;
  for (std::size_t i = 0; i < numbers.size() * 4; i += 3) {  // callers pass multiples of three floats
    const unsigned triple = static_cast<unsigned>(bytes[i] << 16 | bytes[i + 1] << 8 | bytes[i + 2]);
    for (int shift = 18; shift >= 0; shift -= 6) text += digits[triple >> shift & 63];
  }
  return text;
}

// The text of a glTF with embedded positions, drawn by one node without indices; node is more of the node's
// JSON.
inline std::string gltf(const std::vector<float>& positions, const std::string& node = {}) {
  const std::string bytes = std::to_string(positions.size() * 4);
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" + node +
         R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)" +
         R"("componentType":5126,"count":)" + std::to_string(positions.size() / 3) +
         R"(,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":)" + bytes +
         R"(}],"buffers":[{"byteLength":)" + bytes + R"(,"uri":"data:application/octet-stream;base64,)" +
         base64(positions) + "\"}]}";
}

}  // namespace penumbra::scene
