// The renderer feature's resolve pass with exits against the same pass without: every technique that the
// feature offers them for, with the passes of the manifest's graph before it. Not a bit may differ.
#include <gmock/gmock.h>

#include <algorithm>

#include "resolve/drawn_scenes.h"
#include "resolve/graph_runner.h"
#include "resolve/hand_graph.h"
#include "techniques/technique_call.h"

namespace penumbra::resolve {
namespace {

constexpr RunOptions kScreenOnce{.noise_seeds = 1, .timing_repeats = 0};

struct ExitsCase {
  std::string technique;
  std::string keyword;  // empty: without one
  bool reversed_z;
  bool masked;
};

void PrintTo(const ExitsCase& value, std::ostream* stream) {
  *stream << value.technique << (value.masked ? ", masked" : "")
          << (value.reversed_z ? ", reversed Z" : ", conventional Z");
}

const techniques::PassGraph& exits_graph() {
  const std::vector<techniques::NamedGraph>& graphs = library_techniques().graphs;
  const auto found = std::find_if(graphs.begin(), graphs.end(), [](const auto& graph) {
    return graph.name == "exits" && graph.manifest == "Shaders/PenumbraShadows.technique.json";
  });
  if (found == graphs.end()) throw std::logic_error("the feature's manifest has no graph 'exits'");
  return found->graph;
}

class ScreenExits : public testing::TestWithParam<ExitsCase> {
 protected:
  static ShadowGraph without() {
    std::vector<std::string> keywords;
    if (!GetParam().keyword.empty()) keywords.push_back(GetParam().keyword);
    if (GetParam().masked) keywords.emplace_back("_PENUMBRA_MASK");
    ShadowGraph graph = GetParam().masked ? hand_graph({{"PenumbraMask", 4},
                                                        {"MaskBlurHorizontal", 4, true},
                                                        {"MaskBlurVertical", 4, true},
                                                        {"Resolve"}},
                                                       GetParam().reversed_z, keywords, 2)
                                          : hand_graph({{"Resolve"}}, GetParam().reversed_z, keywords);
    const techniques::TechniqueList& list = library_techniques();
    graph.parameters = parameter_uniforms(
        list, list.find(GetParam().masked ? "screen-pcss-angular-24-16-masked" : GetParam().technique));
    return graph;
  }

