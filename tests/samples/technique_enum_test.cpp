// The forward shader's enum of techniques, its pragma and the library's own keywords name the same
// techniques. Unity makes the keyword of an enum's entry from the property's name and the entry's.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace penumbra {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(std::string(PENUMBRA_SOURCE_DIR) + "/" + path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string first_match(const std::string& text, const std::string& pattern) {
  std::smatch match;
  EXPECT_TRUE(std::regex_search(text, match, std::regex(pattern))) << pattern;
  return match.empty() ? std::string() : match[1].str();
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::string keyword_of(std::string entry) {
  entry.erase(0, entry.find_first_not_of(' '));
  std::string keyword = "_Penumbra_" + entry;
  for (char& letter : keyword) {
    letter = letter == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  }
  return keyword;
}

std::vector<std::string> keywords_of_enum() {
  std::vector<std::string> keywords;
  const std::string entries = first_match(text_of("Samples~/ForwardShader/Shaders/ForwardLit.shader"),
                                          R"(\[KeywordEnum\(([^)]*)\)\] _Penumbra\()");
  for (const std::string& entry : split(entries, ',')) keywords.push_back(keyword_of(entry));
  return keywords;
}

TEST(TechniqueEnum, ItsKeywordsAreThePragmasInItsOrder) {
  const std::string pragma = first_match(text_of("Samples~/ForwardShader/Shaders/ForwardLit.shader"),
                                         "#pragma shader_feature_local_fragment ([A-Z0-9_ ]*)");
  EXPECT_EQ(keywords_of_enum(), split(pragma, ' '));
}

TEST(TechniqueEnum, ItsKeywordsAreTheLibrarysAndTheFirstIsTheOneWithout) {
  const std::string library = text_of("ShaderLibrary/Pipelines/TechniqueByKeyword.hlsl");
  const std::vector<std::string> keywords = keywords_of_enum();
  ASSERT_EQ(keywords.size(), 6u);
  EXPECT_EQ(keywords[0], "_PENUMBRA_TENT_5X5");
  EXPECT_EQ(library.find(keywords[0]), std::string::npos)
      << "the library knows the keyword by now: say so in the shader";
  for (std::size_t i = 1; i < keywords.size(); ++i) {
    EXPECT_NE(library.find("defined(" + keywords[i] + ")"), std::string::npos) << keywords[i];
  }
}

// A technique of Techniques.txt, as far as its rows say: its keyword, and whether it has passes or sets
// uniforms.
struct Offered {
  std::string keyword;
  bool has_passes = false;
  bool sets_uniforms = false;
};

std::vector<Offered> offered() {
  std::vector<Offered> found;
  for (const std::string& row : split(text_of("Runtime/Techniques/Techniques.txt"), '\n')) {
    if (row.starts_with("technique\t"))
      found.push_back({row.find("keyword=") == std::string::npos ? "" : first_match(row, "keyword=(\\w+)")});
    else if (!found.empty() && row.starts_with("format\t"))
      found.back().has_passes = true;
    else if (!found.empty() && row.starts_with("vector\t"))
      found.back().sets_uniforms = true;
  }
  return found;
}

// Unity draws enums of nine entries at most. So techniques are left out whose parameters ShadowUniforms,
// which a project without the renderer feature calls, does not compute; and those that read maps, which the
// feature's passes make.
TEST(TechniqueEnum, HasAnEntryForEveryTechniqueOfTheRendererFeatureThatShadowUniformsServes) {
  const std::vector<std::string> keywords = keywords_of_enum();
  EXPECT_LE(keywords.size(), 9u);
  std::vector<std::string> served;
  for (const Offered& technique : offered())
    if (!technique.has_passes && !technique.sets_uniforms)
      served.push_back(technique.keyword.empty() ? keywords[0] : technique.keyword);
  EXPECT_THAT(keywords, testing::UnorderedElementsAreArray(served));
}

}  // namespace
}  // namespace penumbra
