// Compares filters in a forward shader with the techniques whose filters they are: by their keyword and the
// one include of Shadows.hlsl, after the passes that make the maps that they read.
#include <gmock/gmock.h>

#include <tuple>

#include "platform/data_directory.h"
#include "resolve/drawn_scenes.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"

namespace penumbra::resolve {
namespace {

struct Keyword {
  const char* technique;
  const char* name;
};

class ForwardFilter : public testing::TestWithParam<std::tuple<bool, Keyword>> {
 protected:
  static bool reversed_z() { return std::get<0>(GetParam()); }
  static Keyword keyword() { return std::get<1>(GetParam()); }
  static ShadowGraph technique() { return library_graph(keyword().technique, reversed_z()); }

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
    shader.defines.emplace_back(keyword().name, "1");
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
    const scene::Frame frame = under_disc(drawn("trees", cascades, reversed_z()), degrees);
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

INSTANTIATE_TEST_SUITE_P(
    BothDirections, ForwardFilter,
    testing::Combine(testing::Bool(), testing::Values(Keyword{"pcss-bounded-16-16", "_PENUMBRA_PCSS_BOUNDED"},
                                                      Keyword{"moments-32", "_PENUMBRA_MSM"})),
    [](const auto& combined) {
      return std::string(std::get<0>(combined.param) ? "Reversed" : "Forward") +
             (std::get<1>(combined.param).name + 1);
    });

}  // namespace
}  // namespace penumbra::resolve
