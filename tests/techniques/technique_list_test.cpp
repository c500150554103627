#include "techniques/technique_list.h"

#include <gmock/gmock.h>

#include <map>

#include "processor_time.h"
#include "sanitized.h"
#include "techniques/golden_json.h"
#include "techniques/manifest_test.h"
#include "techniques/settings_emit.h"
#include "techniques/technique_call.h"

namespace penumbra::techniques {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* good = R"({
  "structs": [
    {"name": "BoxParameters", "doc": "Even kernel.", "fields": [
      {"name": "taps", "type": "int", "unit": "taps", "doc": "per side", "range": [1, 9]},
      {"name": "scale", "type": "float2", "unit": "1", "doc": "stretch"}]}
  ],
  "techniques": [
    {"name": "box-3", "title": "Box", "family": "box", "source": "Nobody 1900",
     "filter": {"file": "Box.hlsl", "function": "FilterBox",
                "arguments": ["shadowMap", "pointSampler"], "parameters": "BoxParameters"},
     "values": {"taps": 3, "scale": [1.0, 0.5]},
     "keywords": ["_WIDE"], "keyword_sets": [[], ["UNITY_REVERSED_Z"]],
     "unlimited": {"taps": 4096}, "targets_absent": {"hlsl50": "too long"}}
  ]
})";

class TechniqueListTest : public ManifestTest {
 protected:
  TechniqueListTest() : ManifestTest("box.technique.json", {"Box.hlsl"}) {}

  static std::string with(const std::string& from, const std::string& to) { return replaced(good, from, to); }
};

TEST_F(TechniqueListTest, ATechniqueSaysTheBiasItShouldHave) {
  EXPECT_EQ(read(good).techniques[0].bias, TechniqueBias{});
  const std::string text =
      with(R"("values")", R"("bias": {"depth": 1, "normal": 0.5, "soft_quality": "high"}, "values")");
  EXPECT_EQ(read(text).techniques[0].bias, (TechniqueBias{1.0, 0.5, "high"}));
  EXPECT_EQ(read(with(R"("values")", R"("bias": {"depth": 0, "normal": 0, "slope": 0.5}, "values")"))
                .techniques[0]
                .bias,
            (TechniqueBias{0.0, 0.0, "medium", 0.5}));
}

TEST_F(TechniqueListTest, ATechniqueSaysWhomItIsFor) {
  EXPECT_EQ(read(good).techniques[0].use_when, "");
  const Technique technique =
      read(with(R"("values")", R"("use_when": "few fetches", "not_when": "wide discs", "values")"))
          .techniques[0];
  EXPECT_EQ(technique.use_when, "few fetches");
  EXPECT_EQ(technique.not_when, "wide discs");
}

TEST_F(TechniqueListTest, ATechniqueSaysWhichLightsItIsFor) {
  EXPECT_EQ(read(good).techniques[0].lights, std::vector<LightKind>{LightKind::directional});
  const Technique both =
      read(with(R"("values")", R"("lights": ["directional", "spot"], "values")")).techniques[0];
  EXPECT_TRUE(both.is_for(LightKind::spot));
  EXPECT_TRUE(both.is_for(LightKind::directional));
  EXPECT_FALSE(read(good).techniques[0].is_for(LightKind::spot));
  refuse(good, R"("values")", R"("lights": ["spot"], "cascades": [{"from": 1, "values": {"taps": 1}}],
     "values")",
         "'box-3' has passes or rules for cascades; under a spot light only filters alone run");
}

TEST_F(TechniqueListTest, OnlyAFilterForSpotLightsAloneTakesTheSpotLight) {
  std::string text = with(R"("pointSampler"])", R"("pointSampler", "spotLight"])");
  const std::string values = R"("values")";
  text.insert(text.find(values), R"("lights": ["spot"], )");
  const TechniqueList list = read(text);
  const TechniqueCall call = emit_technique_call(list, list.techniques[0]);
  EXPECT_THAT(call.declarations, HasSubstr("float4 _PenumbraSpotLight;\n"));
  EXPECT_THAT(call.function,
              HasSubstr("sampler_PointClamp, BoundedSpotMap(_PenumbraSpotLight), receiver, tile"));
  refuse(good, R"("pointSampler"])", R"("pointSampler", "spotLight"])",
         "the filter of 'box-3' takes the spot light, which the sun is not");
}

