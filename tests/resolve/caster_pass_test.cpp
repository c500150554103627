// Tests passes that draw the casters (tests/techniques/added/Layers): how many surfaces each texel of the map
// has, against rays through the mesh in double, and the nearest depth, against the rasteriser's map.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/vec2.hpp>
#include <iterator>
#include <optional>

#include "input/input_error_matcher.h"
#include "resolve/kept_runners.h"
#include "resolve/map_receivers.h"
#include "resolve/run_once.h"
#include "scene/cut_out.h"
#include "shaders/shader_files.h"

namespace penumbra::resolve {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing_frames::place_receivers;

constexpr int kMapSize = 96;
// Margin of barycentric coordinates: nearer to an edge a texel may be either.
constexpr double kMargin = 0.004;

fs::path added(const char* file) {
  return fs::path(PENUMBRA_SOURCE_DIR) / "tests" / "techniques" / "added" / file;
}

// The sheets are parallelograms, one of each material, one above the other and turned against each other.
scene::Scene sheets() {
  scene::Scene scene;
  scene.name = "sheets";
  scene.origin = {120.0, -3.0, 40.0};
  scene.light_direction = scene::sunlight(55.0, 20.0);
  scene.camera = scene::camera_looking({0.0, 2.0, -9.0}, {0.0, 0.5, 0.0});
  scene.shadow_distance_metres = 30.0;
  scene.textures.push_back({4, 2, {}});
  for (int texel = 0; texel < 8; ++texel)
    for (const int channel : {255, 255, 255, texel % 3 == 0 ? 40 : 220})
      scene.textures.back().rgba.push_back(static_cast<std::uint8_t>(channel));
  scene::CutOut leaf;
  leaf.pattern = scene::AlphaPattern::leaf;
  scene::CutOut texture;
  texture.texture = 0;
  texture.factor = 0.9F;
  texture.wrap_u = scene::TextureWrap::mirror;
  texture.wrap_v = scene::TextureWrap::clamp;
  scene.materials.resize(3);
  scene.materials[1].cut_out = leaf;
  scene.materials[2].cut_out = texture;
  for (std::uint16_t sheet = 0; sheet < 3; ++sheet) {
    const float height = 1.0F + 3.0F * static_cast<float>(sheet), turn = 0.3F * static_cast<float>(sheet);
    const glm::vec3 across(14.0F * std::cos(turn), 0.4F, 14.0F * std::sin(turn));
    const glm::vec3 along(-11.0F * std::sin(turn), 0.3F * static_cast<float>(sheet), 11.0F * std::cos(turn));
    const auto first = static_cast<std::uint32_t>(scene.mesh.positions.size());
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
      scene.mesh.positions.push_back(glm::vec3(0.0F, height, 0.0F) + corner.x * across + corner.y * along);
      scene.mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
      scene.mesh.uvs.push_back(1.5F * corner + glm::vec2(0.3F, 0.1F));
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) scene.mesh.indices.push_back(first + corner);
    scene.mesh.triangle_materials.insert(scene.mesh.triangle_materials.end(), 2, sheet);
  }
  return scene;
}

scene::Frame frame_of(const scene::Scene& scene, bool reversed_z) {
  return testing_frames::map_of(scene, kMapSize, reversed_z);
}

struct Surfaces {
  int all = 0;      // surfaces before holes count
  int casting = 0;  // surfaces that stop light
};

// The layers of the ray along the light through a texel's centre; absent where an edge or a hole's rim is
// near.
class Rays {
 public:
  Rays(const scene::Scene& scene, const scene::Frame& frame)
      : scene_(scene), frame_(frame), cut_outs_(scene) {}

  std::optional<Surfaces> through(int x, int y) const {
    Surfaces surfaces;
    for (std::size_t triangle = 0; triangle < scene_.mesh.triangle_count(); ++triangle) {
      const glm::dvec2 weights = weights_at(triangle, {x + 0.5, y + 0.5});
      const double nearest = std::min({weights.x, weights.y, 1.0 - weights.x - weights.y});
      if (nearest < -kMargin) continue;
      if (nearest < kMargin) return std::nullopt;
      ++surfaces.all;
      const bool open = open_at(triangle, weights);
      for (const glm::dvec2 step :
           {glm::dvec2(kMargin, 0), glm::dvec2(-kMargin, 0), glm::dvec2(0, kMargin), glm::dvec2(0, -kMargin)})
        if (open_at(triangle, weights + step) != open) return std::nullopt;
      surfaces.casting += open ? 0 : 1;
    }
    return surfaces;
  }

