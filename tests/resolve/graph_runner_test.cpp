// Graphs that are nothing but their files: passes over the map for each cascade, mip levels, and a chain of
// kernels with an indirect dispatch, against the same sums in C++.
#include "resolve/graph_runner.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"
#include "shaders/shader_files.h"

namespace penumbra::resolve {
namespace {

using testing::ElementsAre;

constexpr RunOptions kOnce{.noise_seeds = 1, .timing_repeats = 0};

// Mean depth of 5 x 5 texels and, a level higher, of 2 x 2 of these: no filter for shadows, but every number
// is known.
constexpr const char* kMeansManifest = R"({
"graphs": [{"name": "means",
  "textures": [
    {"name": "depths", "extent": "map", "format": "r32f"},
    {"name": "rows", "extent": "map", "format": "r32f"},
    {"name": "blurred", "extent": "map", "format": "r32f", "mips": 2}],
  "passes": [
    {"name": "filter", "kind": "filter",
     "filter": {"file": "Means.hlsl", "function": "FilterMeans", "arguments": ["blurred"], "parameters": "MeansParameters"}},
    {"name": "Mips", "kind": "raster", "shader": "Means.shader", "runs": "cascade",
     "reads": {"_PenumbraSourceTexture": "blurred"}, "writes": ["blurred"], "each_mip": true},
    {"name": "Columns", "kind": "raster", "shader": "Means.shader", "runs": "cascade",
     "reads": {"_PenumbraSourceTexture": "rows"}, "writes": ["blurred"]},
    {"name": "Rows", "kind": "raster", "shader": "Means.shader", "runs": "cascade",
     "reads": {"_PenumbraSourceTexture": "depths"}, "writes": ["rows"]},
    {"name": "Depths", "kind": "raster", "shader": "Means.shader", "runs": "cascade", "writes": ["depths"]}]}],
"structs": [{"name": "MeansParameters", "doc": "Of the test.",
             "fields": [{"name": "level", "type": "int", "unit": "1", "doc": "mip level", "range": [0, 1]},
                        {"name": "scale", "type": "float", "unit": "1", "doc": "of the result"}]}],
"techniques": [{"name": "means", "title": "Means", "family": "means", "source": "s", "graph": "means",
                "values": {"level": 1, "scale": 0.5}}]})";

constexpr const char* kMeansShader = R"(Shader "Hidden/Means" { SubShader {
Pass { Name "Depths" HLSLPROGRAM
#pragma vertex ScreenTriangle
#pragma fragment Depths
#include "MeansPasses.hlsl"
ENDHLSL }
Pass { Name "Rows" HLSLPROGRAM
#pragma vertex ScreenTriangle
#pragma fragment Rows
#include "MeansPasses.hlsl"
ENDHLSL }
Pass { Name "Columns" HLSLPROGRAM
#pragma vertex ScreenTriangle
#pragma fragment Columns
#include "MeansPasses.hlsl"
ENDHLSL }
Pass { Name "Mips" HLSLPROGRAM
#pragma vertex ScreenTriangle
#pragma fragment Mips
#include "MeansPasses.hlsl"
ENDHLSL } } }
)";

constexpr const char* kMeansPasses = R"(
#include "Packages/com.penumbra.shadows/Shaders/ScreenPass.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Pipelines/Urp.hlsl"
float4 _PenumbraTile;
float4 Depths(ScreenVaryings input) : SV_Target
{
    return LOAD_TEXTURE2D(_MainLightShadowmapTexture, int2(input.positionCS.xy)).x;
}
float MeanAlong(int2 texel, int2 direction)
{
    const int2 low = int2(_PenumbraTile.xy);
    const int2 high = low + int2(_PenumbraTile.zw) - 1;
    float sum = 0.0;
    for (int i = -2; i <= 2; ++i)
        sum += LOAD_TEXTURE2D_X(_PenumbraSourceTexture, min(max(texel + i * direction, low), high)).x;
    return sum / 5.0;
}
float4 Rows(ScreenVaryings input) : SV_Target { return MeanAlong(int2(input.positionCS.xy), int2(1, 0)); }
float4 Columns(ScreenVaryings input) : SV_Target { return MeanAlong(int2(input.positionCS.xy), int2(0, 1)); }
float4 Mips(ScreenVaryings input) : SV_Target
{
    const int2 first = 2 * int2(input.positionCS.xy);
    float sum = 0.0;
    for (int i = 0; i < 4; ++i)
        sum += LOAD_TEXTURE2D_X(_PenumbraSourceTexture, first + int2(i % 2, i / 2)).x;
    return 0.25 * sum;
}
)";