TEST_F(TechniqueListTest, ReadsWhatIsThere) {
  const TechniqueList list = read(good);
  ASSERT_EQ(list.techniques.size(), 1U);
  const Technique& box = list.find("box-3");
  EXPECT_EQ(box.values.at("taps"), std::vector<double>{3.0});
  EXPECT_EQ(box.values.at("scale"), (std::vector<double>{1.0, 0.5}));
  EXPECT_EQ(box.keyword_sets, (std::vector<std::vector<std::string>>{{}, {"UNITY_REVERSED_Z"}}));
  EXPECT_EQ(box.keywords, std::vector<std::string>{"_WIDE"});
  EXPECT_EQ(box.unlimited.at("taps"), 4096.0);
  EXPECT_EQ(box.targets_absent.at("hlsl50"), "too long");
  EXPECT_EQ(box.file(), "Box.hlsl");
  EXPECT_FALSE(box.graph.over_screen());
  ASSERT_NE(list.find_struct("BoxParameters"), nullptr);
  const std::vector<ParameterField>& fields = list.find_struct("BoxParameters")->fields;
  EXPECT_EQ(fields[1].type, "float2");
  ASSERT_TRUE(fields[0].range);
  EXPECT_EQ(fields[0].range->smallest, 1.0);
  EXPECT_EQ(fields[0].range->largest, 9.0);
  EXPECT_FALSE(fields[1].range);
}

TEST_F(TechniqueListTest, UnlimitedExceedsTheUpperEndAlone) {
  const std::string taps = R"("taps": 4096)";
  refuse(good, taps, R"("taps": 1.5)", "'taps' is a whole number");
  refuse(good, taps, R"("taps": -100)", "'taps' is a whole number from 1 to ");
  refuse(good, taps, R"("taps": 16777217)", "'taps' is a whole number");
  refuse(good, taps, R"("scale": 1)", "'scale' is a float2");
}

TEST_F(TechniqueListTest, UsualKeywordSetsAreBothDirectionsOfDepthAndUnlimitedSamples) {
  const std::string text = with(R"(, "keyword_sets": [[], ["UNITY_REVERSED_Z"]])", "");
  EXPECT_THAT(read(text).techniques[0].keyword_sets,
              ElementsAre(std::vector<std::string>{}, std::vector<std::string>{"UNITY_REVERSED_Z"},
                          std::vector<std::string>{"PENUMBRA_UNLIMITED"},
                          std::vector<std::string>{"UNITY_REVERSED_Z", "PENUMBRA_UNLIMITED"}));
}

TEST_F(TechniqueListTest, AnEntrySaysOnlyWhatDiffersFromTheDefaults) {
  const TechniqueList list = read(R"({
    "structs": [{"name": "P", "doc": "d", "fields": [
      {"name": "taps", "type": "int", "unit": "1", "doc": "d", "range": [1, 9], "default": 5},
      {"name": "width", "type": "float", "unit": "m", "doc": "d"}]}],
    "defaults": {"family": "f", "source": "s", "filter": {"file": "Box.hlsl", "function": "F", "parameters": "P"},
                 "values": {"width": 2}, "keywords": ["_K"]},
    "techniques": [{"name": "a", "title": "A"},
                   {"name": "b", "title": "B", "family": "g", "values": {"taps": 3}, "keywords": []},
                   {"name": "c", "title": "C", "values": {"width": 4}}]})");
  const Technique& a = list.find("a");
  EXPECT_EQ(a.family, "f");
  EXPECT_EQ(a.source, "s");
  EXPECT_EQ(a.values, (std::map<std::string, std::vector<double>>{{"taps", {5.0}}, {"width", {2.0}}}));
  EXPECT_EQ(a.keywords, std::vector<std::string>{"_K"});
  EXPECT_EQ(a.graph.filter()->arguments, std::vector<std::string>{"shadowMap"});
  const Technique& b = list.find("b");
  EXPECT_EQ(b.family, "g");
  EXPECT_EQ(b.values.at("taps"), std::vector<double>{3.0});
  EXPECT_EQ(b.values.at("width"), std::vector<double>{2.0});
  EXPECT_TRUE(b.keywords.empty());
  EXPECT_EQ(list.find("c").values.at("width"), std::vector<double>{4.0});
}

