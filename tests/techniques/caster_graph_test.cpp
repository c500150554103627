// Tests what a pass that draws the casters may be: its targets, its depth and when it runs, each mistake with
// its own message at its own place.
#include <gmock/gmock.h>

#include "techniques/feature_tables.h"
#include "techniques/golden_json.h"
#include "techniques/manifest_test.h"
#include "techniques/pass_graph.h"

namespace penumbra::techniques {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// The graph has the casters behind the nearest ones, and what covers both; the passes are not in the order in
// which they have to run.
constexpr const char* kLayers = R"({
"graphs": [{"name": "layers",
  "textures": [
    {"name": "nearest", "extent": "map", "format": "depth32"},
    {"name": "second", "extent": "map", "format": "r32f"},
    {"name": "behind", "extent": "map", "format": "depth32"},
    {"name": "colour", "extent": "map", "format": "rgba8"}],
  "passes": [
    {"name": "filter", "kind": "filter",
     "filter": {"file": "L.hlsl", "function": "FilterLayers", "arguments": ["nearest", "second", "colour"]}},
    {"name": "Second", "kind": "casters", "shader": "L.shader", "runs": "cascade",
     "reads": {"_Nearest": "nearest"}, "writes": ["second"], "depth": "behind"},
    {"name": "Colour", "kind": "casters", "shader": "L.shader", "runs": "cascade", "writes": ["colour"],
     "depth": "shadowMap"},
    {"name": "Nearest", "kind": "casters", "shader": "L.shader", "runs": "cascade", "depth": "nearest"}]}],
"techniques": [{"name": "layers", "title": "Layers", "family": "layers", "source": "s", "graph": "layers"}]})";

// The graph has what the camera sees of the casters.
constexpr const char* kSeen = R"({
"graphs": [{"name": "seen",
  "textures": [
    {"name": "visibility", "format": "r32f"},
    {"name": "depth", "format": "depth24"}],
  "passes": [
    {"name": "Seen", "kind": "casters", "shader": "L.shader", "writes": ["visibility"], "depth": "depth"}],
  "visibility": "visibility"}],
"techniques": [{"name": "seen", "title": "Seen", "family": "seen", "source": "s", "graph": "seen"}]})";

// The volumes are counted in the stencil of the camera's depth; again the passes are not in the order in
// which they have to run.
constexpr const char* kVolumes = R"({
"graphs": [{"name": "volumes",
  "textures": [
    {"name": "visibility", "format": "r32f"},
    {"name": "depth", "format": "depth32s8"}],
  "passes": [
    {"name": "Lit", "kind": "raster", "shader": "L.shader", "stencil": "depth", "writes": ["visibility"]},
    {"name": "Count", "kind": "casters", "casters": "volumes", "shader": "L.shader", "stencil": "depth"},
    {"name": "Depth", "kind": "casters", "shader": "L.shader", "depth": "depth"}],
  "visibility": "visibility"}],
"techniques": [{"name": "volumes", "title": "Volumes", "family": "volumes", "source": "s", "graph": "volumes"}]})";

class CasterGraph : public ManifestTest {
 protected:
  CasterGraph() : ManifestTest("t.technique.json", {"L.hlsl", "L.shader"}) {}
};

TEST_F(CasterGraph, WaitsForTheDepthThatItReads) {
  const PassGraph graph = read(kLayers).techniques.at(0).graph;
  std::vector<std::string> names;
  for (const GraphPass& pass : graph.passes) names.push_back(pass.name);
  EXPECT_THAT(names, ElementsAre("Colour", "Nearest", "Second", "filter"));
  EXPECT_EQ(graph.passes[0].kind, PassKind::casters);
  EXPECT_EQ(graph.passes[0].depth, shadow_map_name);
  EXPECT_EQ(graph.passes[2].depth, "behind");
  EXPECT_TRUE(writes_to(graph.passes[1], "nearest"));
  EXPECT_EQ(refusal_of(kSeen), "no error");
}

