// Tests what a graph may be: every way in which one cannot be run has its own message at its own place, and
// passes run after those whose output they read.
#include "techniques/pass_graph.h"

#include <gmock/gmock.h>

#include "gpu/format.h"
#include "processor_time.h"
#include "techniques/manifest_test.h"
#include "techniques/texel_formats.h"

namespace penumbra::techniques {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

// The graph has a variance map with a separable blur and mip levels, before the filter that reads it; the
// passes are not in the order in which they have to run.
constexpr const char* kVariance = R"({
"graphs": [{"name": "variance",
  "textures": [
    {"name": "moments", "extent": "map", "format": "rg32f"},
    {"name": "rows", "extent": "map", "format": "rg32f"},
    {"name": "blurred", "extent": "map", "format": "rg32f", "mips": 0}],
  "passes": [
    {"name": "filter", "kind": "filter",
     "filter": {"file": "V.hlsl", "function": "FilterVariance", "arguments": ["blurred", "linearSampler"]}},
    {"name": "Mips", "kind": "raster", "shader": "V.shader", "runs": "cascade",
     "reads": {"_Source": "blurred"}, "writes": ["blurred"], "each_mip": true},
    {"name": "Columns", "kind": "raster", "shader": "V.shader", "runs": "cascade",
     "reads": {"_Source": "rows"}, "writes": ["blurred"]},
    {"name": "Rows", "kind": "raster", "shader": "V.shader", "runs": "cascade",
     "reads": {"_Source": "moments"}, "writes": ["rows"]},
    {"name": "Moments", "kind": "raster", "shader": "V.shader", "runs": "cascade", "writes": ["moments"]}]}],
"techniques": [{"name": "variance", "title": "Variance", "family": "variance", "source": "Donnelly and Lauritzen 2006",
                "graph": "variance"}]})";

// Marked tiles of the screen are listed, and shaded.
constexpr const char* kTiles = R"({
"graphs": [{"name": "tiles",
  "textures": [{"name": "visibility", "format": "r32f"}, {"name": "marks", "divisor": 8, "format": "r16ui"},
               {"name": "list", "extent": "fixed", "size": [64, 64, 1], "format": "r32ui"}],
  "passes": [
    {"name": "Mark", "kind": "compute", "compute": "T.compute", "writes": {"_Marks": "marks"},
     "groups": {"texels_of": "marks"}},
    {"name": "Collect", "kind": "compute", "compute": "T.compute", "reads": {"_Marks": "marks"},
     "writes": {"_List": "list"}, "groups": {"fixed": [1, 1, 1]}},
    {"name": "Shade", "kind": "compute", "compute": "T.compute", "reads": {"_List": "list"},
     "writes": {"_Visibility": "visibility"}, "groups": {"texels_of": "visibility"}}],
  "visibility": "visibility"}],
"techniques": [{"name": "tiles", "title": "Tiles", "family": "tiles", "source": "s", "graph": "tiles"}]})";

// There are two techniques over the screen, the second darkened by a graph that reads what it made.
constexpr const char* kDarker = R"({
"structs": [
  {"name": "First", "doc": "First.", "fields": [{"name": "taps", "type": "int", "unit": "1", "doc": "taps", "default": 4}]},
  {"name": "Second", "doc": "Second.", "fields": [{"name": "share", "type": "float", "unit": "1", "doc": "share", "default": 1}]}],
"defaults": {"family": "f", "source": "s"},
"graphs": [
  {"name": "first", "textures": [{"name": "visibility", "format": "r8"}, {"name": "mask", "divisor": 4, "format": "r8"}],
   "passes": [
     {"name": "Mask", "kind": "raster", "shader": "V.shader", "writes": ["mask"]},
     {"name": "First", "kind": "raster", "shader": "V.shader", "reads": {"_Mask": "mask"}, "writes": ["visibility"],
      "parameters": ["First"]}],
   "keywords": ["_MASK"], "visibility": "visibility", "mask": "mask"},
  {"name": "darker", "textures": [{"name": "before", "format": "r8"}, {"name": "after", "format": "r8"}],
   "source": "before",
   "passes": [
     {"name": "Darker", "kind": "raster", "shader": "V.shader", "reads": {"_Source": "before"}, "writes": ["after"],
      "parameters": ["Second"]}],
   "keywords": ["_DARKER"], "visibility": "after"}],