TEST_F(TechniqueListTest, WrongDefaultsAreNamedWithTheirPlace) {
  refuse(good, "\"techniques\"", "\"defaults\": {\"values\": {\"tups\": 1}}, \"techniques\"",
         "unknown key 'tups'");
  refuse(good, "\"range\": [1, 9]", "\"range\": [1, 9], \"default\": 11",
         "'taps' is a whole number from 1 to 9, not 11");
}

TEST_F(TechniqueListTest, WrongEntriesAreNamedWithTheirPlaceAndARemedy) {
  refuse(good, "\"family\"", "\"famly\"", "box.technique.json:8:", "unknown key 'famly'",
         "did you mean 'family'?");
  refuse(good, R"("family": "box", )", "", "box.technique.json:8:", "'family' is missing",
         "give it here or in \"defaults\"");
  refuse(good, "\"parameters\": \"BoxParameters\"", "\"parameters\": \"BoxParameter\"",
         "box.technique.json:10:", "unknown struct 'BoxParameter'", "did you mean 'BoxParameters'?");
  refuse(good, "\"taps\": 3", "\"tap\": 3", "no value for 'taps' of 'box-3'");
  refuse(good, "\"taps\": 3", "\"taps\": 3, \"radius\": 1", "unknown key 'radius'");
  refuse(good, "\"taps\": 3", "\"taps\": 2.5", "must be a whole number");
  refuse(good, "\"taps\": 3", "\"taps\": 11", "'taps' is a whole number from 1 to 9, not 11");
  refuse(good, "[1, 9]", "[9, 1]", "the smallest value comes after the largest");
  refuse(good, "[1.0, 0.5]", "[1.0]", "array of 2 numbers");
  refuse(good, "Box.hlsl", "Bax.hlsl", "there is no file");
  refuse(good, "Box.hlsl", "/etc/passwd", "'/etc/passwd' lies outside of",
         "keep a technique's files in the folder");
  refuse(good, "\"pointSampler\"", "\"pointSamplr\"", "'pointSamplr' is no argument of a filter");
  refuse(good, "\"taps\": 4096", "\"tops\": 4096", "did you mean 'taps'?");
  refuse(good, "\"name\": \"scale\"", "\"name\": \"taps\"", "two fields 'taps'");
}

TEST_F(TechniqueListTest, WhatIsEmittedIsPlainText) {
  refuse(good, "Even kernel.", "x\\n#error", "'doc' is one line");
  refuse(good, "\"Box\"", "\"B\\u001b\"", "'title' is one line");
  refuse(good, "\"name\": \"scale\"", "\"name\": \"class\"", "'class' is a word of C#");
  refuse(good, "\"name\": \"scale\"", "\"name\": \"Vector0\"", "of the emitted struct");
  refuse(good, "[1, 9]", "[1, 1e18]", "'taps' is a whole number");
  refuse(good, "[1.0, 0.5]", "[1.0, 1e300]", "'scale' is a number");
  refuse(good, "\"_WIDE\"", "\"UNITY_REVERSED_Z\"", "is the platform's to define");
  refuse(good, "Box.hlsl", "a\\\\b.hlsl", "no backslashes");
  refuse(good, "\"filter\"", "\"graph\": \"g\", \"filter\"", "has both a graph and a filter");
  EXPECT_THAT(refusal_of(R"({"techniques": [{"name": "a", "title": "A", "family": "f", "source": "s"}]})"),
              HasSubstrs("box.technique.json:1:", "'a' has neither a filter nor a graph"));
}

TEST_F(TechniqueListTest, AManifestIsNamedFromItsOwnFolder) {
  files_.write("box.technique.json", good);
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(files_.path("."));
  EXPECT_EQ(read_technique_list("box.technique.json").techniques.size(), 1U);
  std::filesystem::current_path(before);
}