constexpr const char* kMeansFilter = R"(
#include "Core/ShadowStructs.hlsl"
struct MeansParameters { int level; float scale; };
MeansParameters UnpackMeansParameters(float4 packed0)
{
    MeansParameters parameters;
    parameters.level = int(packed0.x);
    parameters.scale = packed0.y;
    return parameters;
}
float FilterMeans(TEXTURE2D(blurred), ShadowReceiver receiver, ShadowTile tile, MeansParameters parameters)
{
    const float2 texel = receiver.shadowCoord.xy * tile.atlasTexelSize.zw * exp2(-float(parameters.level));
    return parameters.scale * LOAD_TEXTURE2D_LOD(blurred, int2(texel), parameters.level).x;
}
)";

float depth_of(double u, double v, int tile) {
  return static_cast<float>(0.1 + 0.2 * u * u + 0.3 * v * u + 0.1 * tile);
}

struct Means {
  const scene::ShadowAtlas& atlas;
  int tile;

  double depth(int x, int y) const {
    return static_cast<double>(atlas.depth[static_cast<std::size_t>(y * atlas.width + x)]);
  }
  // Of 5 x 5 texels, none beyond the tile.
  double blurred(int x, int y) const {
    const auto inside = [&](int i, int of) {
      const int low = of / tile * tile;
      return std::clamp(i, low, low + tile - 1);
    };
    double sum = 0.0;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) sum += depth(inside(x + dx, x), inside(y + dy, y));
    return sum / 25.0;
  }
  double of_four(int x, int y) const {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) sum += blurred(2 * x + i % 2, 2 * y + i / 2);
    return sum / 4.0;
  }
};

class GraphRunnerTest : public testing::Test {
 protected:
  techniques::TechniqueList read(const std::string& name, const std::string& text) const {
    return techniques::read_technique_list(files_.write(name + ".technique.json", text));
  }
  shaders::ShaderFiles files_;
};

TEST_F(GraphRunnerTest, PassesOverTheMapRunForEachCascadeAndMipLevel) {
  files_.write("Means.shader", kMeansShader);
  files_.write("MeansPasses.hlsl", kMeansPasses);
  files_.write("Means.hlsl", kMeansFilter);
  const techniques::TechniqueList list = read("Means", kMeansManifest);
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 128;
  setup.shadows.cascades = 4;
  setup.cascade = 2;
  std::vector<testing_frames::TilePoint> receivers;
  constexpr int kColumns = 8;
  for (int i = 0; i < kColumns * kColumns; ++i)  // not where texels of the second level meet
    receivers.emplace_back((i % kColumns * 2 + 0.9) / 17.0, (i / kColumns * 2 + 0.9) / 17.0, 0.5);
  const scene::Frame frame = testing_frames::make_frame(setup, depth_of, receivers, kColumns);
  GraphRunner runner(test_device(), compile(technique_graph(list, list.find("means"))));
  const GraphResult result = runner.run(FrameOnDevice(test_device(), frame), kOnce);

  const glm::dvec4 tile = frame.cascades.cascades[2].offset_scale;
  const Means means{frame.atlas, frame.cascades.tile_resolution};
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const int x = static_cast<int>((tile.x + receivers[i].x * tile.z) * frame.atlas.width / 2.0);
    const int y = static_cast<int>((tile.y + receivers[i].y * tile.w) * frame.atlas.height / 2.0);
    EXPECT_NEAR(result.visibility[0][i], 0.5 * means.of_four(x, y), 1e-6) << i;
  }
  EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());

  // Texels of the map per pixel of the picture, and of its second level.
  const double map = static_cast<double>(frame.atlas.width) * frame.atlas.height / (kColumns * kColumns);
  std::vector<std::string> names;
  std::vector<double> fetches, written;
  for (const PassCounts& pass : result.passes) {
    names.push_back(pass.pass);
    fetches.push_back(pass.fetches);
    written.push_back(pass.texels_written);
  }
  EXPECT_THAT(names, ElementsAre("Depths", "Rows", "Columns", "Mips", "filter"));
  EXPECT_THAT(fetches, ElementsAre(map, 5.0 * map, 5.0 * map, map, 1.0));
  EXPECT_THAT(written, ElementsAre(map, map, map, 0.25 * map, 0.0));
  EXPECT_EQ(result.passes[0].frequency, techniques::Frequency::cascade);
  EXPECT_EQ(result.fetches_of_others, 12.0 * map);
  EXPECT_THAT(result.fetches, testing::Each(1U));
}

