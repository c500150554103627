#include <gmock/gmock.h>

#include <sys/stat.h>

#include "has_substrs.h"
#include "scene/import_fixture.h"

namespace penumbra::scene {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::vector<float> kTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST_F(ImportTest, RefusesWhatIsNotAReadableFile) {
  EXPECT_THAT(refusal(folder_ / "missing.obj"), HasSubstrs("missing.obj", "no such file"));
  EXPECT_THAT(refusal(folder_), HasSubstr("is a folder"));
  EXPECT_THAT(refusal(write("empty.glb", "")), HasSubstr("is empty"));
  EXPECT_THAT(refusal(write("model.txt", "v 0 0 0")), HasSubstrs("not a model format", ".gltf"));
  EXPECT_THAT(refusal(write("model", "v 0 0 0")), HasSubstr("not a model format"));
}

TEST_F(ImportTest, RefusesGarbageOfEveryFormatNamingTheFile) {
  for (const char* extension : {"gltf", "glb", "obj", "3ds", "ply", "stl", "dae", "fbx"}) {
    const auto file =
        write(std::string("garbage.") + extension, "It was the best of times, it was the worst.\n");
    EXPECT_THAT(refusal(file), StartsWith(file.string() + ": ")) << extension;
  }
}

std::string little_endian(const std::vector<std::size_t>& values) {
  std::string bytes;
  for (const std::size_t value : values)
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

TEST_F(ImportTest, RefusesATruncatedGlbAtEveryLength) {
  std::string json = gltf(kTriangle);
  const std::size_t uri = json.find(",\"uri\"");
  json.erase(uri, json.rfind("}]}") - uri);  // the buffer is the binary chunk
  const std::string positions(reinterpret_cast<const char*>(kTriangle.data()),
                              kTriangle.size() * sizeof(float));
  const std::string padded = json + std::string((4 - json.size() % 4) % 4, ' ');
  const std::string glb =
      "glTF" + little_endian({2, 12 + 8 + padded.size() + 8 + positions.size(), padded.size()}) + "JSON" +
      padded + little_endian({positions.size()}) + std::string("BIN\0", 4) + positions;
  EXPECT_EQ(import(write("whole.glb", glb), {.ground = false}).mesh.triangle_count(), 1U);
  for (std::size_t length = 1; length < glb.size(); length += 17) {
    EXPECT_THAT(refusal(write("cut.glb", glb.substr(0, length))), HasSubstr("cannot be read")) << length;
  }
}

// Offsets wrap around in the importer library: it would read what lies before the buffer, or behind it.
TEST_F(ImportTest, RefusesAModelThatReadsOutsideOfItsBuffers) {
  const std::string whole = gltf(kTriangle);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  const std::string view = "\"buffer\":0,", accessor = "\"bufferView\":0,",
                    buffer = "\"buffers\":[{\"byteLength\":36";
  for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
           {with(view, view + "\"byteOffset\":18446744073709551600,"), "'byteOffset' is not a whole number"},
           {with(view, view + "\"byteOffset\":-16,"), "'byteOffset' is not a whole number"},
           {with(view, view + "\"byteOffset\":1.5,"), "'byteOffset' is not a whole number"},
           {with(view, view + "\"byteOffset\":4,"), "the view ends at byte 40 of a buffer of 36 bytes"},
           {with(accessor, accessor + "\"byteOffset\":4,"),
            "the accessor ends at byte 40 of a view of 36 bytes"},
           {with(accessor, accessor + "\"byteOffset\":18446744073709551600,"),
            "'byteOffset' is not a whole number"},
           {with("\"count\":3", "\"count\":4"), "the accessor ends at byte 48"},
           {with("\"count\":3", "\"count\":1099511627776"), "more elements than any buffer"},
           {with(view, view + "\"byteStride\":16,"), "the accessor ends at byte 44"},
           {with(buffer, "\"buffers\":[{\"byteLength\":37"), "has 37 bytes, and has 36"},
           {with(accessor, accessor +
                               "\"sparse\":{\"count\":2,\"indices\":{\"bufferView\":0,\"byteOffset\":32,"
                               "\"componentType\":5125}},"),
            "the accessor ends at byte 40"},
           {with(view, view + "\"buffer\":0,"), "appears twice"}})
    for (const char* name : {"outside.gltf", "outside.dae", "outside.fbx"}) {
      const auto file = write(name, text);
      EXPECT_THAT(refusal(file), AllOf(StartsWith(file.string() + ":1:"), HasSubstr(words)));
    }
  EXPECT_EQ(import(write("whole.gltf", whole), {.ground = false}).mesh.triangle_count(), 1U);
}