TEST_F(TechniqueListTest, NamesMayNotRepeat) {
  std::string text = good;
  const std::size_t start = text.find("    {\"name\": \"box-3\"");
  const std::size_t end = text.find("  ]\n}", start);
  const std::string technique = text.substr(start, end - start);
  EXPECT_THAT(refusal_of(text.insert(end, "," + technique)),
              HasSubstrs("two techniques 'box-3'", "the other one is at "));
}

// The text of a manifest of so many techniques, after one that has a graph of some passes.
std::string techniques_of_one_graph(int count) {
  std::string text = R"({"graphs": [{"name": "blurs", "textures": [)";
  for (int i = 0; i < 7; ++i)
    text += R"({"name": "t)" + std::to_string(i) + R"(", "extent": "map", "divisor": 4, "format": "r32f"},)";
  text += R"({"name": "last", "extent": "map", "divisor": 4, "format": "r32f"}], "passes": [)";
  for (int i = 0; i < 8; ++i)
    text += R"({"name": "P)" + std::to_string(i) +
            R"(", "kind": "raster", "shader": "Box.hlsl", "runs": "cascade",)" +
            (i == 0 ? std::string() : R"("reads": {"_In": "t)" + std::to_string(i - 1) + R"("},)") +
            R"("writes": [")" + (i == 7 ? std::string("last") : "t" + std::to_string(i)) + R"("]},)";
  text += R"({"name": "filter", "kind": "filter",
              "filter": {"file": "Box.hlsl", "function": "F", "arguments": ["last", "linearSampler"]}}]}],
    "defaults": {"family": "f", "source": "s", "graph": "blurs"}, "techniques": [)";
  for (int i = 0; i < count; ++i)
    text += (i == 0 ? "" : ",\n") + std::string(R"({"name": "t)") + std::to_string(i) + R"(", "title": "T"})";
  return text + "]}";
}

TEST_F(TechniqueListTest, ManyTechniquesAreReadInSecondsAndVeryManyAreRefused) {
  const double seconds = processor_seconds([&] {
    const TechniqueList list = read(techniques_of_one_graph(3000 / sanitizer_reduction));
    EXPECT_EQ(list.techniques.size(), 3000U / sanitizer_reduction);
    EXPECT_EQ(list.techniques.back().graph.passes.size(), 9U);
    EXPECT_THAT(refusal_of(techniques_of_one_graph(100'000)),
                HasSubstrs("box.technique.json:", "there are 100000 techniques, and at most 4096"));
  });
  EXPECT_LT(seconds, 5.0) << "what grows with the square takes minutes";
  EXPECT_THAT(refusal_of(techniques_of_one_graph(4000)),
              HasSubstr("65552 passes and textures of all techniques, and at most 65536"));
}

TEST_F(TechniqueListTest, APackagesManifestsComeInTheirOrderAndShareStructs) {
  const auto entry = [](const std::string& name) {
    return R"({"name": ")" + name + R"(", "title": "T", "family": "f", "source": "s", "values": {"taps": 2},
               "filter": {"file": "Box.hlsl", "function": "F", "parameters": "P"}})";
  };
  files_.write("ShaderLibrary/Filters/Box.hlsl", "// box\n");
  files_.write("ShaderLibrary/Filters/A.technique.json",
               R"({"order": 2, "techniques": [)" + entry("a") + "]}");
  files_.write("ShaderLibrary/Filters/B.technique.json", R"({"order": 1, "techniques": [)" + entry("b") +
                                                             R"(], "structs": [{"name": "P", "doc": "d",
                      "fields": [{"name": "taps", "type": "int", "unit": "1", "doc": "d"}]}]})");
  files_.write("ShaderLibrary/Other.json", "not a manifest");
  const TechniqueList list = read_technique_list(files_.path("."));
  ASSERT_EQ(list.techniques.size(), 2U);
  EXPECT_EQ(list.techniques[0].name, "b");
  EXPECT_EQ(list.techniques[1].name, "a");
  EXPECT_EQ(list.techniques[1].file(), "ShaderLibrary/Filters/Box.hlsl");
}

