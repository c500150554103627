// Manifests become comments, names and texts of C# and HLSL: no text of one can end the line that it is
// written into.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "input/input_error_matcher.h"
#include "input/text_line.h"
#include "shaders/shader_files.h"
#include "techniques/emitted_text.h"
#include "techniques/manifest_reader.h"

namespace penumbra::techniques {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

// The characters are all controls, the separators of lines and paragraphs, and the marks of direction.
std::vector<std::string> leaving_characters() {
  std::vector<std::string> all;
  for (char code = 0; code < 0x20; ++code) all.emplace_back(1, code);
  all.emplace_back("\x7F");
  for (unsigned code = 0x80; code < 0xA0; ++code) all.push_back({'\xC2', static_cast<char>(code)});
  for (const char* more : {"\u2028", "\u2029", "\u061C", "\u200E", "\u200F", "\u202A", "\u202B", "\u202C",
                           "\u202D", "\u202E", "\u2066", "\u2067", "\u2068", "\u2069"})
    all.emplace_back(more);
  return all;
}

std::string file_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// Adds the places of every text and of every key.
void add_places(const Json& value, const Pointer& at, std::vector<Pointer>& texts,
                std::vector<Pointer>& keys) {
  if (value.is_string()) texts.push_back(at);
  if (!value.is_structured()) return;
  for (const auto& member : value.items()) {
    const Pointer place = value.is_array() ? at / std::stoul(member.key()) : at / member.key();
    if (value.is_object()) keys.push_back(place);
    add_places(member.value(), place, texts, keys);
  }
}

// The manifests with the character in each of their texts and keys in turn, or in one in `every` of them,
// from the place `first` on.
std::vector<std::string> with(const std::string& character, const Json& manifest, std::size_t every = 1,
                              std::size_t first = 0) {
  std::vector<Pointer> texts, keys;
  add_places(manifest, Pointer(), texts, keys);
  EXPECT_GT(texts.size(), 5u);
  std::vector<std::string> changed;
  for (std::size_t i = first; i < texts.size(); i += every) {
    Json other = manifest;
    const std::string text = other.at(texts[i]);
    other.at(texts[i]) = text.substr(0, 1) + character + text.substr(std::min<std::size_t>(text.size(), 1));
    changed.push_back(other.dump(1));
  }
  for (std::size_t i = first; i < keys.size(); i += every) {
    Json other = manifest;
    Json& object = other.at(keys[i].parent_pointer());
    object[keys[i].back() + character] = Json(object.at(keys[i].back()));
    object.erase(keys[i].back());
    changed.push_back(other.dump(1));
  }
  return changed;
}

std::string problem_of(const fs::path& manifest) {
  return input_error_of([&] { (void)read_technique_list(manifest); });
}

class EmittedLines : public testing::Test {
 protected:
  EmittedLines() {
    for (const char* name : {"Means.hlsl", "Means.shader", "MeansPasses.hlsl", "Means.technique.json"})
      fs::copy_file(added_ / name, files_.write(name, ""), fs::copy_options::overwrite_existing);
  }

  fs::path added_ = fs::path(PENUMBRA_SOURCE_DIR) / "tests/techniques/added";
  shaders::ShaderFiles files_;
};

TEST_F(EmittedLines, NoTextAndNoKeyOfAManifestLeavesItsLine) {
  const Json manifest = Json::parse(file_text(added_ / "Means.technique.json"));
  ASSERT_EQ(problem_of(files_.path("Means.technique.json")), "no error");
  const auto expect_refused = [&](const std::string& text) {
    const fs::path file = files_.write("Changed.technique.json", text);
    ASSERT_THAT(problem_of(file),
                AllOf(StartsWith(file.string() + ":"), HasSubstr("is one line, without control")))
        << text;
  };
  // One character stands in every place, and every character in some places.
  for (const std::string& text : with("\n", manifest)) expect_refused(text);
  constexpr std::size_t kEvery = 16;
  std::size_t first = 0;
  for (const std::string& character : leaving_characters())
    for (const std::string& text : with(character, manifest, kEvery, first++ % kEvery)) expect_refused(text);
}

TEST_F(EmittedLines, NorDoesOneOfTheLibrarys) {
  std::size_t manifests = 0;
  for (const char* folder : {"ShaderLibrary", "Shaders"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PENUMBRA_SOURCE_DIR) / folder)) {
      if (!entry.path().string().ends_with(manifest_ending)) continue;
      ++manifests;
      EXPECT_NO_THROW((void)open_manifest(entry.path()));
      for (const std::string& text : with("\u2028", Json::parse(file_text(entry.path())), 40))
        ASSERT_THROW((void)open_manifest(files_.write("Changed.technique.json", text)), InputError) << text;
    }
  EXPECT_GT(manifests, 20u);
}

TEST_F(EmittedLines, NorDoesTheNameOfAManifestOrOfItsFiles) {
  const std::string manifest = file_text(added_ / "Means.technique.json");
  for (const std::string& character : leaving_characters()) {
    if (character[0] == 0) continue;  // it ends a name
    const fs::path file = files_.write("Mea" + character + "ns.technique.json", manifest);
    EXPECT_THAT(problem_of(file), HasSubstr("a file's name is one line"));
    fs::remove(file);
  }
  EXPECT_THAT(problem_of(files_.write("Mea\"ns.technique.json", manifest)), HasSubstr("with no quotes"));
}

TEST_F(EmittedLines, ALineDoesNotContinue) {
  for (const char* end : {"\\", "\\  "}) {
    Json manifest = Json::parse(file_text(added_ / "Means.technique.json"));
    manifest["structs"][0]["doc"] = std::string("Of the test.") + end;
    EXPECT_THAT(problem_of(files_.write("Changed.technique.json", manifest.dump(1))),
                HasSubstr("ends in a backslash"));
  }
}

// The text that C# reads as the literal, with its escapes resolved, which are all of the lowest plane.
TEST(CsharpText, EscapesWhatLeavesALine) {
  for (const std::string& character : leaving_characters()) {
    const std::string literal = csharp_text("a" + character + "\"b\\");
    EXPECT_TRUE(is_one_line(literal));
    ASSERT_EQ(literal.size(), 14u) << literal;
    EXPECT_EQ(literal.substr(0, 4), "\"a\\u");
    EXPECT_EQ(std::stoul(literal.substr(4, 4), nullptr, 16), character_at(character, 0).code);
    EXPECT_EQ(literal.substr(8), "\\\"b\\\\\"");
  }
  EXPECT_EQ(csharp_text("\xFF"), "\"\\uFFFD\"");
  EXPECT_EQ(csharp_text("Wood \u00E9t\u00E9 \U0001F333"), "\"Wood \u00E9t\u00E9 \U0001F333\"");
}

TEST(TableRow, AColumnStaysInItsPlace) {
  for (const std::string& character : leaving_characters())
    EXPECT_THROW(TableRow("graph").add("a" + character + "b"), std::invalid_argument);
  EXPECT_EQ(TableRow("graph").add("a \u00E9\"\\").option("b", std::string()).option("c", 2, 1).line(),
            "graph\ta \u00E9\"\\\tc=2\n");
}

}  // namespace
}  // namespace penumbra::techniques
