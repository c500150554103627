// Exits before every filter that has them: where the planes of the map decide, they decide what the filter
// gives, bit for bit, over the built-in scenes and over adversarial maps.
#include <gmock/gmock.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <random>

#include "input/text_file.h"
#include "resolve/adversarial_maps.h"
#include "resolve/drawn_scenes.h"
#include "resolve/graph_runner.h"

namespace penumbra::resolve {
namespace {

constexpr RunOptions kExitsOnce{.noise_seeds = 1, .timing_repeats = 0, .count_fetches = false};
constexpr float kLeftToFilter = 0.5F;

class FilterExits : public testing::TestWithParam<bool> {
 protected:
  struct Chains {
    std::unique_ptr<GraphRunner> filter;   // without exits
    std::unique_ptr<GraphRunner> exits;    // as it is measured
    std::unique_ptr<GraphRunner> decides;  // kLeftToFilter in place of the filter
  };

  static Chains& chains(const techniques::Technique& with_exits) {
    static KeptOnDevice<std::map<std::pair<std::string, bool>, Chains>> kept;
    Chains& made = (*kept)[{with_exits.name, GetParam()}];
    if (made.filter != nullptr) return made;
    const techniques::TechniqueList& list = library_techniques();
    const std::string name =
        with_exits.name.substr(0, with_exits.name.size() - std::string(techniques::exits_ending).size());
    const auto runner = [](const ShadowGraph& graph) {
      return std::make_unique<GraphRunner>(test_device(), compile(graph));
    };
    made.filter = runner(technique_graph(list, list.find(name), Taps::as_listed, GetParam()));
    ShadowGraph graph = technique_graph(list, with_exits, Taps::as_listed, GetParam());
    made.exits = runner(graph);
    std::string& text = graph.filter->body;
    const std::size_t last = text.rfind("    return ");
    text.replace(last, text.find(';', last) - last, "    return " + std::to_string(kLeftToFilter));
    made.decides = runner(graph);
    return made;
  }

  struct Decided {
    long lit = 0;
    long dark = 0;
    long left = 0;
  };

  static void expect_lossless(const techniques::Technique& technique, const scene::Frame& frame,
                              const std::string& what, Decided& decided) {
    const FrameOnDevice on_device(test_device(), frame);
    Chains& run = chains(technique);
    const std::vector<float> filtered = run.filter->run(on_device, kExitsOnce).visibility[0];
    const std::vector<float> decisions = run.decides->run(on_device, kExitsOnce).visibility[0];
    const std::vector<float> with_exits = run.exits->run(on_device, kExitsOnce).visibility[0];
    for (std::size_t i = 0; i < filtered.size(); ++i) {
      ASSERT_EQ(with_exits[i], filtered[i]) << technique.name << ", " << what << ", receiver " << i;
      if (frame.receivers.position_ws[i].w == 0.0F) continue;
      const float answer = decisions[i];
      (answer == 1.0F ? decided.lit : answer == 0.0F ? decided.dark : decided.left) += 1;
      if (answer != kLeftToFilter) {
        ASSERT_EQ(answer, filtered[i]) << technique.name << ", " << what << ", receiver " << i;
      }
    }
  }

  static bool may_be_dark(const techniques::Technique& technique) {
    return technique.family != "unreal-smrt";
  }
};

TEST(FilterExitsOfTheLibrary, AreForEveryTechniqueOrItSaysWhyNot) {
  const techniques::TechniqueList& list = library_techniques();
  std::string page = read_text_file(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "Documentation~/exits.md");
  page.erase(0, page.find("## Techniques without exits"));
  for (const techniques::Technique& technique : list.techniques) {
    const bool has = std::any_of(list.with_exits.begin(), list.with_exits.end(), [&](const auto& other) {
      return other.name == technique.name + techniques::exits_ending;
    });
    EXPECT_NE(has, !technique.no_exits.empty()) << technique.name;
    if (has) continue;
    std::string reason = technique.no_exits;
    reason.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(reason.front())));
    const std::size_t named = page.find("`" + technique.name + "`");
    ASSERT_NE(named, std::string::npos) << technique.name;
    const std::string line = page.substr(named, page.find('\n', named) - named);
    EXPECT_THAT(line, testing::EndsWith(": " + reason)) << technique.name;
  }
  EXPECT_GT(list.with_exits.size(), 30U);
}