// A package of one technique and one graph, and manifests beside it that build on it.
class AdditionTest : public TechniqueListTest {
 protected:
  AdditionTest() {
    files_.write("package/package.json", R"({"name": "com.nobody.shadows"})");
    files_.write("package/Shaders/Box.hlsl", "// box\n");
    files_.write("package/Shaders/Box.technique.json", R"({"order": 2,
      "structs": [{"name": "P", "doc": "d", "fields": [
        {"name": "taps", "type": "int", "unit": "1", "doc": "d", "range": [1, 9]},
        {"name": "width", "type": "float", "unit": "m", "doc": "d", "default": 1}]}],
      "graphs": [{"name": "blur", "passes": [{"name": "F", "kind": "filter",
        "filter": {"file": "Box.hlsl", "function": "Blurred", "parameters": "P"}}]}],
      "techniques": [{"name": "box", "title": "Box", "family": "box", "source": "Nobody 1900",
        "use_when": "always", "bias": {"depth": 2, "normal": 1}, "lights": ["directional", "spot"],
        "filter": {"file": "Box.hlsl", "function": "F", "parameters": "P"}, "keywords": ["_WIDE"],
        "values": {"taps": 3, "width": 2}, "unlimited": {"taps": 4096}, "targets_absent": {"hlsl50": "too long"}}]})");
  }

  TechniqueList added(const std::string& text) const {
    return read_technique_list(files_.write("package/tests/Study.technique.json", text));
  }
  std::string refusal_of_addition(const std::string& text) const {
    return input_error_of([&] { added(text); });
  }
  static std::string like_box(const std::string& more) {
    return R"({"order": 3, "library": "..", "techniques": [{"name": "a", "title": "A", "like": "box")" +
           more + "}]}";
  }
};

TEST_F(AdditionTest, KnowsWhatTheLibraryHas) {
  const TechniqueList list = added(R"({"library": "..", "techniques": [
    {"name": "a", "title": "A", "family": "f", "source": "s", "graph": "blur", "values": {"taps": 5}}]})");
  ASSERT_EQ(list.techniques.size(), 2U);
  EXPECT_EQ(list.techniques[0].name, "a") << "its order is below the library's";
  EXPECT_EQ(added(like_box("")).techniques[0].name, "box");
  EXPECT_EQ(added(like_box("")).first().name, "a") << "measured when no technique is named";
  EXPECT_EQ(list.find("a").graph.filter()->function, "Blurred");
  EXPECT_EQ(list.find("a").file(), "Shaders/Box.hlsl");
  EXPECT_EQ(list.find("a").manifest, "tests/Study.technique.json");
  EXPECT_EQ(list.find("box").file(), "Shaders/Box.hlsl");
}