"techniques": [
  {"name": "both", "title": "Both", "graph": "darker", "after": "one", "values": {"share": 0.5}}]})";

// The graph with the technique that it follows before it.
std::string darker() {
  return replaced(
      kDarker, "\"techniques\": [",
      R"("techniques": [{"name": "one", "title": "One", "graph": "first", "keywords": ["_ONE"], "values": {"taps": 9},
      "bias": {"depth": 2, "normal": 0.5}},)");
}

class PassGraphTest : public ManifestTest {
 protected:
  PassGraphTest() : ManifestTest("t.technique.json", {"V.hlsl", "V.shader", "T.compute"}) {}

  PassGraph graph_of(const std::string& text) const { return read(text).techniques.at(0).graph; }
  static std::vector<std::string> names(const PassGraph& graph) {
    std::vector<std::string> names;
    for (const GraphPass& pass : graph.passes) names.push_back(pass.name);
    return names;
  }
};

TEST_F(PassGraphTest, PassesRunAfterThoseWhoseOutputTheyRead) {
  const PassGraph variance = graph_of(kVariance);
  EXPECT_THAT(names(variance), ElementsAre("Moments", "Rows", "Columns", "Mips", "filter"));
  EXPECT_EQ(variance.texture("blurred")->mips, 0);
  EXPECT_EQ(variance.passes[1].frequency, Frequency::cascade);
  EXPECT_FALSE(variance.over_screen());
  const PassGraph tiles = graph_of(kTiles);
  EXPECT_THAT(names(tiles), ElementsAre("Mark", "Collect", "Shade"));
  EXPECT_TRUE(tiles.over_screen());
  EXPECT_EQ(tiles.passes[2].groups.texels_of, "visibility");
}

// The graph makes the mean of this frame and the ones before.
constexpr const char* kMean = R"({
"graphs": [{"name": "mean",
  "textures": [
    {"name": "now", "format": "r16f"},
    {"name": "before", "previous_of": "mean"},
    {"name": "mean", "format": "r16f", "divisor": 1},
    {"name": "visibility", "format": "r8"}],
  "passes": [
    {"name": "Show", "kind": "raster", "shader": "V.shader", "reads": {"_A": "mean"}, "writes": ["visibility"]},
    {"name": "Mean", "kind": "raster", "shader": "V.shader", "reads": {"_A": "now", "_B": "before"}, "writes": ["mean"]},
    {"name": "Now", "kind": "raster", "shader": "V.shader", "writes": ["now"]}],
  "visibility": "visibility"}],
"techniques": [{"name": "mean", "title": "Mean", "family": "mean", "source": "s", "graph": "mean"}]})";

TEST_F(PassGraphTest, ATextureMayBeReadAsItWasAFrameAgo) {
  const PassGraph mean = graph_of(kMean);
  EXPECT_THAT(names(mean), ElementsAre("Now", "Mean", "Show"));
  EXPECT_EQ(mean.texture("before")->previous_of, "mean");
  EXPECT_EQ(mean.texture("before")->format, "r16f");
  EXPECT_EQ(mean.texture("now")->previous_of, "");
}

TEST_F(PassGraphTest, AWrongHistoryIsFound) {
  const std::string before = R"({"name": "before", "previous_of": "mean"})";
  refuse(kMean, R"("previous_of": "mean")", R"("previous_of": "meen")",
         "t.technique.json:5:", "there is no texture 'meen'");
  refuse(kMean, before, R"({"name": "before", "previous_of": "before"})", "'before' is itself a frame old");
  refuse(kMean, R"("writes": ["now"])", R"("writes": ["now", "before"])",
         "t.technique.json:11:", "'Now' writes 'before', which is 'mean' a frame ago");
  refuse(kMean, R"(, "_B": "before")", "", "nothing reads 'before'");
  refuse(kMean, R"("visibility": "visibility")", R"("visibility": "before")",
         "'before' is a frame old, and the graph's result");
  refuse(kMean, R"("writes": ["mean"])", R"("runs": "bake", "writes": ["mean"])",
         "'Mean' does not write 'mean' in every frame");
}