TEST_F(CasterGraph, IsWrittenAsJsonAndAsRows) {
  const TechniqueList layers = read(kLayers);
  EXPECT_THAT(techniques_json(layers), HasSubstrs("\"kind\":\"casters\"", "\"depth\":\"behind\""));
  EXPECT_THAT(graph_rows(layers),
              HasSubstrs("pass\tCasters\tCascade\tL.shader\tNearest\ndepth\tnearest\n", "depth\tbehind\n",
                         "\ttestsShadowMap\n", "texture\tnearest\tMap\tD32_SFloat\n"));
}

TEST_F(CasterGraph, ADepthHasADepthFormatAndNothingElseDoes) {
  refuse(kLayers, R"("writes": ["second"], "depth": "behind")", R"("writes": ["second", "behind"])",
         "t.technique.json:11:", "'Second' writes 'behind', of format depth32", "r32f holds depths, too");
  refuse(kLayers, R"({"name": "behind", "extent": "map", "format": "depth32"})",
         R"({"name": "behind", "extent": "map", "format": "r32f"})",
         "'Second' has 'behind' as its depth, of format r32f", "depth16, depth24, depth32 and depth32s8");
  refuse(kLayers, R"("format": "depth32"},
    {"name": "second")",
         R"("format": "depth32", "mips": 2},
    {"name": "second")",
         "texture 'nearest': a depth target has one mip level");
}

TEST_F(CasterGraph, ADepthIsATextureOrTheShadowMap) {
  refuse(kLayers, R"("depth": "behind")", R"("depth": "behnd")", "there is no texture 'behnd'",
         "or test against \"shadowMap\"");
  refuse(kLayers, R"("depth": "behind")", R"("depth": "nearest")",
         "'Second' reads 'nearest', which it draws into");
  refuse(kLayers, R"("name": "behind")", R"("name": "shadowMap")",
         "texture 'shadowMap': the shadow map itself has that name");
  refuse(
      kLayers, R"({"name": "colour", "extent": "map")", R"({"name": "colour", "extent": "map", "divisor": 2)",
      "'Colour' tests against the shadow map, whose texels are not those of 'colour'", "the extent \"map\"");
  refuse(kLayers, R"("depth": "nearest")", R"("depth": "shadowMap")",
         "'Nearest' tests against the shadow map, and writes nothing");
  refuse(kLayers, R"(, "depth": "nearest")", "", "'Nearest' writes nothing", "\"writes\", \"depth\" or both");
  refuse(kLayers, R"({"name": "behind", "extent": "map")",
         R"({"name": "behind", "extent": "map", "divisor": 2)",
         "'Second' draws into 'second' and depth 'behind', which differ in size or samples");
}

TEST_F(CasterGraph, TheLightSeesThemOfEachCascadeAndTheCameraEveryFrame) {
  refuse(kLayers, R"("runs": "cascade", "depth": "nearest")", R"("depth": "nearest")",
         "'Nearest' draws casters into 'nearest', which each cascade has a part of",
         "add \"runs\": \"cascade\"");
  refuse(kLayers, R"({"name": "nearest", "extent": "map")",
         R"({"name": "nearest", "extent": "fixed", "size": [64, 64, 1])",
         "'Nearest' draws casters into 'nearest', which has a size of its own", "extents map and tile");
  refuse(kSeen, R"("kind": "casters")", R"("kind": "casters", "runs": "bake")",
         "'Seen' draws what the camera sees, which changes every frame");
  refuse(kSeen, R"("kind": "casters")", R"("kind": "casters", "runs": "cascade")",
         "'Seen' draws what the camera sees, which changes every frame");
}