TEST_F(AdditionTest, AnEntrySaysOnlyWhatDiffersFromAnother) {
  const TechniqueList list = added(like_box(R"(, "values": {"taps": 5})"));
  const Technique& box = list.find("box");
  const Technique& a = list.find("a");
  EXPECT_EQ(a.title, "A");
  EXPECT_EQ(a.use_when, "") << "advice is no other technique's";
  EXPECT_EQ(a.family, "box");
  EXPECT_EQ(a.source, box.source);
  EXPECT_EQ(a.bias, box.bias);
  EXPECT_EQ(a.lights, box.lights);
  EXPECT_EQ(a.keywords, box.keywords);
  EXPECT_EQ(a.unlimited, box.unlimited);
  EXPECT_EQ(a.keyword_sets, box.keyword_sets);
  EXPECT_EQ(a.targets_absent, box.targets_absent);
  EXPECT_EQ(a.graph.filter()->function, "F");
  EXPECT_EQ(a.values, (std::map<std::string, std::vector<double>>{{"taps", {5.0}}, {"width", {2.0}}}));

  const Technique other = added(like_box(R"(, "graph": "blur", "keywords": [], "unlimited": {}, "family": "g",
      "lights": ["directional"], "bias": {"depth": 1, "normal": 0}, "targets_absent": {})"))
                              .find("a");
  EXPECT_EQ(other.graph_name, "blur");
  EXPECT_EQ(other.graph.filter()->function, "Blurred");
  EXPECT_EQ(other.family, "g");
  EXPECT_EQ(other.lights, std::vector<LightKind>{LightKind::directional});
  EXPECT_EQ(other.bias, (TechniqueBias{1.0, 0.0}));
  EXPECT_TRUE(other.keywords.empty());
  EXPECT_TRUE(other.unlimited.empty());
  EXPECT_TRUE(other.targets_absent.empty());
  EXPECT_EQ(other.keyword_sets.size(), 2U) << "none for samples without limit";
  EXPECT_EQ(other.values, box.values);
}

TEST_F(AdditionTest, WrongOnesAreNamedWithTheirPlaceAndARemedy) {
  const auto with_library = [](const std::string& value) {
    return "{\n  \"library\": " + value + R"(, "techniques": [{"name": "a", "title": "A", "like": "box"}]})";
  };
  const std::string place = "Study.technique.json:2:";
  EXPECT_EQ(refusal_of_addition(with_library("\"..\"")), "no error");
  for (const char* outside : {"\"../..\"", "\"/etc\"", "\"/\""})
    EXPECT_THAT(refusal_of_addition(with_library(outside)),
                HasSubstrs(place, "lies outside of '", "name a package in the folder"));
  for (const char* missing : {"\".\"", "\"../Shaders\"", "\"../gone\"", "\"Study.technique.json\""})
    EXPECT_THAT(refusal_of_addition(with_library(missing)),
                HasSubstrs(place, "there is no package in '", "name the folder that holds a package.json"));
  EXPECT_THAT(refusal_of_addition(with_library("\"\"")), HasSubstr("'library' is empty"));
  EXPECT_THAT(refusal_of_addition(with_library("1")), HasSubstr(place));
  EXPECT_THAT(refusal_of_addition(with_library("\"..\\u000a\"")), HasSubstr("'library' is one line"));
  EXPECT_THAT(refusal_of_addition(like_box(R"(, "after": "box")")), HasSubstr("leave out one of the two"));
  EXPECT_THAT(
      refusal_of_addition(R"({"library": "..", "techniques": [{"name": "a", "title": "A", "like": "bix"}]})"),
      HasSubstrs("unknown technique 'bix'", "did you mean 'box'?"));
  EXPECT_THAT(refusal_of_addition(
                  R"({"library": "..", "techniques": [{"name": "box", "title": "A", "like": "box"}]})"),
              HasSubstrs("two techniques 'box'", "the other one is at "));
  EXPECT_THAT(refusal_of_addition(R"({"library": "..", "graphs": [{"name": "blur"}]})"),
              HasSubstrs("two graphs 'blur'", "choose another name"));
}

TEST_F(AdditionTest, APackageIsNotItsOwnLibrary) {
  const std::filesystem::path own = files_.write("package/Shaders/Own.technique.json", like_box(""));
  for (const std::filesystem::path& given : {own, files_.path("package/tests/Study.technique.json")}) {
    files_.write("package/tests/Study.technique.json", like_box(""));
    expect_input_error([&] { read_technique_list(given); },
                       HasSubstrs("Own.technique.json:1:", "has no library itself", "know each other"));
  }
}

TEST_F(AdditionTest, LinksDoNotLeadOutOfItsTree) {
  files_.write("elsewhere/package.json", "{}");
  files_.write("elsewhere/Shaders/Secret.technique.json", "not a manifest");
  std::filesystem::create_directory_symlink(files_.path("elsewhere"), files_.path("package/linked"));
  EXPECT_THAT(refusal_of_addition(R"({"library": "../linked", "techniques": []})"),
              HasSubstr("lies outside of '"));
  std::filesystem::create_symlink(files_.path("elsewhere/Shaders/Secret.technique.json"),
                                  files_.path("package/Shaders/Link.technique.json"));
  EXPECT_THAT(refusal_of_addition(like_box("")),
              AllOf(HasSubstr("is a symbolic link to outside"), testing::Not(HasSubstr("not a manifest"))));
  try {
    read_technique_list(files_.path("package"));
    ADD_FAILURE() << "the package itself was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("Link.technique.json: is a symbolic link to outside"),
                                    testing::Not(HasSubstr("not a manifest"))));
  }
}

class LookListTest : public TechniqueListTest {
 protected:
  static std::string look(const std::string& name, const std::string& degrees, const std::string& metres) {
    return R"({"name": ")" + name +
           R"(", "title": "Look \"A\"", "doc": "A light.", "angularDiameterDegrees": )" + degrees +
           R"(, "maxPenumbraMetres": )" + metres + "}";
  }
  static std::string text_with(const std::string& looks) {
    return with("\"techniques\": [", "\"looks\": [" + looks + "],\n  \"techniques\": [");
  }
  std::string refusal(const std::string& looks) const { return refusal_of(text_with(looks)); }
};

