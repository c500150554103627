// The schema of manifests, and the messages for what breaks it.
#include "techniques/manifest_check.h"

#include <gmock/gmock.h>

#include <functional>

#include "input/input_error_matcher.h"
#include "processor_time.h"
#include "techniques/pass_graph.h"
#include "techniques/texel_formats.h"

namespace penumbra::techniques {
namespace {

using nlohmann::json;

std::string refusal_of(const std::string& manifest) {
  return input_error_of([&] { check_manifest(LocatedJson::parse(manifest, "m")); });
}

// `keys` are the second line.
std::string with_entry(const std::string& keys) {
  return "{\"techniques\": [{\"name\": \"a\", \"title\": \"A\",\n" + keys + "}]}";
}

std::string with_texture(const std::string& keys) {
  return "{\"graphs\": [{\"name\": \"g\", \"textures\": [{\"name\": \"t\",\n" + keys + "}]}]}";
}

std::string with_pass(const std::string& keys) {
  return "{\"graphs\": [{\"name\": \"g\", \"passes\": [{\"name\": \"p\",\n" + keys + "}]}]}";
}

std::string repeated(int count, const std::string& item) {
  std::string text = item;
  for (int i = 1; i < count; ++i) text += "," + item;
  return text;
}

TEST(ManifestCheck, KeywordAdditionalProperties) {
  EXPECT_EQ(refusal_of("{\n  \"techniqes\": []}"),
            "m:2:3: unknown key 'techniqes'\n  did you mean 'techniques'?");
  EXPECT_EQ(refusal_of(with_entry(R"("targets_absent": {"hlsl51": "x"})")),
            "m:2:20: unknown key 'hlsl51'\n  did you mean 'hlsl50'?");
  EXPECT_EQ(refusal_of(with_texture(R"("previous_of": "s", "format": "r8")")),
            "m:2:21: 'format': a texture with \"previous_of\" has the shape of that one\n  leave it out");
  EXPECT_EQ(
      refusal_of(with_pass(R"("kind": "filter", "filter": {"file": "a", "function": "F"}, "reads": {})")),
      "m:2:61: unknown key 'reads'\n  known are: filter kind name runs");
  EXPECT_EQ(refusal_of("{\"techniques\": [{\"nam\": \"a\"}]}"),
            "m:1:18: unknown key 'nam'\n  did you mean 'name'?")
      << "rather than the missing name";
}

TEST(ManifestCheck, KeywordType) {
  EXPECT_EQ(refusal_of("[]"), "m:1:1: 'manifest' must be an object { ... }, found an array");
  EXPECT_EQ(refusal_of(R"({"order": 1.5})"), "m:1:2: 'order' must be a whole number, found 1.5");
  EXPECT_EQ(refusal_of(R"({"order": 1e300})"), "m:1:2: 'order' must be a whole number, found 1e+300");
  EXPECT_EQ(refusal_of(R"({"order": null})"), "m:1:2: 'order' must be a whole number, found null");
  EXPECT_EQ(refusal_of(R"({"techniques": {}})"), "m:1:2: 'techniques' must be an array, found an object");
  EXPECT_EQ(refusal_of(R"({"techniques": [3]})"),
            "m:1:18: each of 'techniques' must be an object { ... }, found a number");
  EXPECT_EQ(refusal_of(with_entry(R"("family": 3)")), "m:2:1: 'family' must be a string, found a number");
  EXPECT_EQ(refusal_of(with_entry(R"("values": {"taps": "3"})")),
            "m:2:12: 'taps' must be a number or an array, found a string");
  EXPECT_EQ(refusal_of(with_pass(R"("kind": "raster", "shader": "a", "writes": {"_T": "t"})")),
            "m:2:34: 'writes' must be an array, found an object");
  EXPECT_EQ(refusal_of(with_pass(R"("kind": "raster", "shader": "a", "each_mip": 1)")),
            "m:2:34: 'each_mip' must be true or false, found a number");
}

TEST(ManifestCheck, KeywordEnum) {
  EXPECT_EQ(refusal_of(with_pass(R"("kind": "castors")")),
            "m:2:1: unknown kind of pass 'castors'\n  did you mean 'casters'?");
  EXPECT_EQ(refusal_of(with_entry(R"("lights": ["spt"])")),
            "m:2:16: unknown kind of light 'spt'\n  did you mean 'spot'?");
  EXPECT_EQ(refusal_of(with_texture(R"("format": "r8", "samples": 3)")),
            "m:2:17: 'samples' must be 1, 2, 4 or 8, not 3");
}

TEST(ManifestCheck, KeywordMinLength) {
  EXPECT_EQ(refusal_of(with_entry(R"("family": "")")), "m:2:1: 'family' is empty");
  EXPECT_EQ(refusal_of(R"({"graphs": [{"name": "g", "parts": [""]}]})"), "m:1:38: one of 'parts' is empty");
}

TEST(ManifestCheck, KeywordPattern) {
  EXPECT_EQ(refusal_of(R"({"structs": [{"name": "a b", "doc": "d", "fields": []}]})"),
            "m:1:15: 'name': 'a b' is not an HLSL identifier");
  EXPECT_EQ(refusal_of(with_entry(R"("keywords": ["_W 1"])")), "m:2:19: 'keywords': '_W 1' is not a keyword");
  EXPECT_EQ(refusal_of(with_entry(R"("source": "ends in \\")")),
            "m:2:1: 'source': 'ends in \\' is blank, or ends in a backslash, which would continue the line");
  EXPECT_EQ(refusal_of(with_entry(R"("source": "  ")")),
            "m:2:1: 'source': '  ' is blank, or ends in a backslash, which would continue the line");
  EXPECT_EQ(
      refusal_of(R"({"techniques": [{"name": "a/b", "title": "A"}]})"),
      "m:1:18: 'name': 'a/b' is no name: a name has letters, digits, '.', '_' and '-', at most 100 of them");
  EXPECT_EQ(refusal_of(R"({"selections": [{"name": "S", "technique": "t", "keyword": "WIDE"}]})"),
            "m:1:49: 'keyword': 'WIDE' is no keyword of the library, which begins with '_PENUMBRA_'");
}

TEST(ManifestCheck, KeywordsMinimumAndMaximum) {
  EXPECT_EQ(refusal_of(with_entry(R"("bias": {"depth": -1, "normal": 0})")),
            "m:2:10: 'depth' must be a number from 0 to 10, not -1");
  EXPECT_EQ(refusal_of(with_entry(R"("cascades": [{"from": 4}])")),
            "m:2:15: 'from' must be a whole number from 1 to 3, not 4");
  EXPECT_EQ(refusal_of(with_texture(R"("format": "r8", "extent": "fixed", "size": [1, 1, 0])")),
            "m:2:52: each of 'size' must be a whole number from 1 to 16384, not 0");
  for (const char* degrees : {"0", "31"})
    EXPECT_EQ(refusal_of(R"({"looks": [{"name": "a", "title": "t", "doc": "d", "maxPenumbraMetres": 1,
"angularDiameterDegrees": )" +
                         std::string(degrees) + "}]}"),
              "m:2:1: 'angularDiameterDegrees' must be a number above 0 and at most 30, not " +
                  std::string(degrees));
}

TEST(ManifestCheck, KeywordsMinItemsMaxItemsAndMaxProperties) {
  EXPECT_EQ(refusal_of(with_entry(R"("lights": [])")), "m:2:1: 'lights' is empty");
  for (const char* range : {"1", "1, 2, 3"})
    EXPECT_THAT(refusal_of(R"({"structs": [{"name": "P", "doc": "d", "fields": [
{"range": [)" + std::string(range) +
                           R"(], "name": "a", "type": "int", "unit": "1", "doc": "d"}]}]})"),
                testing::StartsWith("m:2:2: 'range' must be an array of 2 numbers, found "));
  EXPECT_EQ(refusal_of(with_texture(R"("format": "r8", "extent": "fixed", "size": [1])")),
            "m:2:36: 'size' must be an array of 3 whole numbers, found 1");
  EXPECT_EQ(refusal_of(with_entry(R"("keyword_sets": [[)" + repeated(65, R"("A")") + "]]")),
            "m:2:18: there are 65 keywords of one set, and at most 64 can be checked\n"
            "  leave some out, or split them");
  std::string names = R"("_T": "t")";
  for (int i = 0; i < 128; ++i) names += ", \"_T" + std::to_string(i) + R"(": "t")";
  EXPECT_EQ(refusal_of(with_pass(R"("kind": "raster", "shader": "a", "reads": {)" + names + "}")),
            "m:2:34: there are 129 names of one pass, and at most 128 can be checked\n"
            "  leave some out, or split them");
}

TEST(ManifestCheck, KeywordDependencies) {
  EXPECT_EQ(refusal_of(with_pass(
                R"("kind": "compute", "compute": "a", "groups": {"fixed": [1, 1, 1], "divisor": 2})")),
            "m:2:67: 'divisor' needs 'texels_of', which is missing");
  EXPECT_EQ(refusal_of(R"({"selections": [{"name": "S", "technique": "t", "value": 1, "doc": "d"}]})"),
            "m:1:49: 'value' needs 'title', which is missing");
}

TEST(ManifestCheck, KeywordNot) {
  EXPECT_EQ(refusal_of(with_texture(R"("format": "r8", "size": [1, 1, 1])")),
            "m:2:17: 'size': only the extent \"fixed\" has a size\n  leave it out");
  EXPECT_EQ(refusal_of(with_texture(R"("format": "r8", "extent": "fixed", "size": [1, 1, 1], "divisor": 2)")),
            "m:2:55: 'divisor': a fixed size has no divisor\n  leave it out");
}

TEST(ManifestCheck, KeywordOneOf) {
  for (const char* groups : {"", R"("fixed": [1, 1, 1], "texels_of": "t")"})
    EXPECT_EQ(refusal_of(
                  with_pass(R"("kind": "compute", "compute": "a", "groups": {)" + std::string(groups) + "}")),
              "m:2:36: groups have either \"fixed\" or \"texels_of\"");
}

TEST(ManifestCheck, KeywordRequired) {
  EXPECT_EQ(refusal_of(R"({"techniques": [{"name": "a"}]})"), "m:1:17: 'title' is missing");
  EXPECT_EQ(refusal_of(with_pass(R"("kind": "compute", "compute": "a")")), "m:1:38: 'groups' is missing");
  EXPECT_EQ(refusal_of(with_texture(R"("format": "r8", "extent": "fixed")")), "m:1:40: 'size' is missing");
  EXPECT_EQ(refusal_of(R"({"options": [{"name": "a", "type": "int", "label": "l", "tooltip": "t"}]})"),
            "m:1:14: 'range' is missing");
}

TEST(ManifestCheck, TheFirstOfTheFileIsNamed) {
  EXPECT_EQ(refusal_of("{\"techniques\": [{\"name\": \"a\", \"title\": 1}],\n\"structs\": [{\"name\": 2}]}"),
            "m:1:31: 'title' must be a string, found a number");
}

TEST(ManifestCheck, AnEditorsSchemaMayBeNamed) {
  EXPECT_EQ(refusal_of(R"({"$schema": "technique.schema.json"})"), "no error");
}

TEST(ManifestCheck, HostileManifestsAreRefusedSoon) {
  const double seconds = processor_seconds([] {
    EXPECT_THAT(refusal_of("{\"techniques\": [" + repeated(50'000, "1") + "]}"),
                testing::StartsWith("m:1:2: there are 50000 techniques"));
    EXPECT_THAT(refusal_of("{\"techniques\": [" + repeated(500'000, "1") + "]}"),
                testing::HasSubstr("a manifest has at most 500000 values"));
    EXPECT_THAT(refusal_of(with_entry("\"family\": \"" + std::string(1'000'000, 'a') + "\"")),
                testing::HasSubstr("a text of a manifest has at most 1000 bytes, and this one 1000000"));
    EXPECT_EQ(refusal_of(with_entry("\"family\": \"" + std::string(1000, ' ') + "\"")).substr(0, 22),
              "m:2:1: 'family': '    ");
    EXPECT_THAT(refusal_of("{\"structs\": " + std::string(150, '[') + std::string(150, ']') + "}"),
                testing::HasSubstr("each of 'structs' must be an object"));
    EXPECT_THAT(refusal_of(with_entry(R"("values": {"a": 1e999})")), testing::HasSubstr("number overflow"));
  });
  EXPECT_LT(seconds, 20.0) << "what grows with the square takes minutes";
}

TEST(ManifestSchema, NamesTheProgramsFormatsAndNeeds) {
  const json definitions = json::parse(kTechniqueSchema).at("definitions");
  std::vector<std::string> formats;
  for (const TexelFormat& format : texel_formats()) formats.emplace_back(format.name);
  EXPECT_EQ(definitions.at("/texture/properties/format/enum"_json_pointer), formats);
  std::vector<std::string> needs;
  for (const Need need : all_needs()) needs.emplace_back(name_of(need));
  EXPECT_EQ(definitions.at("/graph/properties/needs/items/enum"_json_pointer), needs);
}

TEST(ManifestSchema, DescribesEveryKey) {
  const json schema = json::parse(kTechniqueSchema);
  std::size_t described = 0;
  const auto check = [&](const std::string& object, const json& properties) {
    for (const auto& [key, rule] : properties.items()) {
      ++described;
      EXPECT_TRUE(rule.contains("description") || rule.contains("$ref")) << object << ": " << key;
    }
  };
  check("manifest", schema.at("properties"));
  for (const auto& [object, definition] : schema.at("definitions").items())
    if (definition.contains("properties")) check(object, definition["properties"]);
  EXPECT_GT(described, 100U);
}

TEST(ManifestSchema, LimitsEveryList) {
  std::size_t lists = 0;
  const std::function<void(const json&, const std::string&)> check = [&](const json& rule,
                                                                         const std::string& at) {
    const bool list = rule.is_object() && rule.value("type", json()) == "array";
    // A draw has at most 8 targets, which the check of graphs says.
    EXPECT_TRUE(!list || at == "/definitions/texts" || rule.contains("maxItems")) << at;
    lists += list ? 1 : 0;
    if (rule.is_structured())
      for (const auto& [key, inner] : rule.items()) check(inner, at + "/" + key);
  };
  check(json::parse(kTechniqueSchema), "");
  EXPECT_GT(lists, 10U);
}

}  // namespace
}  // namespace penumbra::techniques