TEST_F(PassGraphTest, NamesThatNothingHasOrTwoHaveAreFound) {
  refuse(kVariance, R"({"_Source": "rows"})", R"({"_Source": "row"})",
         "t.technique.json:12:", "'Columns' names 'row', which is not declared",
         "the graph has: moments, rows, blurred");
  refuse(kVariance, R"("arguments": ["blurred")", R"("arguments": ["blured")",
         "'blured' is no argument of a filter");
  refuse(kVariance, R"({"name": "rows")", R"({"name": "moments")", "there are two of the name 'moments'");
  refuse(kVariance, R"("name": "Rows")", R"("name": "Columns")",
         "there are two of the name 'Columns', one a pass");
  refuse(kVariance, R"("graph": "variance")", R"("graph": "varance")", "unknown graph 'varance'",
         "did you mean 'variance'?");
  refuse(kTiles, R"({"texels_of": "marks"})", R"({"texels_of": "mark"})", "there is no texture 'mark'");
  refuse(kTiles, R"("visibility": "visibility"}])", R"("visibility": "visible"}])",
         "there is no texture 'visible'");
}

TEST_F(PassGraphTest, EachTextureHasOneWriterAndAReader) {
  refuse(kVariance, R"("reads": {"_Source": "moments"}, "writes": ["rows"])",
         R"("reads": {"_Source": "rows"}, "writes": ["moments"])",
         "more than one pass writes 'moments': 'Rows', 'Moments'",
         "or name it among the \"updates\" of a kernel");
  refuse(kVariance, R"(, "writes": ["moments"])", R"(, "writes": ["rows"])", "no pass writes 'moments'");
  refuse(kVariance, R"("arguments": ["blurred", )", R"("arguments": [)",
         "t.technique.json:6:", "nothing reads 'blurred'");
  refuse(kTiles, R"({"_List": "list"},
     "writes": {"_Visibility")",
         R"({},
     "writes": {"_Visibility")",
         "nothing reads 'list'");
  refuse(kVariance, R"("writes": ["blurred"]},)", R"("writes": ["blurred"], "each_mip": true},)",
         "'Columns' runs for each mip level of 'blurred'");
  refuse(kVariance, R"("writes": ["blurred"], "each_mip")", R"("writes": ["blurred", "rows"], "each_mip")",
         "'Mips' runs for each mip level of 'blurred'", "that is the one texture it writes");
}

TEST_F(PassGraphTest, AnAbsentTextureIsWhatTheProgramCallsOneThatThePassDoesNotRead) {
  const std::string reads = R"("reads": {"_Source": "before"}, "writes")";
  const auto with = [](const std::string& absent) {
    return R"("reads": {"_Source": "before"}, "absent": [)" + absent + R"(], "writes")";
  };
  const TechniqueList list = read(replaced(darker(), reads, with(R"("_Other")")));
  EXPECT_THAT(list.find("both").graph.passes.back().absent, ElementsAre("_Other"));
  refuse(darker(), reads, with(R"("_Source")"), "t.technique.json:", "the pass reads '_Source'");
  refuse(darker(), reads, with(R"("_Other", "_Other")"), "'_Other' stands there twice");
}