TEST_F(LookListTest, AreReadAndWrittenAsCSharp) {
  const std::string text = emit_looks_csharp(read(text_with(look("low-sun", "1.5", "3"))));
  EXPECT_THAT(text, HasSubstr("        /// <summary>A light.</summary>\n"
                              "        [InspectorName(\"Look \\\"A\\\"\")] LowSun,\n"));
  EXPECT_THAT(text, HasSubstr("new LookValues(\"Look \\\"A\\\"\", 1.5f, 3.0f,\n"));
}

TEST_F(LookListTest, WrongOnesAreNamedWithTheirPlace) {
  EXPECT_THAT(refusal(look("a", "1", "1") + "," + look("a", "2", "1")), HasSubstr("two looks 'a'"));
  EXPECT_THAT(refusal(look("a", "1", "1") + "," + look("b", "1", "1")),
              HasSubstr("'b' has the values of 'a'"));
}

TEST_F(TechniqueListTest, EmptyListsAndOtherJsonAreRefused) {
  EXPECT_THROW(read(""), InputError);
  EXPECT_THROW(read("[]"), InputError);
  EXPECT_THROW(read("{}"), InputError);
  EXPECT_THROW(read_technique_list(files_.path("gone.technique.json")), InputError);
  EXPECT_THROW(read_technique_list(files_.path(".")), InputError) << "a folder without manifests";
}

TEST_F(TechniqueListTest, UnknownTechniqueNamesTheNearest) {
  const TechniqueList list = read(good);
  expect_input_error([&] { (void)list.find("bax-3"); }, HasSubstr("did you mean 'box-3'?"));
}

TEST_F(TechniqueListTest, CallPassesArgumentsThenReceiverTileAndParameters) {
  const TechniqueList list = read(good);
  const TechniqueCall call = emit_technique_call(list, list.find("box-3"));
  EXPECT_EQ(call.includes, "#include \"Box.hlsl\"\n");
  EXPECT_THAT(call.declarations,
              HasSubstr("TEXTURE2D_SHADOW(_ShadowMap);\nSAMPLER_CMP(sampler_ShadowMap);\n"));
  EXPECT_THAT(call.declarations, HasSubstr("float4 _PenumbraBoxParameters0;\n"));
  EXPECT_EQ(call.function,
            "float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile, int cascade)\n{\n"
            "    return FilterBox(TEXTURE2D_SHADOW_ARGS(_ShadowMap, sampler_ShadowMap), sampler_PointClamp, "
            "receiver, tile, UnpackBoxParameters(_PenumbraBoxParameters0));\n}\n");
}

constexpr const char* by_cascade = R"({
  "structs": [
    {"name": "BoxParameters", "doc": "Even kernel.", "fields": [
      {"name": "taps", "type": "int", "unit": "taps", "doc": "per side", "range": [1, 9]},
      {"name": "scale", "type": "float", "unit": "1", "doc": "stretch", "default": 1}]}
  ],
  "defaults": {"family": "box", "source": "Nobody 1900",
    "filter": {"file": "Box.hlsl", "function": "FilterBox", "arguments": ["shadowMap"], "parameters": "BoxParameters"}},
  "techniques": [
    {"name": "plain", "title": "Plain", "filter": {"file": "Box.hlsl", "function": "FilterPlain"}},
    {"name": "wide", "title": "Wide", "values": {"taps": 9}, "keywords": ["_WIDE"]},
    {"name": "mixed", "title": "Mixed", "values": {"taps": 7}, "unlimited": {"taps": 99},
     "cascades": [{"from": 1, "values": {"taps": 5}}, {"from": 3, "technique": "plain"}]}
  ]
})";

