// Runs graphs that are nothing but their files (tests/techniques/added): passes over the map for each
// cascade, mip levels, and a chain of kernels, against the same sums in C++.
#include "resolve/graph_runner.h"
#include "resolve/run_once.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "input/input_error_matcher.h"
#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"
#include "shaders/shader_files.h"

namespace penumbra::resolve {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;

float depth_of(double u, double v, int tile) {
  return static_cast<float>(0.1 + 0.2 * u * u + 0.3 * v * u + 0.1 * tile);
}

struct Means {
  const scene::ShadowAtlas& atlas;
  int tile;

  double depth(int x, int y) const {
    return static_cast<double>(atlas.depth[static_cast<std::size_t>(y * atlas.width + x)]);
  }
  // The mean of 5 x 5 texels, none of them beyond the tile.
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

techniques::TechniqueList added(const std::string& name) {
  return techniques::read_technique_list(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests" / "techniques" /
                                         "added" / (name + ".technique.json"));
}

TEST(GraphRunner, PassesOverTheMapRunForEachCascadeAndMipLevel) {
  const techniques::TechniqueList list = added("Means");
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 128;
  setup.shadows.cascades = 4;
  setup.cascade = 2;
  std::vector<testing_frames::TilePoint> receivers;
  constexpr int kColumns = 8;
  // The places do not lie where texels of the second level meet.
  for (int i = 0; i < kColumns * kColumns; ++i)
    receivers.emplace_back((i % kColumns * 2 + 0.9) / 17.0, (i / kColumns * 2 + 0.9) / 17.0, 0.5);
  const scene::Frame frame = testing_frames::make_frame(setup, depth_of, receivers, kColumns);
  GraphRunner runner(test_device(), compile(technique_graph(list, list.find("means"))));
  const GraphResult result = runner.run(FrameOnDevice(test_device(), frame), kCountedOnce);

  const glm::dvec4 tile = frame.cascades.cascades[2].offset_scale;
  const Means means{frame.atlas, frame.cascades.tile_resolution};
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const int x = static_cast<int>((tile.x + receivers[i].x * tile.z) * frame.atlas.width / 2.0);
    const int y = static_cast<int>((tile.y + receivers[i].y * tile.w) * frame.atlas.height / 2.0);
    EXPECT_NEAR(result.visibility[0][i], 0.5 * means.of_four(x, y), 1e-6) << i;
  }
  EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());

  // The texels of the map per pixel of the picture, and of its second level.
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
  // Every pass loads and writes texels of 4 bytes; the mip levels are one draw for each cascade and level.
  for (std::size_t i = 0; i + 1 < result.passes.size(); ++i) {
    const PassCounts& pass = result.passes[i];
    EXPECT_EQ(pass.bytes_read, 4.0 * pass.fetches) << pass.pass;
    EXPECT_EQ(pass.bytes_written, 4.0 * pass.texels_written) << pass.pass;
    EXPECT_EQ(pass.steps, 4) << pass.pass;
    EXPECT_FALSE(pass.groups) << pass.pass << " is drawn";
  }
  EXPECT_EQ(result.fetches_of_others, 12.0 * map);
  EXPECT_THAT(result.fetches, testing::Each(1U));
}

// The picture has 40 x 32 pixels.
constexpr int kBlocksWidth = 40, kBlocksHeight = 32;

GraphResult run_blocks(const std::string& manifest, const std::string& technique) {
  const techniques::TechniqueList list = added(manifest);
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 64;
  const std::vector<testing_frames::TilePoint> receivers(kBlocksWidth * kBlocksHeight, {0.5, 0.5, 0.5});
  const scene::Frame frame = testing_frames::make_frame(setup, depth_of, receivers, kBlocksWidth);
  const CameraImage camera = camera_image(frame);
  GraphRunner runner(test_device(), compile(technique_graph(list, list.find(technique))));
  return runner.run(FrameOnDevice(test_device(), frame), &camera, kCountedOnce);
}

bool marked(int x, int y) {
  return x < kBlocksWidth / 8 && y < kBlocksHeight / 8 && (x + 2 * y) % 3 == 0;
}