// "Blank" fills the visibility, "Shade" changes it, and "Darken" reads what both have made.
TEST_F(PassGraphTest, AKernelUpdatesWhatAnotherPassHasWritten) {
  std::string text = kTiles;
  text.replace(
      text.find(R"({"name": "Mark")"), 0,
      R"({"name": "Darken", "kind": "compute", "compute": "T.compute", "reads": {"_Shaded": "visibility"},
     "writes": {"_Result": "darkened"}, "groups": {"texels_of": "darkened"}},
    {"name": "Blank", "kind": "compute", "compute": "T.compute", "writes": {"_Visibility": "visibility"},
     "groups": {"texels_of": "visibility"}},
    )");
  text.replace(
      text.find(R"("writes": {"_Visibility": "visibility"}, "groups": {"texels_of": "visibility"}}],)"), 8,
      R"("updates")");
  text.replace(text.find(R"({"name": "visibility")"), 0, R"({"name": "darkened", "format": "r32f"},
     )");
  const std::string shown = R"("visibility": "visibility"}],)";
  text.replace(text.find(shown), shown.size(), R"("visibility": "darkened"}],)");
  const PassGraph graph = graph_of(text);
  EXPECT_THAT(names(graph), ElementsAre("Blank", "Mark", "Collect", "Shade", "Darken"));
  EXPECT_TRUE(changes(graph.passes[3], "visibility"));
  EXPECT_FALSE(changes(graph.passes[0], "visibility"));

  refuse(kTiles, R"("writes": {"_Visibility")", R"("updates": {"_Visibility")",
         "'Shade' updates 'visibility', which no other pass writes", "name it among its \"writes\"");
  refuse(text, R"("reads": {"_List": "list"},)", R"("reads": {"_List": "list", "_Old": "visibility"},)",
         "'Shade' reads 'visibility', which it writes");
  refuse(text, R"("updates": {"_Visibility": "visibility"})",
         R"("updates": {"_Visibility": "visibility", "_Again": "visibility"})",
         "'Shade' writes 'visibility' twice");
}

TEST_F(PassGraphTest, PassesThatWaitForEachOtherAreFound) {
  refuse(kVariance, R"("runs": "cascade", "writes": ["moments"])",
         R"("runs": "cascade", "reads": {"_Old": "blurred"}, "writes": ["moments"])",
         "passes wait for each other in a circle, among: ");
  refuse(kVariance, R"({"_Source": "moments"}, "writes": ["rows"])",
         R"({"_Source": "moments", "_Own": "rows"}, "writes": ["rows"])",
         "'Rows' reads 'rows', which it writes");
}

TEST_F(PassGraphTest, APassRunsAsOftenAsWhatItReads) {
  refuse(kVariance, R"("runs": "cascade", "writes": ["moments"])", R"("writes": ["moments"])",
         "'Rows' runs more rarely than 'Moments', whose output it reads");
  // What is made once may be read every frame.
  refuse(kVariance, R"("runs": "cascade", "writes": ["moments"])", R"("runs": "bake", "writes": ["moments"])",
         "no error");
}

TEST_F(PassGraphTest, TexturesThatNoDeviceHasAreFound) {
  const std::string rows = R"({"name": "rows", "extent": "map", "format": "rg32f")";
  refuse(kVariance, rows, R"({"name": "rows", "extent": "fixed", "size": [9000, 9000, 1], "format": "rg32f")",
         "takes more than 1 GiB");
  refuse(kVariance, rows, R"({"name": "rows", "samples": 4, "mips": 2, "format": "rg32f")", "one mip level");
  refuse(kVariance, rows, R"({"name": "rows", "extent": "map", "format": "depth32")",
         "'Rows' writes 'rows', of format depth32");
  refuse(kTiles, R"("format": "r16ui")", R"("format": "r16ui", "samples": 4)",
         "cannot write 'marks' of several samples");
}