  static ShadowGraph with() {
    ShadowGraph graph = without();
    const techniques::PassGraph& first = exits_graph();
    graph.keywords.insert(graph.keywords.end(), first.keywords.begin(), first.keywords.end());
    graph.graph.textures.insert(graph.graph.textures.end(), first.textures.begin(), first.textures.end());
    for (techniques::GraphPass& pass : graph.graph.passes)
      if (pass.program == "Resolve")
        for (const techniques::GraphTexture& texture : first.textures)
          pass.reads.emplace_back(techniques::argument_name(texture.name), texture.name);
    std::vector<techniques::GraphPass> passes = first.passes;
    std::erase_if(passes, [](const auto& pass) { return pass.kind == techniques::PassKind::filter; });
    graph.graph.passes.insert(graph.graph.passes.begin(), passes.begin(), passes.end());
    return graph;
  }
};

TEST_P(ScreenExits, ChangeNoBit) {
  GraphRunner filter(test_device(), compile(without()));
  GraphRunner exits(test_device(), compile(with()));
  long others = 0;  // pixels that have read otherwise than without exits
  long fewer = 0;
  for (const std::string& scene : scenes_for_small_pictures()) {
    for (const auto& [cascades, degrees] : {std::pair(4, 0.53), {1, 5.0}}) {
      const scene::Frame frame = under_disc(drawn(scene, cascades, GetParam().reversed_z), degrees);
      const FrameOnDevice on_device(test_device(), frame);
      const CameraImage camera = camera_image(frame);
      const GraphResult before = filter.run(on_device, &camera, kScreenOnce);
      const GraphResult result = exits.run(on_device, &camera, kScreenOnce);
      EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
      for (std::size_t i = 0; i < before.visibility[0].size(); ++i) {
        ASSERT_EQ(result.visibility[0][i], before.visibility[0][i])
            << scene << ", " << degrees << " degrees, pixel " << i;
        others += result.fetches[i] != before.fetches[i] ? 1 : 0;
        fewer += result.fetches[i] < before.fetches[i] ? 1 : 0;
      }
    }
  }
  std::printf("%-24s other fetches at %ld pixels, fewer at %ld\n", GetParam().technique.c_str(), others,
              fewer);
  EXPECT_GT(others, GetParam().masked ? 500 : 10000);
  if (GetParam().technique == "pcss-angular-24-16" && !GetParam().masked) {
    EXPECT_GT(fewer, 10000);
  }
}

std::vector<ExitsCase> exits_cases() {
  std::vector<ExitsCase> cases;
  for (const techniques::Selection& selection : library_techniques().selections) {
    if (!selection.value || !selection.has_exits()) continue;
    for (const bool reversed_z : {true, false})
      cases.push_back({selection.technique, selection.keyword, reversed_z, false});
  }
  cases.push_back({"pcss-angular-24-16", "_PENUMBRA_PCSS", true, true});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Package, ScreenExits, testing::ValuesIn(exits_cases()), [](const auto& instance) {
  std::string name = instance.param.technique + (instance.param.masked ? "_masked" : "") +
                     (instance.param.reversed_z ? "_reversed" : "_conventional");
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(ScreenExitsOfTheLibrary, AreOfferedForEveryFilterThatHasThem) {
  const techniques::TechniqueList& list = library_techniques();
  int offered = 0;
  for (const techniques::Selection& selection : list.selections) {
    const auto has = [&](const techniques::Technique& technique) {
      return technique.name == selection.technique + techniques::exits_ending;
    };
    EXPECT_EQ(selection.has_exits(), std::any_of(list.with_exits.begin(), list.with_exits.end(), has))
        << selection.name;
    offered += selection.value && selection.has_exits() ? 1 : 0;
  }
  EXPECT_GE(offered, 11);
}

// What is measured as NAME-exits and what the feature draws are one and the same.
TEST(ScreenExitsOfTheLibrary, HaveThePassesOfWhatIsMeasured) {
  const techniques::PassGraph& drawn_first = exits_graph();
  const techniques::PassGraph& measured = library_techniques().find("pcss-angular-24-16-exits").graph;
  ASSERT_EQ(drawn_first.textures.size(), 1U);
  ASSERT_EQ(measured.textures.size(), 1U);
  const techniques::GraphTexture& planes = drawn_first.textures[0];
  EXPECT_EQ(planes.name, measured.textures[0].name);
  EXPECT_EQ(planes.extent, measured.textures[0].extent);
  EXPECT_EQ(planes.divisor, measured.textures[0].divisor);
  EXPECT_EQ(planes.format, measured.textures[0].format);
  EXPECT_EQ(planes.mips, measured.textures[0].mips);
  ASSERT_EQ(drawn_first.passes.size(), measured.passes.size());
  for (std::size_t i = 0; i < measured.passes.size(); ++i) {
    const techniques::GraphPass& one = drawn_first.passes[i];
    const techniques::GraphPass& other = measured.passes[i];
    EXPECT_EQ(one.kind, other.kind);
    EXPECT_EQ(one.frequency, other.frequency);
    EXPECT_EQ(one.file, other.file);
    EXPECT_EQ(one.program, other.program);
    EXPECT_EQ(one.reads, other.reads);
    EXPECT_EQ(one.writes, other.writes);
    EXPECT_EQ(one.each_mip, other.each_mip);
  }
  EXPECT_TRUE(drawn_first.filter()->exits);
  EXPECT_EQ(drawn_first.keywords, std::vector<std::string>{techniques::exits_keyword});
}

}  // namespace
}  // namespace penumbra::resolve