 private:
  glm::dvec2 texel_of(std::uint32_t vertex) const {
    const glm::dvec3 position = glm::dvec3(scene_.mesh.positions[vertex]) + scene_.origin;
    const glm::dvec4 shadow = frame_.cascades.cascades[0].world_to_shadow * glm::dvec4(position, 1.0);
    return {shadow.x * frame_.atlas.width, shadow.y * frame_.atlas.height};
  }
  // The weights of the second and third corner, by Cramer's rule.
  glm::dvec2 weights_at(std::size_t triangle, const glm::dvec2& point) const {
    const std::uint32_t* corner = &scene_.mesh.indices[3 * triangle];
    const glm::dvec2 a = texel_of(corner[0]), b = texel_of(corner[1]) - a, c = texel_of(corner[2]) - a,
                     p = point - a;
    const double area = b.x * c.y - b.y * c.x;
    return {(p.x * c.y - p.y * c.x) / area, (b.x * p.y - b.y * p.x) / area};
  }
  bool open_at(std::size_t triangle, const glm::dvec2& weights) const {
    return cut_outs_.open(triangle, static_cast<float>(weights.x), static_cast<float>(weights.y));
  }

  const scene::Scene& scene_;
  const scene::Frame& frame_;
  scene::CutOuts cut_outs_;
};

// The error of the shader's exp2(-layers), of up to 3: Vulkan allows 3 + 2 x 3 units in the last place (1.3,
// "Precision of Individual Operations").
constexpr double kExp2Error = 9.0 / (1 << 23);

class CasterPass : public testing::TestWithParam<bool> {
 protected:
  const bool reversed_z_ = GetParam();
  const scene::Scene scene_ = sheets();
  scene::Frame frame_ = frame_of(scene_, reversed_z_);
  const CastersOnDevice casters_{test_device(), scene_};

  GraphResult run(const scene::Frame& frame, const RunOptions& options = kOnce) const {
    const techniques::TechniqueList list = techniques::read_technique_list(added("Layers.technique.json"));
    GraphRunner runner(test_device(),
                       compile(technique_graph(list, list.find("layers"), Taps::as_listed, reversed_z_)));
    return runner.run(FrameOnDevice(test_device(), frame, &casters_), options);
  }
};

TEST_P(CasterPass, BlendsEverySurfaceWithAlphaTest) {
  const double far = reversed_z_ ? 0.001 : 0.999;
  place_receivers(frame_, [far](int, int) { return far; });
  const GraphResult result = run(frame_, kCountedOnce);
  const Rays rays(scene_, frame_);
  int unclear = 0, covered = 0, most = 0;
  double all = 0.0, counted = 0.0;
  for (int y = 0; y < kMapSize; ++y)
    for (int x = 0; x < kMapSize; ++x) {
      const double exact =
          -std::log2(static_cast<double>(result.visibility[0][static_cast<std::size_t>(y * kMapSize + x)]));
      const double layers = std::round(exact);
      ASSERT_NEAR(exact, layers, kExp2Error) << x << ", " << y;
      counted += layers;
      const std::optional<Surfaces> surfaces = rays.through(x, y);
      unclear += surfaces ? 0 : 1;
      if (!surfaces) continue;
      ASSERT_EQ(layers, surfaces->casting) << x << ", " << y;
      covered += surfaces->casting > 0 ? 1 : 0;
      most = std::max(most, surfaces->casting);
      all += surfaces->all;
    }
  EXPECT_EQ(most, 3);
  EXPECT_GT(covered, 500);
  EXPECT_LT(unclear, covered / 2);

  std::vector<std::string> names;
  for (const PassCounts& pass : result.passes) names.push_back(pass.pass);
  EXPECT_THAT(names, ElementsAre("Layers", "Nearest", "filter"));
  const double pixels = kMapSize * kMapSize;
  EXPECT_EQ(result.passes[0].texels_written * pixels, counted);
  EXPECT_EQ(result.passes[0].fetches_per_cascade, result.passes[0].fetches * pixels);
  EXPECT_EQ(result.passes[0].frequency, techniques::Frequency::cascade);
  EXPECT_THAT(result.unset_uniforms, testing::IsEmpty());
  // There is one fetch for each fragment of the two sheets with holes.
  EXPECT_GT(result.passes[0].fetches * pixels, all / 3.0);
  EXPECT_LT(result.passes[0].fetches * pixels, all + 3.0 * unclear);
}

