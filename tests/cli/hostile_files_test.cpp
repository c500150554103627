// Models, pictures and shadow functions that crash the libraries which read them, keep them busy for ever or
// fill the memory: the command says which file did it, and how to go on, and ends as it does for other bad
// input.
#include "cli/hostile_shaders.h"
#include "cli/program.h"

namespace penumbra {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kVisibility =
    "float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)";

class HostileFiles : public ProgramTest {
 protected:
  // The limits are in seconds of processor time: `endless` for files that never end; what ends in another way
  // gets a time that a busy machine does not reach either.
  enum class TimeLimit { endless = 2, ample = 60 };

  static platform::ChildResult run_limited(std::vector<std::string> arguments, TimeLimit limit) {
    const std::string seconds = std::to_string(static_cast<int>(limit));
    arguments.insert(arguments.end(), {"--time-limit", seconds, "--memory-limit", "256"});
    return run(std::move(arguments));
  }

  void expect_refused(const platform::ChildResult& result, const std::filesystem::path& file,
                      const std::string& problem, const std::string& remedy) const {
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, StartsWith("penumbra: " + file.string() + ": "));
    EXPECT_THAT(result.errors, HasSubstrs(problem, "\n  " + remedy));
    EXPECT_EQ(result.output, "");
  }

  platform::ChildResult import(const std::filesystem::path& model, TimeLimit limit = TimeLimit::ample) const {
    return run_limited(
        {"render", "--scene", model.string(), "--technique", "hard", "-o", path("out").string()}, limit);
  }

  platform::ChildResult measure(const std::string& adapter, TimeLimit limit = TimeLimit::ample) const {
    return run_limited(words(kSmallStudy, {"--adapter", adapter, "--cache", path("cache").string()}), limit);
  }
};

TEST_F(HostileFiles, AModelWhoseReaderNeverEnds) {
  const auto file = write("endless.ply", "ply\nformat ascii 1.0");
  expect_refused(import(file, TimeLimit::endless), file, "the importer took more than 2 s of CPU time",
                 "reduce it, or raise --time-limit");
}

TEST_F(HostileFiles, AModelThatCrashesItsReader) {
  const auto file = write(
      "crash.dae",
      R"(<COLLADA version="1.4.1"><library_geometries><geometry id="g"><mesh><source id="s">)"
      R"(<float_array id="a" count="-1">0 0 0 1 0 0 0 1 0</float_array><technique_common>)"
      R"(<accessor count="3" source="#a" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>)"
      R"(<param name="Z" type="float"/></accessor></technique_common></source>)"
      R"(<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>)"
      R"(<triangles count="1"><input offset="0" semantic="VERTEX" source="#v"/><p>0 1 2</p></triangles></mesh>)"
      R"(</geometry></library_geometries><library_visual_scenes><visual_scene id="V"><node>)"
      R"(<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>)"
      R"(<scene><instance_visual_scene url="#V"/></scene></COLLADA>)");
  expect_refused(import(file), file, "the importer crashed with SIG", "the file is damaged, or");
}

// The file has an accessor of 200,000,000 positions, of which one is given.
TEST_F(HostileFiles, AModelThatFillsTheMemory) {
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"componentType":5126,)"
      R"("count":200000000,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":0,"componentType":5125},)"
      R"("values":{"bufferView":1}}}],"bufferViews":[{"buffer":0,"byteLength":4},)"
      R"({"buffer":0,"byteOffset":4,"byteLength":12}],"buffers":[{"byteLength":16}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto word = [](std::size_t value) {
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255U);
    return bytes;
  };
  const auto file =
      write("memory.glb", "glTF" + word(2) + word(12 + 8 + json.size() + 8 + 16) + word(json.size()) +
                              "JSON" + json + word(16) + std::string("BIN\0", 4) + std::string(16, '\0'));
  EXPECT_LT(std::filesystem::file_size(file), 768U);
  expect_refused(import(file), file, "the importer took more than 256 MiB of memory",
                 "reduce it, or raise --time-limit");
}

// The picture has 18 bytes that say 8192 x 8192 pixels, as a file and as a model's texture.
TEST_F(HostileFiles, APictureThatFillsTheMemory) {
  std::string tga(18, '\0');
  tga[2] = 10;
  tga[13] = tga[15] = 0x20;
  tga[16] = 24;
  const auto picture = write("vast.tga", tga);
  const auto function =
      write("mine.hlsl", std::string("#include \"Platform/Platform.hlsl\"\nTEXTURE2D(_Mask);\n") +
                             kVisibility + " { return LOAD_TEXTURE2D(_Mask, int2(0, 0)).x; }\n");
  expect_refused(measure("mine=" + function.string() + ";_Mask=" + picture.string()), picture,
                 "the importer took more than 256 MiB of memory", "reduce it");
}

TEST_F(HostileFiles, AFunctionThatCrashesTheCompiler) {
  const auto file = write("mine.hlsl", comma_chain(kVisibility));
  expect_refused(measure("mine=" + file.string()), file, "the compiler crashed with SIGSEGV",
                 "leave out parts of the shader until it compiles");
}

TEST_F(HostileFiles, AFunctionThatNestsTooDeeplyIsRefusedAtItsLine) {
  const auto result = measure("mine=" + write("mine.hlsl", deep_parentheses(kVisibility)).string());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("mine.hlsl:3:1011: error: more than 1000 levels of nesting"));
}

TEST_F(HostileFiles, AFunctionThatNeverCompiles) {
  const auto file = write("mine.hlsl", endless_unrolling(kVisibility));
  expect_refused(measure("mine=" + file.string(), TimeLimit::endless), file, "the compiler took more than ",
                 "simplify the shader, or raise --time-limit and --memory-limit");
}

}  // namespace
}  // namespace penumbra