// Each takes less than a texture may.
TEST_F(PassGraphTest, TexturesOfAGraphTogetherAreLimited) {
  const auto expect_of = [&](int count, const std::string& shape, const auto&... says) {
    std::string textures;
    for (int i = 0; i < count; ++i)
      textures += R"({"name": "t)" + std::to_string(i) + R"(", "format": "r32f", )" + shape + "},\n";
    refuse(kTiles, R"({"name": "visibility", "f)", textures + R"({"name": "visibility", "f)", says...);
  };
  const std::string large = R"("extent": "fixed", "size": [5000, 5000, 1])";
  expect_of(100, large, "t.technique.json:24:", "texture 't21'", "take 2098 MiB",
            "more than the 2048 MiB that a graph may", "use fewer or smaller textures");
  expect_of(21, large, "no pass writes 't0'");  // these fit
  expect_of(100, R"("extent": "screen")", "that a graph may");
  expect_of(100, R"("extent": "map")", "that a graph may");
  // Of a tile there is one layer for each cascade.
  expect_of(1, R"("extent": "tile", "divisor": 1, "layers": 256)", "no pass writes 't0'");
  expect_of(1, R"("extent": "screen", "layers": 256)", "that a graph may");
}

// The passes are written from the last to the first, so that each is found after a look at all others.
TEST_F(PassGraphTest, ALongChainRunsInItsOrder) {
  PassGraph graph;
  constexpr int kLong = 120;
  for (int i = kLong; i-- > 0;) {
    GraphPass pass;
    pass.name = "P" + std::to_string(i);
    pass.kind = PassKind::raster;
    pass.writes = {{"", "t" + std::to_string(i)}};
    if (i > 0) pass.reads = {{"_In", "t" + std::to_string(i - 1)}};
    for (int k = 0; k < 63; ++k) pass.reads.emplace_back("_" + std::to_string(k), "t0");
    if (i == 0) pass.reads.clear();
    graph.passes.push_back(pass);
  }
  const double seconds = processor_seconds([&] {
    const auto ordered = in_running_order(graph);
    ASSERT_TRUE(ordered.has_value());
    for (int i = 0; i < kLong; ++i)
      EXPECT_EQ((*ordered)[static_cast<std::size_t>(i)].name, "P" + std::to_string(i));
  });
  EXPECT_LT(seconds, 1.0) << "what grows with the cube takes many";
}

TEST_F(PassGraphTest, TargetsOfOneDrawHaveOneSize) {
  refuse(kVariance, R"(, "writes": ["moments"])", R"(, "writes": ["moments", "extra"])",
         "'Moments' names 'extra'");
  std::string text = kVariance;
  text.replace(text.find("\"textures\": ["), 13,
               R"("textures": [{"name": "extra", "extent": "map", "divisor": 2, "format": "r8"},)");
  refuse(text, R"(, "writes": ["moments"])", R"(, "writes": ["moments", "extra"])",
         "'Moments' draws into 'moments' and 'extra', which differ in size or samples");
}

TEST_F(PassGraphTest, WhatOneDrawCannotWriteIsFound) {
  refuse(kVariance, R"(, "writes": ["moments"])", R"(, "writes": ["moments", "moments"])",
         "'Moments' writes 'moments' twice");
  refuse(kVariance, R"({"name": "moments", "extent": "map")",
         R"({"name": "moments", "extent": "map", "layers": 2)", "'moments', which has several layers");
  refuse(kVariance, R"({"name": "Rows")",
         R"({"name": "Mips2", "kind": "raster", "shader": "V.shader", "runs": "cascade",
     "reads": {"_Source": "blurred"}, "writes": ["blurred"], "each_mip": true}, {"name": "Rows")",
         "more than one pass makes the mip levels of 'blurred'");
}

TEST_F(PassGraphTest, AGraphEndsInOneVisibility) {
  refuse(kTiles, R"(,
  "visibility": "visibility"})",
         "}", "nothing reads 'visibility'", "add \"visibility\": \"visibility\"");
  refuse(kTiles, R"({"name": "visibility", )", R"({"name": "visibility", "divisor": 2, )",
         "the visibility has not one texel for each pixel of the screen");
  refuse(kTiles, R"({"name": "visibility", "format": "r32f"})",
         R"({"name": "visibility", "format": "rgba8"})", "the visibility 'visibility' has the format rgba8");
  refuse(kTiles, R"({"name": "visibility", )", R"({"name": "visibility", "layers": 2, )",
         "is not a plain texture of the screen");
  refuse(kTiles, R"("visibility": "visibility"}])", R"("visibility": "visibility", "mask": "marks"}])",
         "the mask 'marks' has the format r16ui");
  refuse(kVariance, R"("passes": [)", R"("passes": [{"name": "second", "kind": "filter",
                         "filter": {"file": "V.hlsl", "function": "F"}},)",
         "there are two filters");
  refuse(kVariance, R"("passes": [)", R"("visibility": "rows", "passes": [)",
         "that of a filter or a texture: one of the two");
}

