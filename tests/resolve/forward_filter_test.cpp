// Compares a filter that reads maps, in a forward shader, with the technique whose filter it is: by its
// keyword and the one include of Shadows.hlsl, after the passes that make its maps. Cell PCSS's kernels
// make the same maps.
#include <gmock/gmock.h>

#include "platform/data_directory.h"
#include "resolve/drawn_scenes.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"

namespace penumbra::resolve {
namespace {

class ForwardFilter : public testing::TestWithParam<bool> {
 protected:
  static ShadowGraph technique() { return library_graph("cell-pcss-pixel", GetParam()); }

  static std::vector<std::string> maps_of(const ShadowGraph& graph) {
    std::vector<std::string> names;
    for (const techniques::GraphTexture& texture : graph.graph.textures) names.push_back(texture.name);
    return names;
  }

  // The forward filter after Cell PCSS's passes over the map.
  static ShadowGraph forward_after_kernels() {
    ShadowGraph graph = forward();
    const techniques::PassGraph& cell_pcss = library_techniques().find("cell-pcss").graph;
    EXPECT_THAT(cell_pcss.published, testing::ElementsAreArray(maps_of(graph)));
    const techniques::GraphPass filter = graph.graph.passes.back();
    graph.graph.textures.clear();
    for (const std::string& name : cell_pcss.published)
      graph.graph.textures.push_back(*cell_pcss.texture(name));
    graph.graph.passes.clear();
    for (const techniques::GraphPass& pass : cell_pcss.passes)
      if (techniques::writes_to(pass, cell_pcss.published.front()) ||
          techniques::writes_to(pass, cell_pcss.published.back()))
        graph.graph.passes.push_back(pass);
    graph.graph.passes.push_back(filter);
    return graph;
  }

  // The graph of a shader written as a user writes it.
  static ShadowGraph forward() {
    ShadowGraph graph = technique();
    ShadowShader& shader = *graph.filter;
    shader.name = "forward";
    shader.body = R"(
#define PENUMBRA_ADAPTER 1
#define PENUMBRA_MAPS_BOUND
#include "Platform/Platform.hlsl"
#include "UrpGlobals.hlsl"
#include "Packages/com.penumbra.shadows/ShaderLibrary/Shadows.hlsl"
float ShadowVisibility(float3 positionWS, float3 normalWS, float2 pixel)
{
    return PenumbraMainLightVisibility(positionWS, normalWS, pixel);
}
)";
    shader.defines.emplace_back("_PENUMBRA_CELL_PCSS", "1");
    shader.include_directories.push_back(platform::data_directory() /
                                         "tools/programs/shaders/unity/"
                                         "com.unity.render-pipelines.universal/ShaderLibrary");
    shader.fragment = true;
    return graph;
  }
};

// Both compute the same numbers from the same matrices: one in double and rounded, the other in float.
TEST_P(ForwardFilter, IsThatOfItsTechnique) {
  GraphRunner by_technique(test_device(), compile(technique()));
  GraphRunner by_include(test_device(), compile(forward()));
  for (const auto& [cascades, degrees] : {std::pair(4, 0.53), {4, 2.0}, {1, 5.0}}) {
    const scene::Frame frame = under_disc(drawn("trees", cascades, GetParam()), degrees);
    const FrameOnDevice on_device(test_device(), frame);
    const GraphResult expected = by_technique.run(on_device, kCountedOnce);
    const GraphResult result = by_include.run(on_device, kCountedOnce);
    EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
    const std::vector<float>& visibility = expected.visibility[0];
    long in_penumbra = 0;
    long read_others = 0;
    for (std::size_t i = 0; i < visibility.size(); ++i) {
      ASSERT_NEAR(result.visibility[0][i], visibility[i], 1e-6F) << degrees << " degrees, receiver " << i;
      if (visibility[i] > 0.0F && visibility[i] < 1.0F) ++in_penumbra;
      if (result.fetches[i] != expected.fetches[i]) ++read_others;
    }
    EXPECT_GT(in_penumbra, 500) << degrees << " degrees";
    EXPECT_LE(read_others, 4) << degrees << " degrees";
  }
}

TEST_P(ForwardFilter, IsTheSameAfterKernelsOfCellPcss) {
  GraphRunner after_draws(test_device(), compile(forward()));
  GraphRunner after_kernels(test_device(), compile(forward_after_kernels()));
  for (const auto& [cascades, degrees] : {std::pair(4, 2.0), {1, 5.0}}) {
    const scene::Frame frame = under_disc(drawn("trees", cascades, GetParam()), degrees);
    const FrameOnDevice on_device(test_device(), frame);
    EXPECT_EQ(after_kernels.run(on_device, kCountedOnce).visibility[0],
              after_draws.run(on_device, kCountedOnce).visibility[0])
        << degrees << " degrees";
  }
}

INSTANTIATE_TEST_SUITE_P(BothDirections, ForwardFilter, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
