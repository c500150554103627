// Reads from the text of every shader file what all of them keep: no unsafe test for NaN, the depth direction
// and the pipelines each in their one place, includes that go the right way, a header that tells what the
// file is.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace penumbra::shader_library_tests {
namespace {

namespace fs = std::filesystem;

struct ShaderFile {
  std::string name;  // relative to ShaderLibrary/, with forward slashes
  std::string text;
  std::string code;  // text without comments
};

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const std::vector<ShaderFile>& shader_files() {
  static const std::vector<ShaderFile> files = [] {
    const fs::path root = fs::path(PENUMBRA_SOURCE_DIR) / "ShaderLibrary";
    std::vector<ShaderFile> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
      if (entry.path().extension() != ".hlsl") continue;
      ShaderFile file;
      file.name = fs::relative(entry.path(), root).generic_string();
      file.text = read(entry.path());
      file.code = std::regex_replace(file.text, std::regex("//[^\n]*"), "");
      found.push_back(file);
    }
    return found;
  }();
  return files;
}

// The files in which the pattern occurs outside comments.
std::vector<std::string> files_with(const std::string& pattern) {
  const std::regex expression(pattern, std::regex::ECMAScript | std::regex::icase);
  std::vector<std::string> names;
  for (const ShaderFile& file : shader_files()) {
    if (std::regex_search(file.code, expression)) names.push_back(file.name);
  }
  return names;
}

using Names = std::vector<std::string>;

// Emitted tables and structs have a header of their own kind.
bool emitted(const ShaderFile& file) {
  return file.name == "Core/DiskTables.hlsl" || file.name.ends_with("Parameters.hlsl");
}

TEST(ShaderSources, AreAllFound) {
  EXPECT_GE(shader_files().size(), 20u);
}

TEST(ShaderSources, NeverTestForNanInAWayCompilersDrop) {
  EXPECT_EQ(files_with(R"(\bis(nan|inf|finite|normal)\b)"), Names());
  EXPECT_EQ(files_with(R"(\b(\w+(?:\.\w+)*)\s*!=\s*\1\b(?!\s*[.(\[]))"), Names()) << "x != x";
  EXPECT_EQ(files_with(R"(\b(\w+(?:\.\w+)*)\s*==\s*\1\b(?!\s*[.(\[]))"), Names()) << "x == x";
}

TEST(ShaderSources, UseNoClampThatIsUndefinedForNan) {
  EXPECT_EQ(files_with(R"(\b(clamp|saturate)\s*\()"), Names())
      << "write min(max(value, low), high) of a known number";
}

TEST(ShaderSources, TestTheDepthDirectionInOneFile) {
  EXPECT_EQ(files_with("UNITY_REVERSED_Z"), Names{"Core/DepthConvention.hlsl"});
}

TEST(ShaderSources, NamePipelineGlobalsInPipelinesOnly) {
  for (const std::string& name :
       files_with(R"(_MainLight\w+|_CascadeShadow\w+|_HD\w*Shadow\w+|_AdditionalLight\w+|unity_Matrix\w+)")) {
    EXPECT_TRUE(name.starts_with("Pipelines/") || name == "Shadows.hlsl" || name == "SpotShadows.hlsl" ||
                name == "VolumetricShadows.hlsl")
        << name;
  }
  EXPECT_EQ(files_with(R"(_MainLightWorldToShadow|_CascadeShadowSplit\w+)"), Names{"Pipelines/Urp.hlsl"});
  EXPECT_EQ(files_with(R"(_HDShadowDatas|_CascadeShadowAtlas\w+|_Directional(Light|Shadow)\w+)"),
            Names{"Pipelines/Hdrp.hlsl"});
}

TEST(ShaderSources, ReachTexturesThroughMacrosOnly) {
  const std::string method =
      R"(\.\s*(Sample|SampleLevel|SampleCmp\w*|SampleGrad|SampleBias|Load|Gather\w*)\s*\()";
  EXPECT_EQ(files_with(method), Names{"Platform/Platform.hlsl"});
}