TEST_F(PassGraphTest, AGraphThatEndsInAFilterHasNoScreen) {
  EXPECT_THAT(refusal_of(replaced(kVariance, R"({"name": "rows", "extent": "map")",
                                  R"({"name": "rows", "extent": "screen")")),
              AnyOf(HasSubstr("which is not of the map or a tile"), HasSubstr("is of the screen")));
  refuse(kVariance, R"("passes": [)", R"("mask": "rows", "passes": [)",
         "a graph that ends in a filter has no mask");
}

TEST_F(PassGraphTest, APublishedTextureIsAMapOfTheLight) {
  const std::string ends = R"("visibility": "visibility"}])";
  refuse(kTiles, ends, R"("visibility": "visibility", "published": ["nothing"]}])",
         "there is no texture 'nothing' to be published");
  refuse(kTiles, ends, R"("visibility": "visibility", "published": ["visibility"]}])",
         "the published 'visibility' is of the screen");
  refuse(kVariance, R"("passes": [)", R"("published": ["rows"], "passes": [)",
         "publishes what the filter takes");
}

TEST_F(PassGraphTest, APartsTexturesAndPassesAreTakenOver) {
  std::string text = kVariance;
  text.replace(text.find("}],\n\"techniques\""), 3, R"(}, {"name": "whole", "parts": ["variance"]}],)");
  text.replace(text.find("\"graph\": \"variance\""), 19, "\"graph\": \"whole\"");
  EXPECT_EQ(graph_of(text).passes.size(), 5U);
  refuse(text, "[\"variance\"]", "[\"variants\"]", "unknown graph 'variants'");
  std::string many = "\"variance\"";
  for (int i = 0; i < 40; ++i) many += ", \"variance\"";
  refuse(text, "[\"variance\"]", "[" + many + "]", "at most 256 passes");
}

TEST_F(PassGraphTest, AGraphMayReadTheVisibilityOfATechniqueBeforeIt) {
  const TechniqueList list = read(darker());
  const Technique& both = list.find("both");
  EXPECT_THAT(names(both.graph), ElementsAre("Mask", "First", "Darker"));
  EXPECT_THAT(both.graph.passes.back().reads, ElementsAre(std::pair("_Source", "visibility")));
  EXPECT_EQ(both.graph.visibility, "after");
  EXPECT_EQ(both.graph.mask, "mask");
  EXPECT_EQ(both.graph.source, "");
  EXPECT_EQ(both.graph.texture("before"), nullptr);
  EXPECT_THAT(both.all_keywords(), ElementsAre("_ONE", "_MASK", "_DARKER"));
  EXPECT_EQ(both.values.at("taps"), (std::vector<double>{9.0}));
  EXPECT_EQ(both.values.at("share"), (std::vector<double>{0.5}));
  EXPECT_EQ(both.bias.normal, 0.5);
  EXPECT_NO_THROW(check_graph(both.graph, ""));
}

TEST_F(PassGraphTest, NeedsAreThoseOfAllPartsEachOnce) {
  std::string text = darker();
  const auto add = [&](const std::string& at, const std::string& needs) {
    text.insert(text.find(at) + at.size(), needs);
  };
  add(R"({"name": "first",)", R"("needs": ["groundHeights"],)");
  add(R"({"name": "darker",)", R"("needs": ["horizonAngles", "groundHeights"],)");
  const TechniqueList list = read(text);
  EXPECT_THAT(list.find("both").graph.needs, ElementsAre(Need::ground_heights, Need::horizon_angles));
}