// Blocks of 8 x 8 pixels that a kernel marks are listed by another, and the listed ones alone are written.
constexpr const char* kBlocksManifest = R"({
"graphs": [{"name": "blocks",
  "textures": [{"name": "visibility", "format": "r32f"}, {"name": "marks", "divisor": 8, "format": "r32ui"},
               {"name": "halves", "divisor": 8, "format": "r32ui", "mips": 2}],
  "buffers": [{"name": "groups", "words": 3, "indirect": true},
              {"name": "list", "words_per_texel": 1, "texture": "marks"}],
  "passes": [
    {"name": "Shade", "kind": "compute", "compute": "Blocks.compute", "reads": {"_List": "list", "_Halves": "halves"},
     "writes": {"_Visibility": "visibility"}, "groups": {"indirect": "groups"}},
    {"name": "Collect", "kind": "compute", "compute": "Blocks.compute", "reads": {"_MarksRead": "marks"},
     "writes": {"_Groups": "groups", "_List": "list"}, "groups": {"fixed": [1, 1, 1]}},
    {"name": "Sum", "kind": "compute", "compute": "Blocks.compute", "reads": {"_Before": "halves"},
     "writes": {"_Sums": "halves"}, "each_mip": true, "groups": {"texels_of": "halves"}},
    {"name": "Mark", "kind": "compute", "compute": "Blocks.compute", "writes": {"_Marks": "marks", "_Sums": "halves"},
     "groups": {"texels_of": "marks"}}],
  "visibility": "visibility"}],
"techniques": [{"name": "blocks", "title": "Blocks", "family": "blocks", "source": "s", "graph": "blocks"}]})";

constexpr const char* kBlocks = R"(
#pragma kernel Mark
#pragma kernel Sum
#pragma kernel Collect
#pragma kernel Shade
float4 _PenumbraTargetSize;
float4 _MarksReadSize;
float4 _BeforeSize;
RWTexture2D<uint> _Marks;
RWTexture2D<uint> _Sums;
Texture2D<uint> _Before;
Texture2D<uint> _Halves;
Texture2D<uint> _MarksRead;
RWStructuredBuffer<uint> _Groups;
RWStructuredBuffer<uint> _List;
RWTexture2D<float> _Visibility;

[numthreads(4, 4, 1)]
void Mark(uint3 id : SV_DispatchThreadID)
{
    if (any(id.xy >= uint2(_PenumbraTargetSize.xy))) return;
    const uint marked = (id.x + 2 * id.y) % 3 == 0 ? 1 : 0;
    _Marks[id.xy] = marked;
    _Sums[id.xy] = marked;
}

[numthreads(4, 4, 1)]
void Sum(uint3 id : SV_DispatchThreadID)
{
    if (any(id.xy >= uint2(_PenumbraTargetSize.xy))) return;
    uint sum = 0;
    for (uint i = 0; i < 4; ++i) sum += _Before.Load(int3(2 * id.xy + uint2(i % 2, i / 2), 0));
    _Sums[id.xy] = sum;
}