TEST_F(CasterGraph, DrawsOpaqueCastersOrBlendedOnes) {
  EXPECT_TRUE(read(kLayers).techniques.at(0).graph.draws(DrawnCasters::opaque));
  EXPECT_FALSE(read(kLayers).techniques.at(0).graph.draws(DrawnCasters::blended));
  std::string text = kLayers;
  const std::string colour = R"("depth": "shadowMap"})";
  text.replace(text.find(colour), colour.size(), R"("depth": "shadowMap", "casters": "blended"})");
  const TechniqueList layers = read(text);
  const PassGraph& graph = layers.techniques.at(0).graph;
  EXPECT_EQ(graph.passes[0].casters, DrawnCasters::blended);
  EXPECT_EQ(graph.passes[1].casters, DrawnCasters::opaque);
  EXPECT_TRUE(graph.draws(DrawnCasters::blended) && graph.draws(DrawnCasters::opaque));
  const std::string rows = graph_rows(layers);
  EXPECT_THAT(rows, HasSubstr("\ttestsShadowMap\tblended\n"));
  EXPECT_EQ(rows.find("blended"), rows.rfind("blended"));
  EXPECT_THAT(techniques_json(layers), HasSubstr("\"casters\":\"blended\""));
}

TEST_F(CasterGraph, AStencilIsTestedAfterWhatChangesItAndThatAfterItsDepth) {
  const TechniqueList volumes = read(kVolumes);
  const PassGraph& graph = volumes.techniques.at(0).graph;
  std::vector<std::string> names;
  for (const GraphPass& pass : graph.passes) names.push_back(pass.name);
  EXPECT_THAT(names, ElementsAre("Depth", "Count", "Lit"));
  EXPECT_EQ(graph.passes[1].casters, DrawnCasters::volumes);
  EXPECT_EQ(graph.passes[1].stencil, "depth");
  EXPECT_TRUE(graph.draws(DrawnCasters::volumes) && graph.draws_casters() && graph.needs_camera());
  EXPECT_THAT(techniques_json(volumes), HasSubstrs("\"casters\":\"volumes\"", "\"stencil\":\"depth\""));
  EXPECT_EQ(graph_rows(volumes), "") << "the feature draws no such passes";
}

TEST_F(CasterGraph, AStencilHasAFormatASizeAndADepth) {
  refuse(kVolumes, "depth32s8", "depth32", "as its stencil, of format depth32", "give it depth32s8");
  refuse(kVolumes, R"("shader": "L.shader", "stencil": "depth"})", R"("shader": "L.shader"})",
         "'Count' writes nothing");
  refuse(kVolumes, R"("shader": "L.shader", "stencil": "depth"})",
         R"("shader": "L.shader", "depth": "depth"})",
         "'Count' draws shadow volumes without a stencil to count in");
  refuse(kVolumes, R"("shader": "L.shader", "stencil": "depth"})",
         R"("shader": "L.shader", "depth": "depth", "stencil": "depth"})",
         "'Count' has a depth and a stencil", "leave out \"depth\"");
  refuse(kVolumes, R"("stencil": "depth"})", R"("stencil": "dpth"})", "there is no texture 'dpth'");
  refuse(kVolumes, R"("depth": "depth"})", R"("stencil": "depth"})",
         "as its stencil, whose depth no casters draw");
  refuse(kVolumes, R"("name": "depth", )", R"("name": "depth", "divisor": 2, )",
         "'Lit' draws into 'visibility' and depth 'depth', which differ in size or samples");
  refuse(kVolumes, R"("name": "depth", )", R"("name": "depth", "extent": "map", )",
         "has a stencil, and is not drawn over the screen once a frame");
  refuse(kVolumes, R"("writes": ["visibility"])", R"("writes": ["visibility"], "reads": {"_Depth": "depth"})",
         "'Lit' reads 'depth', which is its stencil");
  refuse(kVolumes, R"("writes": ["visibility"])", R"("writes": ["visibility"], "runs": "bake")",
         "'Lit' has a stencil, and is not drawn over the screen once a frame");
}

}  // namespace
}  // namespace penumbra::techniques