TEST_P(FilterExits, ChangeNoPixelOfAnyScene) {
  for (const techniques::Technique& technique : library_techniques().with_exits) {
    Decided all;
    for (const std::string& scene : scenes_for_small_pictures())
      for (const auto& [cascades, degrees] : {std::pair(4, 0.53), {1, 5.0}})
        expect_lossless(technique, under_disc(drawn(scene, cascades, GetParam()), degrees),
                        scene + ", " + std::to_string(degrees) + " degrees", all);
    std::printf("%-34s lit %ld, dark %ld, left %ld\n", technique.name.c_str(), all.lit, all.dark, all.left);
    EXPECT_GT(all.lit + all.dark, 1000) << technique.name;
    EXPECT_GT(all.left, 1000) << technique.name;
  }
}

// All adversarial maps, side by side in one tile.
class Patchwork {
 public:
  static constexpr int kPatch = 64;

  double operator()(int x, int y) const {
    const auto patch = static_cast<std::size_t>(x / kPatch + y / kPatch * 8) % maps_.size();
    return maps_[patch].height(x, y);
  }

 private:
  std::vector<NamedHeights> maps_ = adversarial_maps();
};

TEST_P(FilterExits, ChangeNoReceiverOfAdversarialMaps) {
  constexpr int kSide = 160;
  std::mt19937 random(5);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const Patchwork patchwork;
  for (const techniques::Technique& technique : library_techniques().with_exits) {
    Decided all;
    // How a comparison sampler compares NaN depends on the device.
    const bool compares = !technique.graph.filter()->takes("pointSampler") && technique.family != "hard";
    for (const double degrees : {0.53, 5.0, 30.0}) {
      testing_frames::FrameSetup setup;
      setup.shadows.cascades = 4;
      setup.shadows.resolution = 1024;
      setup.shadows.reversed_z = GetParam();
      setup.light.angular_diameter_degrees = degrees;
      setup.cascade = static_cast<int>(random() % 4);
      std::vector<testing_frames::TilePoint> receivers;
      for (int i = 0; i < kSide * kSide; ++i) {
        const glm::dvec2 at(between(0.0, 1.0), between(0.0, 1.0));
        const double below = patchwork(static_cast<int>(at.x * 512.0), static_cast<int>(at.y * 512.0));
        const double height =
            random() % 3 == 0 || !std::isfinite(below)
                ? between(0.0, 1.0)
                : below + (random() % 2 == 0 ? 1.0 : -1.0) * std::exp2(between(-22.0, -2.0));
        receivers.emplace_back(at, static_cast<double>(stored_height(height, GetParam())));
      }
      scene::Frame frame = testing_frames::make_frame(
          setup,
          [&](double u, double v, int) {
            const double height = patchwork(static_cast<int>(u * 512.0), static_cast<int>(v * 512.0));
            return stored_height(std::isnan(height) && compares ? 0.3 : height, GetParam());
          },
          receivers, kSide);
      for (glm::vec4& normal : frame.receivers.normal_ws) {
        const double tilt = std::exp2(between(-10.0, 4.0));
        const glm::dvec3 aside(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0));
        normal = glm::vec4(glm::vec3(glm::normalize(glm::dvec3(normal) + tilt * aside)), 0.0F);
      }
      expect_lossless(technique, frame, std::to_string(degrees) + " degrees", all);
    }
    EXPECT_GT(all.lit, 2000) << technique.name;
    EXPECT_GE(all.dark, may_be_dark(technique) ? 1000 : 0) << technique.name;
    EXPECT_GT(all.left, 2000) << technique.name;
  }
}

INSTANTIATE_TEST_SUITE_P(BothDirections, FilterExits, testing::Bool(),
                         [](const auto& direction) { return direction.param ? "Reversed" : "Conventional"; });

}  // namespace
}  // namespace penumbra::resolve