// unlisted is what the kernel that shades the listed blocks leaves in the others.
void expect_blocks(const GraphResult& result, double unlisted) {
  for (int y = 0; y < kBlocksHeight; ++y) {
    for (int x = 0; x < kBlocksWidth; ++x) {
      double sum = 0.0;
      for (int i = 0; i < 4; ++i) sum += marked(x / 16 * 2 + i % 2, y / 16 * 2 + i / 2) ? 1.0 : 0.0;
      const double expected = marked(x / 8, y / 8) ? sum / 4.0 : unlisted;
      ASSERT_EQ(result.visibility[0][static_cast<std::size_t>(y * kBlocksWidth + x)], expected)
          << x << ", " << y;
    }
  }
}

std::vector<std::string> pass_names(const GraphResult& result) {
  std::vector<std::string> names;
  for (const PassCounts& pass : result.passes) names.push_back(pass.pass);
  return names;
}

TEST(GraphRunner, KernelsFollowEachOther) {
  const GraphResult result = run_blocks("Blocks", "blocks");
  expect_blocks(result, 0.0);
  double blocks = 0.0;
  for (int y = 0; y < kBlocksHeight / 8; ++y)
    for (int x = 0; x < kBlocksWidth / 8; ++x) blocks += marked(x, y) ? 1.0 : 0.0;
  EXPECT_THAT(pass_names(result), ElementsAre("Mark", "Collect", "Sum", "Shade"));
  const double pixels = kBlocksWidth * kBlocksHeight;
  EXPECT_DOUBLE_EQ(result.passes[0].texels_written, 20.0 / pixels);
  EXPECT_DOUBLE_EQ(result.passes[1].fetches, 20.0 / pixels);
  EXPECT_DOUBLE_EQ(result.passes[1].texels_written, (1.0 + blocks) / pixels);
  EXPECT_DOUBLE_EQ(result.passes[2].fetches, 20.0 / pixels);
  EXPECT_DOUBLE_EQ(result.passes[3].texels_written, 64.0 * blocks / pixels);
  EXPECT_DOUBLE_EQ(result.passes[3].fetches, 64.0 * (31.0 + 2.0 * blocks) / pixels);
  // Single texels of 4 bytes. Groups of 4 x 4 threads cover 5 x 4 marks and 3 x 2 halves.
  std::vector<double> groups;
  for (const PassCounts& pass : result.passes) {
    EXPECT_EQ(pass.bytes_read, 4.0 * pass.fetches) << pass.pass;
    EXPECT_EQ(pass.bytes_written, 4.0 * pass.texels_written) << pass.pass;
    EXPECT_EQ(pass.steps, 1) << pass.pass;
    EXPECT_EQ(pass.barriers_per_group, 0.0) << pass.pass;
    groups.push_back(pass.groups.value());
  }
  EXPECT_THAT(groups, ElementsAre(2.0, 1.0, 1.0, 31.0));
}

TEST(GraphRunner, AKernelThatUpdatesATextureKeepsWhatItDoesNotWrite) {
  const GraphResult result = run_blocks("FilledBlocks", "blocks-filled");
  EXPECT_THAT(pass_names(result), ElementsAre("Mark", "Collect", "Sum", "Fill", "Shade"));
  expect_blocks(result, 0.125);
}

// Runs a graph that differs from the one of its manifest, and returns the message of the refusal.
std::string refusal(const ShadowGraph& graph) {
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 64;
  const std::vector<testing_frames::TilePoint> receivers(40 * 32, {0.5, 0.5, 0.5});
  const scene::Frame frame = testing_frames::make_frame(setup, depth_of, receivers, 40);
  const CameraImage camera = camera_image(frame);
  return input_error_of([&] {
    GraphRunner runner(test_device(), compile(graph));
    runner.run(FrameOnDevice(test_device(), frame), &camera, kCountedOnce);
  });
}

// Reading floats as integers is undefined in Vulkan.
TEST(GraphRunner, TexturesHaveTheNumbersThatTheirProgramsRead) {
  const techniques::TechniqueList list = added("Blocks");
  ShadowGraph graph = technique_graph(list, list.find("blocks"));
  EXPECT_EQ(refusal(graph), "no error");
  graph.graph.textures[2].format = "r32f";
  EXPECT_THAT(refusal(graph),
              HasSubstrs("Blocks.compute: Sum: '_Sums' is declared with components of uint, and the "
                         "texture that is bound to it has the format r32f",
                         "declare it with components of float, or change the format"));
}