TEST_F(PassGraphTest, AWrongSourceIsFound) {
  const std::string text = darker();
  refuse(text, R"("graph": "darker", "after": "one")", R"("graph": "darker")",
         "reads the visibility of another, its source 'before'", "\"after\"");
  refuse(text, R"("graph": "darker", "after": "one")", R"("graph": "first", "after": "one")",
         "the graph has no source");
  refuse(text, R"("after": "one")", R"("after": "on")", "'on'");
  refuse(text, R"("source": "before")", R"("source": "befor")", "no texture 'befor'");
  refuse(text, R"("source": "before")", R"("source": "after")", "no pass writes 'before'");
  refuse(text, R"({"name": "Darker", "kind")",
         R"({"name": "Fill", "kind": "raster", "shader": "V.shader", "writes": ["before"]},
                       {"name": "Darker", "kind")",
         "a pass writes 'before', the visibility of the graph before");
  refuse(text, R"({"name": "before", "format": "r8"})", R"({"name": "before", "format": "rg16f"})",
         "the source 'before' has the format rg16f");
  refuse(text, R"({"name": "before", "format": "r8"})", R"({"name": "before", "divisor": 2, "format": "r8"})",
         "not one texel for each pixel");
  refuse(text, R"("reads": {"_Source": "before"}, )", "", "nothing reads 'before'");
  refuse(text, R"({"name": "after", "format": "r8"})", R"({"name": "mask", "format": "r8"})", "'after'");
}

TEST_F(PassGraphTest, WhatATargetLacksIsSaidOfTheTextureThatNeedsIt) {
  const PassGraph tiles = graph_of(kTiles);
  const GraphPass& mark = tiles.passes[0];
  const std::vector<hlsl::Diagnostic> essl = target_problems(tiles, mark, "essl310");
  ASSERT_EQ(essl.size(), 1U);
  EXPECT_THAT(essl[0].message, HasSubstr("cannot write 'r16ui', the format of 'marks'"));
  EXPECT_THAT(essl[0].file, EndsWith("t.technique.json"));
  EXPECT_EQ(essl[0].line, 3);
  EXPECT_THAT(target_problems(tiles, tiles.passes[2], "essl310"), IsEmpty()) << "r32f";
  EXPECT_THAT(target_problems(tiles, mark, "spirv"), IsEmpty());
  const PassGraph variance = graph_of(kVariance);
  EXPECT_THAT(target_problems(variance, variance.passes[0], "essl310"), IsEmpty()) << "drawn, not stored";
}

TEST(TexelFormats, AreThoseOfTheDeviceRoom) {
  EXPECT_EQ(texel_formats().size(), gpu::all_formats().size());
  for (const gpu::Format format : gpu::all_formats()) {
    const TexelFormat* found = find_texel_format(gpu::name(format));
    ASSERT_NE(found, nullptr) << gpu::name(format);
    EXPECT_EQ(found->depth, gpu::is_depth(format)) << gpu::name(format);
    EXPECT_EQ(found->stencil, gpu::has_stencil(format)) << gpu::name(format);
  }
}

TEST(LibraryGraphs, OfTheLibraryAreThoseThatWereMeasured) {
  const TechniqueList list =
      read_technique_list(PENUMBRA_SOURCE_DIR "/tests/study/StudyVariants.technique.json");
  EXPECT_EQ(list.techniques.size(), 104U);
  const PassGraph& graph = list.find("screen-pcss-angular-24-16-half-masked-denoised").graph;
  std::vector<std::string> names;
  for (const GraphPass& pass : graph.passes) names.push_back(pass.name);
  EXPECT_THAT(names, ElementsAre("PenumbraMask", "MaskBlurHorizontal", "MaskBlurVertical", "Resolve",
                                 "Upsample", "DenoiseHorizontal", "DenoiseVertical"));
  EXPECT_EQ(graph.mask, "mask");
  EXPECT_EQ(graph.visibility, "visibility");
  EXPECT_EQ(graph.passes[4].program, "Resolve") << "one program filters and upsamples";
  EXPECT_THAT(graph.passes[3].absent, ElementsAre("_PenumbraSourceTexture"));
  EXPECT_THAT(graph.passes[4].absent, ElementsAre("_PenumbraMaskTexture"));
}

}  // namespace
}  // namespace penumbra::techniques