TEST_P(CasterPass, WritesTheDepthThatTheMapHas) {
  const Rays rays(scene_, frame_);
  const double clear = reversed_z_ ? 0.0 : 1.0, behind = reversed_z_ ? -2e-5 : 2e-5;
  const auto depth = [&](int x, int y) {
    return static_cast<double>(frame_.atlas.depth[static_cast<std::size_t>(y * kMapSize + x)]);
  };
  for (const double side : {behind, -behind}) {
    scene::Frame frame = frame_;
    place_receivers(frame, [&](int x, int y) { return depth(x, y) == clear ? 0.5 : depth(x, y) + side; });
    const GraphResult result = run(frame);
    int compared = 0;
    for (int y = 0; y < kMapSize; ++y)
      for (int x = 0; x < kMapSize; ++x) {
        const std::optional<Surfaces> surfaces = rays.through(x, y);
        if (!surfaces) continue;
        ++compared;
        const bool shaded = side == behind && depth(x, y) != clear;
        ASSERT_NEAR(result.visibility[0][static_cast<std::size_t>(y * kMapSize + x)],
                    shaded ? std::exp2(-surfaces->casting) : 1.0, kExp2Error)
            << x << ", " << y;
      }
    EXPECT_GT(compared, kMapSize * kMapSize / 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Depth, CasterPass, testing::Bool(), direction_name);

// The technique with one thing of its shader or manifest changed.
class CasterPassProblem : public testing::Test {
 protected:
  struct Edit {
    std::string file;
    std::string from;
    std::string to;
  };

  static std::string problem(const std::string& file, const std::string& from, const std::string& to) {
    return problem({{file, from, to}});
  }
  static std::string problem(const std::vector<Edit>& edits) {
    shaders::ShaderFiles files;
    for (const char* name : {"Layers.hlsl", "Layers.shader", "Parameters/LayersParameters.hlsl",
                             "LayersPasses.hlsl", "Layers.technique.json"}) {
      std::ifstream stream(added(name), std::ios::binary);
      std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
      for (const Edit& edit : edits) {
        if (edit.file != name) continue;
        const std::size_t at = text.find(edit.from);
        EXPECT_NE(at, std::string::npos) << edit.from;
        if (at != std::string::npos) text.replace(at, edit.from.size(), edit.to);
      }
      files.write(name, text);
    }
    return input_error_of([&] {
      const techniques::TechniqueList list =
          techniques::read_technique_list(files.path("Layers.technique.json"));
      GraphRunner runner(test_device(), compile(technique_graph(list, list.find("layers"))));
      const scene::Scene scene = sheets();
      const CastersOnDevice casters(test_device(), scene);
      runner.run(FrameOnDevice(test_device(), frame_of(scene, true), &casters), kOnce);
    });
  }
};

TEST_F(CasterPassProblem, StatesThatAreNotDrawnHereAreRefusedAtTheirLine) {
  EXPECT_EQ(problem("Layers.shader", "Cull Off", "Cull Off"), "no error");
  EXPECT_THAT(problem("Layers.shader", "SubShader { Cull Off", "SubShader {"),
              HasSubstrs("Layers.shader", "draws one face", "Cull Off"));
  EXPECT_THAT(problem("Layers.shader", "Blend One One", "Blend DstColor Zero"),
              HasSubstrs("Layers.shader:10", "'Blend DstColor Zero' is not drawn here"));
  EXPECT_THAT(problem("Layers.shader", "Blend One One", "Blend One One Stencil { Ref 1 }"),
              HasSubstrs("Layers.shader:10", "'Stencil'"));
  EXPECT_THAT(problem("Layers.shader", "ZTest Always", "ZTest NotEqual"),
              HasSubstr("'ZTest NotEqual' is not drawn here"));
}

TEST_F(CasterPassProblem, VertexInputsThatNoSceneHasAreRefused) {
  EXPECT_THAT(problem("LayersPasses.hlsl", "float2 uv : TEXCOORD0;\n};\nstruct Varyings",
                      "float2 uv : TANGENT;\n};\nstruct Varyings"),
              HasSubstrs("reads the vertex input TANGENT0", "POSITION0, NORMAL0, TEXCOORD0, COLOR0"));
}

TEST_F(CasterPassProblem, TheShadowMapIsTestedAgainstAndNotWritten) {
  const std::string layers = R"("runs": "cascade", "writes": ["layers"])";
  const Edit against_map{"Layers.technique.json", layers, layers + R"(, "depth": "shadowMap")"};
  EXPECT_EQ(problem({against_map}), "no error");
  EXPECT_THAT(problem({against_map, {"Layers.shader", "ZWrite Off", "ZWrite On"}}),
              HasSubstrs("'Layers' writes depth into the shadow map", "ZWrite Off"));
  EXPECT_THAT(
      problem(
          {against_map,
           {"LayersPasses.hlsl", "TEXTURE2D(_BaseMap);", "TEXTURE2D(_BaseMap);\nTEXTURE2D(_ShadowMap);"},
           {"LayersPasses.hlsl", "return 1.0;", "return _ShadowMap.Load(int3(input.positionCS.xy, 0)).x;"}}),
      HasSubstrs("Layers.technique.json:", "'Layers' reads '_ShadowMap'"));
}

TEST(GraphRunner, AGraphOfCastersNeedsThem) {
  const techniques::TechniqueList list = techniques::read_technique_list(added("Layers.technique.json"));
  GraphRunner runner(test_device(), compile(technique_graph(list, list.find("layers"))));
  EXPECT_THROW(runner.run(FrameOnDevice(test_device(), frame_of(sheets(), true)), kOnce),
               std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::resolve