TEST_F(TechniqueListTest, ATechniqueMayDifferFromACascadeOn) {
  const TechniqueList list = read(by_cascade);
  const Technique& mixed = list.find("mixed");
  ASSERT_EQ(mixed.cascades.size(), 2U);
  EXPECT_EQ(mixed.cascades[0].filter.function, "FilterBox");
  EXPECT_EQ(mixed.cascades[0].values, (std::map<std::string, std::vector<double>>{{"taps", {5.0}}}));
  EXPECT_EQ(mixed.cascades[0].unlimited, mixed.unlimited);
  EXPECT_EQ(mixed.cascades[1].technique, "plain");
  EXPECT_TRUE(mixed.cascades[1].unlimited.empty());
  const TechniqueCall call = emit_technique_call(list, mixed);
  EXPECT_EQ(call.includes, "#include \"Box.hlsl\"\n");
  EXPECT_EQ(call.declarations,
            "TEXTURE2D_SHADOW(_ShadowMap);\nSAMPLER_CMP(sampler_ShadowMap);\n"
            "float4 _PenumbraBoxParameters0;\nfloat4 _PenumbraBoxParameters0From1;\n");
  const std::string box =
      "FilterBox(TEXTURE2D_SHADOW_ARGS(_ShadowMap, sampler_ShadowMap), receiver, tile, UnpackBoxParameters(";
  EXPECT_EQ(call.function,
            "float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile, int cascade)\n{\n"
            "    if (cascade >= 3) return FilterPlain(TEXTURE2D_SHADOW_ARGS(_ShadowMap, sampler_ShadowMap), "
            "receiver, tile);\n"
            "    if (cascade >= 1) return " +
                box +
                "_PenumbraBoxParameters0From1));\n"
                "    return " +
                box + "_PenumbraBoxParameters0));\n}\n");
  EXPECT_THAT(techniques_json(list), HasSubstr("\"from\":3,\"technique\":\"plain\""));
}

TEST_F(TechniqueListTest, RulesForCascadesAreChecked) {
  const std::string given = R"([{"from": 1, "values": {"taps": 5}}, {"from": 3, "technique": "plain"}])";
  const std::string line = "box.technique.json:13:";
  refuse(by_cascade, given, R"([{"from": 2, "technique": "plain"}, {"from": 2, "technique": "plain"}])", line,
         "rules come in rising order");
  refuse(by_cascade, given, R"([{"from": 1}])", line, "the rule changes nothing");
  refuse(by_cascade, given, R"([{"from": 1, "technique": "plane"}])", line, "unknown technique 'plane'",
         "'plain'");
  refuse(by_cascade, given, R"([{"from": 1, "technique": "mixed"}])", "unknown technique 'mixed'");
  refuse(by_cascade, given, R"([{"from": 1, "technique": "wide"}])", line,
         "'wide' is compiled with other keywords than 'mixed'");
  refuse(by_cascade, given, R"([{"from": 1, "values": {"taps": 10}}])", line,
         "'taps' is a whole number from 1 to 9, not 10");
  refuse(by_cascade, given, R"([{"from": 1, "values": {"tops": 1}}])", line, "tops");
  refuse(by_cascade, given, R"([{"from": 1, "technique": "plain", "values": {"taps": 1}}])", line, "taps");
  refuse(by_cascade, given, R"([{"from": 1, "values": {"taps": 5}, "filter": "x"}])", "filter");
}

TechniqueList library() {
  return read_technique_list(PENUMBRA_SOURCE_DIR);
}

TEST(LibraryTechniques, AreThoseThatSomebodyWouldChoose) {
  EXPECT_LE(library().techniques.size(), 63U) << "what proves a point belongs to tests/study";
}

TEST(LibraryTechniques, DeclareTexturesOfIntegersByWhatTheyHold) {
  const auto declared = [](const std::string& technique) {
    return emit_technique_call(library(), library().find(technique)).declarations;
  };
  EXPECT_THAT(declared("vssm-sat-32"), HasSubstr("Texture2D<uint4> _PenumbraSumsTexture;\n"));
  EXPECT_THAT(declared("vssm-mip-32"), testing::StartsWith("TEXTURE2D(_PenumbraMomentsTexture);\n"));
}

TEST(LibraryTechniques, APresetWithoutAFallbackIsRefused) {
  TechniqueList list = library();
  list.presets.pop_back();
  EXPECT_THROW((void)emit_presets_csharp(list), InputError);
}

}  // namespace
}  // namespace penumbra::techniques