TEST(ShaderSources, HaveLinesOfAtMost120Columns) {
  for (const char* folder : {"ShaderLibrary", "Shaders"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PENUMBRA_SOURCE_DIR) / folder)) {
      const fs::path extension = entry.path().extension();
      if (extension != ".hlsl" && extension != ".compute" && extension != ".shader") continue;
      std::istringstream lines(read(entry.path()));
      int number = 0;
      for (std::string line; std::getline(lines, line);) {
        ++number;
        const bool is_directive =
            line.find_first_not_of(' ') == line.find('#');  // not all of them can be broken
        EXPECT_TRUE(line.size() <= 120 || is_directive) << entry.path() << ":" << number;
      }
    }
  }
}

TEST(ShaderSources, KeepCorePure) {
  const std::regex resource(
      R"(\b(TEXTURE2D\w*|SAMPLER\w*|SAMPLE_\w+|LOAD_\w+|GATHER_\w+|cbuffer|CBUFFER_START)\b)");
  const std::regex uniform(R"(\n(float|int|uint)\d?(x\d)?\s+_\w+)");
  for (const ShaderFile& file : shader_files()) {
    if (!file.name.starts_with("Core/")) continue;
    EXPECT_FALSE(std::regex_search(file.code, resource)) << file.name;
    EXPECT_FALSE(std::regex_search(file.code, uniform)) << file.name;
  }
}

TEST(ShaderSources, IncludeOnlyWhatLiesBelow) {
  const std::map<std::string, int> level{{"Platform", 0},  {"Core", 1},    {"Map", 2},    {"Far", 2},
                                         {"Fields", 2},    {"Filters", 3}, {"Screen", 3}, {"ScreenTiles", 4},
                                         {"Pipelines", 4}, {"", 5}};
  const auto level_of = [&level](const fs::path& file) {
    return level.at(file.has_parent_path() ? file.begin()->string() : std::string());
  };
  const std::regex include(R"(#include\s+"([^"]+)\")");
  for (const ShaderFile& file : shader_files()) {
    const fs::path folder = fs::path(file.name).parent_path();
    for (std::sregex_iterator it(file.code.begin(), file.code.end(), include), end; it != end; ++it) {
      const std::string target = (*it)[1];
      if (target.starts_with("Packages/com.unity.")) {
        EXPECT_TRUE(file.name.starts_with("Pipelines/")) << file.name << " includes " << target;
        continue;
      }
      const fs::path included = (folder / target).lexically_normal();
      EXPECT_TRUE(fs::exists(fs::path(PENUMBRA_SOURCE_DIR) / "ShaderLibrary" / included))
          << file.name << ": " << target;
      EXPECT_LE(level_of(included), level_of(file.name)) << file.name << ": " << target;
    }
  }
}

TEST(ShaderSources, OpenWithWhatTheyAre) {
  for (const ShaderFile& file : shader_files()) {
    EXPECT_TRUE(file.text.starts_with("// ")) << file.name;
    if (emitted(file)) continue;
    const std::string header = file.text.substr(0, file.text.find("#ifndef"));
    for (const char* part : {"// Penumbra: ", "// Computes:", "// Source:", "// Inputs:", "// Cost:",
                             "// Guarantees:", "// Use it:"}) {
      EXPECT_NE(header.find(part), std::string::npos) << file.name << " does not say \"" << part << "\"";
    }
  }
}

// A Core function nobody calls from this folder is a Core function nobody tested.
TEST(ShaderSources, HaveATestForEveryCoreFunction) {
  std::string tests;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(fs::path(PENUMBRA_SOURCE_DIR) / "tests" / "ShaderLibrary")) {
    if (entry.path().extension() == ".cpp") tests += read(entry.path());
  }
  const std::regex function(R"(\n(?:float|int|uint|bool|[A-Z]\w+)\d?\s+([A-Z]\w+)\()");
  int functions = 0;
  for (const ShaderFile& file : shader_files()) {
    if (!file.name.starts_with("Core/")) continue;
    for (std::sregex_iterator it(file.code.begin(), file.code.end(), function), end; it != end; ++it) {
      ++functions;
      EXPECT_NE(tests.find((*it)[1].str() + "("), std::string::npos) << file.name << ": " << (*it)[1];
    }
  }
  EXPECT_GE(functions, 45);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