// This is glTF 1, whose entries have names in place of numbers.
TEST_F(ImportTest, RefusesAModelOfGltf1ThatReadsOutsideOfItsBuffers) {
  const auto file = write("old.gltf", R"({"asset":{"version":"1.0"},"buffers":{"b":{"byteLength":8,
    "uri":"data:application/octet-stream;base64,AAAAAAAAAAA="}},
    "bufferViews":{"v":{"buffer":"b","byteOffset":4,"byteLength":8}}})");
  EXPECT_THAT(refusal(file),
              AllOf(StartsWith(file.string() + ":3:"), HasSubstr("ends at byte 12 of a buffer of 8")));
}

// A container has a head before its JSON. In glTF 1 the reserved buffer "binary_glTF" is its body.
TEST_F(ImportTest, RefusesAContainerThatReadsOutsideOfItsBuffers) {
  const auto container = [](const std::string& json) {
    return "glTF" + little_endian({1, json.size() + 20, json.size(), 0}) + json;
  };
  const std::string begin = R"({"asset":{"version":"1.0"},"buffers":{")";
  const std::string end =
      R"(":{"byteLength":8,"uri":"data:,"}},"bufferViews":{"v":{"buffer":"binary_glTF","byteLength":9}}})";
  EXPECT_THAT(refusal(write("body.glb", container(begin + "binary_glTF" + end))),
              HasSubstr("ends at byte 9 of a buffer of 8"));
  EXPECT_THAT(refusal(write("other.glb", container(begin + "other" + end))),
              HasSubstr("has 8 bytes, and has 0"));
  EXPECT_THAT(refusal(write("body.gltf", begin + "binary_glTF" + end)), HasSubstr("has 8 bytes, and has 0"));
}