TEST(GraphRunner, AMissingTextureIsNamedWithThePassInItsManifest) {
  const techniques::TechniqueList list = added("Blocks");
  ShadowGraph graph = technique_graph(list, list.find("blocks"));
  for (techniques::GraphPass& pass : graph.graph.passes)
    std::erase_if(pass.reads, [](const auto& read) { return read.first == "_Before"; });
  EXPECT_THAT(refusal(graph),
              AllOf(HasSubstr("Blocks.compute: Sum: reads the texture '_Before'"),
                    ContainsRegex("give it to the pass at .*Blocks.technique.json:11:6 in \"reads\"")));
}

TEST(GraphRunner, AManifestGivesAPassNoBuffers) {
  const shaders::ShaderFiles files;
  files.write("Buffers.compute", R"(#pragma kernel Fill
StructuredBuffer<float> _Numbers;
RWTexture2D<float> _Visibility;
[numthreads(8, 8, 1)] void Fill(uint3 id : SV_DispatchThreadID) { _Visibility[id.xy] = _Numbers[id.x]; }
)");
  const techniques::TechniqueList list =
      techniques::read_technique_list(files.write("Buffers.technique.json", R"({
"graphs": [{"name": "fill", "textures": [{"name": "visibility", "format": "r32f"}],
  "passes": [{"name": "Fill", "kind": "compute", "compute": "Buffers.compute",
              "writes": {"_Visibility": "visibility"}, "groups": {"texels_of": "visibility"}}],
  "visibility": "visibility"}],
"techniques": [{"name": "fill", "title": "Fill", "family": "fill", "source": "s", "graph": "fill"}]})"));
  EXPECT_THAT(
      refusal(technique_graph(list, list.find("fill"))),
      AllOf(HasSubstr("Buffers.compute: Fill: reads the buffer '_Numbers'"),
            ContainsRegex("a manifest gives the pass at .*Buffers.technique.json:3:15 textures alone")));
}

// Times are of runs after the warm-up alone; what the graph draws does not depend on it.
TEST(GraphRunner, TimesRunsAfterTheWarmUp) {
  const techniques::TechniqueList& list = library_techniques();
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 64;
  const scene::Frame frame = testing_frames::make_frame(
      setup, depth_of, std::vector<testing_frames::TilePoint>(64, {0.5, 0.5, 0.5}), 8);
  const FrameOnDevice on_device(test_device(), frame);
  GraphRunner runner(test_device(), compile(technique_graph(list, list.find("pcss-angular-24-16"))));
  RunOptions options{.noise_seeds = 3, .timing_repeats = 2};
  const GraphResult plain = runner.run(on_device, options);
  const auto seconds_of = [&](const RunOptions& chosen, GraphResult& result) {
    const auto start = std::chrono::steady_clock::now();
    result = runner.run(on_device, chosen);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  GraphResult warmed;
  options.warm_up_seconds = 0.3;
  EXPECT_GE(seconds_of(options, warmed), 0.3);
  EXPECT_EQ(warmed.time_ns.size(), 2U);
  EXPECT_EQ(warmed.visibility, plain.visibility);
  options.timing_repeats = 0;
  options.warm_up_seconds = 600.0;
  EXPECT_LT(seconds_of(options, warmed), 300.0) << "nothing is timed";
  EXPECT_TRUE(warmed.time_ns.empty());
}

TEST(GraphRunner, AGraphOverTheScreenNeedsACamera) {
  const techniques::TechniqueList list = added("Blocks");
  testing_frames::FrameSetup setup;
  setup.shadows.resolution = 64;
  const scene::Frame frame = testing_frames::make_frame(
      setup, depth_of, std::vector<testing_frames::TilePoint>(64, {0.5, 0.5, 0.5}), 8);
  GraphRunner runner(test_device(), compile(technique_graph(list, list.find("blocks"))));
  EXPECT_THROW(runner.run(FrameOnDevice(test_device(), frame), kCountedOnce), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::resolve
