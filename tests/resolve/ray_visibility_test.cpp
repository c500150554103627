// VolumetricShadows.hlsl along the camera's view rays, against the mean of many rays to the sun's centre from
// each of them.
//
//   PENUMBRA_VOLUMETRIC_RESULTS=Documentation~/results/volumetric.json
//       build/release/penumbra_resolve_tests --gtest_filter='RayVisibility.*'
//
// writes the figures of Documentation~/other-shadows.md.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "input/json_lines.h"
#include "platform/source_commit.h"
#include "reference/disc_tracer.h"
#include "resolve/drawn_scenes.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"

namespace penumbra::resolve {
namespace {

constexpr double kLongestRay = 50.0;
constexpr int kPlaces = 256;  // places of a ray, for the exact answer
constexpr int kBlock = 4;     // pixels of a side that a filter over the screen takes together

struct FogRays {
  int samples = 16;
  bool jittered = false;
  double extinction = 0.0;
};

// A scene as the passes see it, and its rays as the exact answer takes them.
class FogScene {
 public:
  FogScene(const std::string& name, int cascades, bool reversed_z)
      : scene_(scene::built_in(name)),
        embree_(scene_),
        tracer_(embree_, sun_centre(scene_), 32, 1),
        reversed_z_(reversed_z) {
    scene::FrameSettings settings;
    settings.shadows.cascades = cascades;
    settings.shadows.reversed_z = reversed_z;
    settings.shadows.distance_metres = kLongestRay;
    settings.raster_bias = scene::kUnityRasterBias;
    settings.width = 160;
    settings.height = 90;
    frame_ = scene::rasterise(test_device(), scene_, settings);
    camera_ = camera_image(frame_);
  }

  const scene::Frame& frame() const { return frame_; }
  CameraImage& camera() { return camera_; }