TEST_F(ImportTest, RefusesFilesWithoutTriangles) {
  EXPECT_THAT(refusal(write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\n")), HasSubstr("triangles"));
  EXPECT_THAT(refusal(write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\n")),
              HasSubstr("has only triangles without area"));
}

TEST_F(ImportTest, RefusesVerticesThatAreNotFinite) {
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, infinity, -infinity}) {
    EXPECT_THAT(refusal(write("bad.gltf", gltf({0, 0, 0, 1, 0, 0, 0, bad, 0}))), HasSubstr("is not finite"));
  }
  EXPECT_THAT(refusal(write("overflow.gltf", gltf(kTriangle, R"(,"scale":[1e39,1,1])"))),
              StartsWith((folder_ / "overflow.gltf").string()));
}

TEST_F(ImportTest, RefusesIndicesOutOfRange) {
  const auto file = write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  EXPECT_THAT(refusal(file), StartsWith(file.string() + ": "));
}

// The triangle, whose bytes are in a file.
std::string with_buffer(const std::string& uri) {
  std::string text = gltf(kTriangle);
  const std::size_t begin = text.find("data:"), end = text.find('"', begin);
  return text.replace(begin, end - begin, uri);
}

// The import does so neither by "..", nor by an absolute path, nor through a link.
TEST_F(ImportTest, ReadsNoFileOutsideOfTheModelsFolder) {
  namespace fs = std::filesystem;
  fs::create_directories(folder_ / "model");
  const fs::path bytes = write("secret.bin", std::string(36, '\0'));
  write("model/inside.bin", std::string(36, '\1'));
  fs::create_symlink(bytes, folder_ / "model" / "link.bin");
  const auto model = [&](const std::string& uri) { return write("model/model.gltf", with_buffer(uri)); };
  for (const char* uri : {"../secret.bin", "link.bin"})
    EXPECT_THAT(refusal(model(uri)), HasSubstrs("model.gltf: names the file '", "outside the model's folder"))
        << uri;
  // The importer library looks beneath the model's folder, unless that is the working directory.
  EXPECT_THAT(refusal(model(bytes.string())), HasSubstr("secret.bin"));
  const fs::path before = fs::current_path();
  fs::current_path(folder_ / "model");
  EXPECT_THAT(refusal("model.gltf"), HasSubstr("outside the model's folder"));
  fs::current_path(before);
  EXPECT_THAT(refusal(model("inside.bin")), testing::Not(HasSubstr("outside the model's folder")));
  write("colours.mtl", "newmtl red\nKd 1 0 0\n");
  EXPECT_THAT(refusal(write("model/model.obj", "mtllib ../colours.mtl\nusemtl red\n" + kTetrahedron)),
              HasSubstr("names the file '"));
}

TEST_F(ImportTest, NamesFilesThatAreMissing) {
  const Scene scene = import(write("model.obj", "mtllib paint.mtl\nusemtl red\n" + kTetrahedron), {});
  EXPECT_THAT(scene.notes, testing::Contains(HasSubstr("names the file 'paint.mtl', which is not there")));
  EXPECT_THAT(refusal(write("model.gltf", with_buffer("absent.bin"))),
              HasSubstrs("names the file 'absent.bin', which is not there", "beside the model"));
}

TEST_F(ImportTest, RefusesAModelThatIsAPipe) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe.obj").c_str(), 0600), 0);
  EXPECT_THAT(refusal(folder_ / "pipe.obj"),
              HasSubstrs("pipe.obj: is a device or a pipe", "write its content to a file"));
}

// The buffer would be read until somebody writes into it.
TEST_F(ImportTest, RefusesABufferThatIsAPipe) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe.bin").c_str(), 0600), 0);
  EXPECT_THAT(refusal(write("pipe.gltf", with_buffer("pipe.bin"))), HasSubstr("pipe.bin"));
}

TEST_F(ImportTest, RefusesMoreTrianglesThanTheLimit) {
  // The model's faces share vertices, so that the limit on those is not what is met.
  const auto file =
      write("tetrahedron.ply",
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 2 0\n0 0 "
            "3\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  EXPECT_THAT(refusal(file, {.triangle_limit = 3}), HasSubstrs("has 4 triangles", "limit is 3"));
  EXPECT_EQ(import(file, {.ground = false, .triangle_limit = 4}).mesh.triangle_count(), 4U);
}

TEST_F(ImportTest, RefusesSizesThatCannotBeMetres) {
  const auto file = write("tetrahedron.obj", kTetrahedron);
  EXPECT_THAT(refusal(file, {.metres_per_unit = 1e-5}),
              AllOf(HasSubstr("3e-05 m across"), HasSubstr("give metres per unit: --metres-per-unit 0.01"),
                    testing::Not(HasSubstr("height in metres"))));
  EXPECT_THAT(refusal(file, {.metres_per_unit = 1e5}), HasSubstr("300000 m across"));
  EXPECT_THAT(refusal(file, {.height_metres = 1e5}),
              HasSubstrs("150000 m across", "give another height in metres"));
  const auto flat = write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n");
  EXPECT_THAT(refusal(flat, {.height_metres = 2.0}), HasSubstr("has no height"));
}

TEST_F(ImportTest, RefusesOptionsOutOfRange) {
  const auto file = write("tetrahedron.obj", kTetrahedron);
  for (const double unit : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THAT(refusal(file, {.metres_per_unit = unit}), HasSubstr("metres per unit")) << unit;
  }
  EXPECT_THAT(refusal(file, {.height_metres = -1.0}), HasSubstr("height"));
  EXPECT_THAT(refusal(file, {.z_up = true, .minus_z_up = true}), HasSubstr("not both"));
}

}  // namespace
}  // namespace penumbra::scene