[numthreads(1, 1, 1)]
void Collect(uint3 id : SV_DispatchThreadID)
{
    const uint2 size = uint2(_MarksReadSize.xy);
    uint count = 0;
    for (uint y = 0; y < size.y; ++y)
        for (uint x = 0; x < size.x; ++x)
            if (_MarksRead.Load(int3(x, y, 0)) != 0)
            {
                _List[count] = x + (y << 16);
                ++count;
            }
    _Groups[0] = count;
    _Groups[1] = 1;
    _Groups[2] = 1;
}

[numthreads(8, 8, 1)]
void Shade(uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID)
{
    const uint2 block = uint2(_List[group.x] & 0xffff, _List[group.x] >> 16);
    const uint2 pixel = 8 * block + thread.xy;
    if (any(pixel >= uint2(_PenumbraTargetSize.xy))) return;
    _Visibility[pixel] = float(_Halves.Load(int3(block / 2, 1))) / 4.0;
}
)";

TEST_F(GraphRunnerTest, KernelsFollowEachOtherOverAPyramidAndAnIndirectDispatch) {
  files_.write("Blocks.compute", kBlocks);
  const techniques::TechniqueList list = read("Blocks", kBlocksManifest);
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 64;
  constexpr int kWidth = 40, kHeight = 32;
  const std::vector<testing_frames::TilePoint> receivers(kWidth * kHeight, {0.5, 0.5, 0.5});
  const scene::Frame frame = testing_frames::make_frame(setup, depth_of, receivers, kWidth);
  const CameraImage camera = camera_image(frame);
  GraphRunner runner(test_device(), compile(technique_graph(list, list.find("blocks"))));
  const GraphResult result = runner.run(FrameOnDevice(test_device(), frame), &camera, kOnce);

  const auto marked = [](int x, int y) { return (x + 2 * y) % 3 == 0; };
  double blocks = 0.0;
  for (int y = 0; y < kHeight / 8; ++y)
    for (int x = 0; x < kWidth / 8; ++x) blocks += marked(x, y) ? 1.0 : 0.0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      double sum = 0.0;
      for (int i = 0; i < 4; ++i) sum += marked(x / 16 * 2 + i % 2, y / 16 * 2 + i / 2) ? 1.0 : 0.0;
      const bool in_pyramid = x / 16 < kWidth / 8 / 2;  // an odd number of blocks: the last has no half
      const double expected = marked(x / 8, y / 8) && in_pyramid ? sum / 4.0 : 0.0;
      ASSERT_EQ(result.visibility[0][static_cast<std::size_t>(y * kWidth + x)], expected) << x << ", " << y;
    }
  }
  std::vector<std::string> names;
  for (const PassCounts& pass : result.passes) names.push_back(pass.pass);
  EXPECT_THAT(names, ElementsAre("Mark", "Collect", "Sum", "Shade"));
  const double pixels = kWidth * kHeight;
  EXPECT_DOUBLE_EQ(result.passes[0].texels_written, 2.0 * 20.0 / pixels);
  EXPECT_DOUBLE_EQ(result.passes[1].fetches, 20.0 / pixels);
  EXPECT_DOUBLE_EQ(result.passes[2].fetches, 4.0 * 4.0 / pixels);
  EXPECT_DOUBLE_EQ(result.passes[3].texels_written, 64.0 * blocks / pixels);
  EXPECT_DOUBLE_EQ(result.passes[3].fetches, 64.0 * blocks / pixels);
}

TEST_F(GraphRunnerTest, AGraphOverTheScreenNeedsACamera) {
  files_.write("Blocks.compute", kBlocks);
  const techniques::TechniqueList list = read("Blocks", kBlocksManifest);
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 64;
  const scene::Frame frame = testing_frames::make_frame(
      setup, depth_of, std::vector<testing_frames::TilePoint>(64, {0.5, 0.5, 0.5}), 8);
  GraphRunner runner(test_device(), compile(technique_graph(list, list.find("blocks"))));
  EXPECT_THROW(runner.run(FrameOnDevice(test_device(), frame), kOnce), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::resolve