  std::vector<float> seen(const FogRays& rays) const {
    static const techniques::TechniqueList list = techniques::read_technique_list(
        std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests/resolve/samples/FogRays.technique.json");
    static KeptRunners runners;
    GraphRunner& runner = runners.of("fog-rays", reversed_z_, [&] {
      return technique_graph(list, list.find("fog-rays"), Taps::as_listed, reversed_z_);
    });
    UniformValues values;
    values.set("_PenumbraFogRaysParameters0",
               glm::vec4(static_cast<float>(rays.samples), rays.jittered ? 1.0F : 0.0F,
                         static_cast<float>(rays.extinction), 0.0F));
    runner.set_parameters(values);
    const GraphResult result = runner.run(FrameOnDevice(test_device(), frame_), &camera_, kOnce);
    EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
    return result.visibility[0];
  }

  std::vector<float> exact(double extinction) const {
    std::vector<float> light;
    for (int y = 0; y < camera_.height; ++y)
      for (int x = 0; x < camera_.width; ++x) light.push_back(static_cast<float>(exact_at(x, y, extinction)));
    return light;
  }

 private:
  static reference::DiscLight sun_centre(const scene::Scene& scene) {
    parameters::Light light;
    light.direction = scene.light_direction;
    light.angular_diameter_degrees = 0.0;
    return reference::disc_light(light);
  }

  double exact_at(int x, int y, double extinction) const {
    const float stored = camera_.depth[static_cast<std::size_t>(y * camera_.width + x)];
    const bool seen = stored > 0.0F && stored < 1.0F;
    const glm::dvec4 h =
        camera_.screen_to_world *
        glm::dvec4((x + 0.5) / camera_.width, (y + 0.5) / camera_.height, seen ? stored : 0.5, 1.0);
    const glm::dvec3 ray = glm::dvec3(h) / h.w - frame_.camera.position;
    const double length = seen ? std::min(glm::length(ray), kLongestRay) : kLongestRay;
    const double depth = extinction * length;
    int lit = 0;
    for (int i = 0; i < kPlaces; ++i) {
      const double part = (i + 0.5) / kPlaces;
      const double share = depth > 0.0 ? -std::log1p(part * std::expm1(-depth)) / depth : part;
      const reference::LitReceiver place{
          frame_.camera.position - scene_.origin + glm::normalize(ray) * (share * length), {0.0, 1.0, 0.0}};
      lit += tracer_.lit_points(place, 0).first > 0 ? 1 : 0;
    }
    return lit / static_cast<double>(kPlaces);
  }

  scene::Scene scene_;
  reference::EmbreeScene embree_;
  reference::DiscTracer tracer_;
  bool reversed_z_;
  scene::Frame frame_;
  CameraImage camera_;
};

struct FogErrors {
  double pixels = 0.0;  // RMSE
  double blocks = 0.0;  // RMSE of the means of kBlock x kBlock pixels
};

FogErrors errors(const FogScene& scene, const std::vector<float>& seen, const std::vector<float>& exact) {
  const int width = scene.frame().receivers.width, height = scene.frame().receivers.height;
  double pixels = 0.0, blocks = 0.0;
  int count = 0;
  for (int top = 0; top + kBlock <= height; top += kBlock)
    for (int left = 0; left + kBlock <= width; left += kBlock, ++count) {
      double sum = 0.0;
      for (int y = top; y < top + kBlock; ++y)
        for (int x = left; x < left + kBlock; ++x) {
          const auto at = static_cast<std::size_t>(y * width + x);
          const double error = static_cast<double>(seen[at]) - static_cast<double>(exact[at]);
          sum += error;
          pixels += error * error;
        }
      blocks += std::pow(sum / (kBlock * kBlock), 2);
    }
  return {std::sqrt(pixels / (count * kBlock * kBlock)), std::sqrt(blocks / count)};
}

void write_results(const nlohmann::json& records, const scene::Frame& frame) {
  const char* const file = std::getenv("PENUMBRA_VOLUMETRIC_RESULTS");  // NOLINT(concurrency-mt-unsafe)
  if (file == nullptr) return;
  const nlohmann::json results{{"command",
                                "PENUMBRA_VOLUMETRIC_RESULTS=Documentation~/results/volumetric.json "
                                "build/release/penumbra_resolve_tests --gtest_filter='RayVisibility.*'"},
                               {"commit", platform::source_commit().value_or("")},
                               {"device", test_device().info().name},
                               {"picture", {frame.receivers.width, frame.receivers.height}},
                               {"map", {frame.atlas.width, frame.atlas.height}},
                               {"cascades", frame.cascades.cascades.size()},
                               {"longest_ray_metres", kLongestRay},
                               {"places_of_the_exact_answer", kPlaces},
                               {"block_pixels", kBlock},
                               {"records", records}};
  std::ofstream(file) << json_lines(results.dump());
}

// With more samples the error falls, in every scene's mean, for pixels and for blocks, in thin and in thick
// fog.
TEST(RayVisibility, IsNearerToTracedRaysTheMoreSamplesThereAre) {
  nlohmann::json records = nlohmann::json::array();
  std::map<std::tuple<double, bool, int>, FogErrors> means;
  const std::vector<std::string> names = scenes_for_small_pictures();
  std::optional<scene::Frame> last;
  for (const std::string& name : names) {
    const FogScene scene(name, 4, true);
    last = scene.frame();
    for (const double extinction : {0.0, 0.05}) {
      const std::vector<float> exact = scene.exact(extinction);
      for (const bool jittered : {false, true})
        for (const int samples : {4, 8, 16, 32, 64}) {
          const FogErrors of = errors(scene, scene.seen({samples, jittered, extinction}), exact);
          FogErrors& mean = means[{extinction, jittered, samples}];
          mean.pixels += of.pixels / static_cast<double>(names.size());
          mean.blocks += of.blocks / static_cast<double>(names.size());
          records.push_back({{"scene", name},
                             {"extinction_per_metre", extinction},
                             {"samples", samples},
                             {"jittered", jittered},
                             {"rmse", of.pixels},
                             {"rmse_of_blocks", of.blocks}});
        }
    }
  }
  for (const double extinction : {0.0, 0.05})
    for (const bool jittered : {false, true}) {
      for (const int samples : {8, 16, 32, 64}) {
        const FogErrors now = means[{extinction, jittered, samples}];
        const FogErrors before = means[{extinction, jittered, samples / 2}];
        EXPECT_LT(now.pixels, before.pixels) << extinction << " " << jittered << " " << samples;
        EXPECT_LT(now.blocks, before.blocks) << extinction << " " << jittered << " " << samples;
      }
      EXPECT_LT((means[{extinction, jittered, 16}].pixels), 0.04) << extinction << " " << jittered;
      EXPECT_LT((means[{extinction, jittered, 64}].pixels), 0.02) << extinction << " " << jittered;
    }
  // This is what jitter is for.
  for (const int samples : {4, 8, 16})
    EXPECT_LT((means[{0.0, true, samples}].blocks), 0.8 * (means[{0.0, false, samples}].blocks)) << samples;
  write_results(records, *last);
}

TEST(RayVisibility, IsTheSameForAnyNumberOfCascadesAndBothDepthDirections) {
  for (const bool reversed_z : {true, false})
    for (const int cascades : {1, 2, 3}) {
      const FogScene scene("contact-boxes", cascades, reversed_z);
      const FogErrors of = errors(scene, scene.seen({64, false, 0.0}), scene.exact(0.0));
      EXPECT_LT(of.pixels, 0.02) << cascades << " " << reversed_z;
    }
}

TEST(RayVisibility, StaysInRangeWhateverItIsGiven) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const float rubbish[] = {std::nanf(""), std::numeric_limits<float>::infinity(), -1.0F, 2.0F, 0.0F, 1.0F,
                           1e-30F};
  FogScene scene("colonnade", 4, true);
  for (std::size_t i = 0; i < scene.camera().depth.size(); i += 3)
    scene.camera().depth[i] = rubbish[i / 3 % std::size(rubbish)];
  for (const double extinction : {0.0, nan, infinity, -infinity, -1.0, 1e30, 1e-30})
    for (const int samples : {-5, 0, 1, 1000}) {
      for (const bool jittered : {false, true})
        for (const float seen : scene.seen({samples, jittered, extinction}))
          ASSERT_TRUE(seen >= 0.0F && seen <= 1.0F) << extinction << " " << samples;
    }
}

}  // namespace
}  // namespace penumbra::resolve
