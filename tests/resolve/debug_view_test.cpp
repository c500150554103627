// Draws the debug views through the package's own .shader: every colour is compared with what it should say
// of its pixel, worked out here in double from the frame itself.
#include "resolve/debug_view.h"
#include "resolve/colour_vision.h"
#include "resolve/graph_runner.h"

#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>

#include "input/input_error.h"
#include "resolve/drawn_scenes.h"
#include "resolve/run_once.h"
#include "scene/mesh_builder.h"

namespace penumbra::resolve {
namespace {

constexpr double kShadeOfLight = 0.4;  // share of a colour that is left where all light is blocked

using Colours = std::vector<glm::vec3>;

// The views are kept, because compiling them costs more than running them.
DebugView& debug_view(const std::string& name, bool reversed_z) {
  static const shaders::PackageShader shader(shaders::debug_shader_file());
  static KeptOnDevice<std::map<std::pair<std::string, bool>, DebugView>> views;
  return views->try_emplace({name, reversed_z}, test_device(), shader, name, reversed_z).first->second;
}

GraphRunner& runner_of(const techniques::Technique& technique, bool reversed_z) {
  static KeptOnDevice<std::map<std::pair<std::string, bool>, GraphRunner>> runners;
  return runners
      ->try_emplace({technique.name, reversed_z}, test_device(),
                    compile(technique_graph(library_techniques(), technique, Taps::as_listed, reversed_z)))
      .first->second;
}

struct Views {
  explicit Views(const scene::Frame& drawn_frame, const std::string& preset, RowOrder row_order)
      : frame(drawn_frame),
        on_device(test_device(), frame),
        camera(camera_image(frame, row_order)),
        technique(library_techniques().find(preset)),
        chain(runner_of(technique, frame.settings.shadows.reversed_z).run(on_device, &camera, kOnce)) {}

  const std::vector<float>& visibility() const { return chain.visibility.front(); }

  Colours draw(const std::string& view, std::optional<RowOrder> picture = std::nullopt) const {
    return debug_view(view, frame.settings.shadows.reversed_z)
        .draw(on_device, camera, visibility(), chain.masked_out,
              parameter_uniforms(library_techniques(), technique), picture);
  }

  bool seen(std::size_t pixel) const { return frame.receivers.position_ws[pixel].w != 0.0f; }
  glm::dvec3 position(std::size_t pixel) const {
    return glm::dvec3(glm::vec3(frame.receivers.position_ws[pixel]));
  }
  // The share of its colour that a view leaves under this pixel's shadow.
  double shade(std::size_t pixel) const {
    return kShadeOfLight + (1.0 - kShadeOfLight) * visibility()[pixel];
  }

  const scene::Frame& frame;
  FrameOnDevice on_device;
  CameraImage camera;
  const techniques::Technique& technique;
  GraphResult chain;
};

bool near(const glm::vec3& a, const glm::dvec3& b, double tolerance = 2e-3) {
  return glm::length(glm::dvec3(a) - b) <= tolerance;
}

class DebugViews : public testing::TestWithParam<std::tuple<int, bool, RowOrder>> {
 protected:
  int cascades() const { return std::get<0>(GetParam()); }
  Views views(const std::string& scene,
              const std::string& preset = "screen-pcss-angular-24-16-masked") const {
    return Views(drawn(scene, cascades(), std::get<1>(GetParam())), preset, std::get<2>(GetParam()));
  }
};

TEST_P(DebugViews, VisibilityIsWhatReceiversRead) {
  const Views views = this->views("contact-boxes");
  const Colours colours = views.draw("Visibility");
  int receivers = 0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    if (!views.seen(i)) continue;
    ASSERT_EQ(colours[i], glm::vec3(views.visibility()[i])) << i;
    ++receivers;
  }
  EXPECT_GT(receivers, 3000);
}

TEST_P(DebugViews, TheSkyIsBlack) {
  const Views views = this->views("trees");
  for (const char* view : {"Visibility", "Cascades", "ShadowTexels", "PenumbraWidth", "PenumbraMask"}) {
    const Colours colours = views.draw(view);
    int sky = 0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const float depth = rows_from_top(views.camera.depth, views.camera.width, views.camera.rows)[i];
      if (depth > 0.0f && depth < 1.0f) continue;
      ASSERT_EQ(colours[i], glm::vec3(0.0f)) << view << " " << i;
      ++sky;
    }
    EXPECT_GT(sky, 100) << view;
  }
}

TEST_P(DebugViews, APictureMayBeginWithItsOtherRow) {
  const Views views = this->views("poles-and-fence");
  for (const char* view : {"Visibility", "Cascades", "ShadowTexels", "PenumbraWidth", "PenumbraMask"}) {
    const Colours colours = views.draw(view, RowOrder::top_first);
    EXPECT_EQ(colours, views.draw(view, RowOrder::bottom_first)) << view;
    EXPECT_NE(colours, rows_from_top(colours, views.camera.width, RowOrder::bottom_first)) << view;
  }
}

// The spheres alone decide; which cascade has which colour is the library's to say, that they differ is not.
TEST_P(DebugViews, CascadesHaveAColourEach) {
  const Views views = this->views("street");
  const Colours colours = views.draw("Cascades");
  const std::vector<parameters::Cascade>& cascades = views.frame.cascades.cascades;
  std::vector<std::vector<glm::dvec3>> of_cascade(cascades.size());
  for (std::size_t i = 0; i < colours.size(); ++i) {
    if (!views.seen(i)) continue;
    const auto inside = [&](const parameters::Cascade& cascade, double slack) {
      const glm::dvec4& sphere = cascade.split_sphere;
      return glm::distance(views.position(i), glm::dvec3(sphere)) < sphere.w * slack;
    };
    for (std::size_t c = 0; c < cascades.size(); ++c) {
      if (inside(cascades[c], 0.999)) {
        of_cascade[c].push_back(glm::dvec3(colours[i]) / views.shade(i));
        break;
      }
      if (inside(cascades[c], 1.001)) break;  // too near to the border for a float
    }
  }
  std::vector<glm::dvec3> found;
  for (const std::vector<glm::dvec3>& colours_of : of_cascade) {
    if (colours_of.empty()) continue;  // not every cascade shows in a few pixels' scene
    for (const glm::dvec3& colour : colours_of) ASSERT_TRUE(near(glm::vec3(colours_of.front()), colour));
    for (const glm::dvec3& other : found) {
      EXPECT_GT(colour_vision::least_difference(other, colours_of.front()), 15.0) << "for any kind of vision";
    }
    found.push_back(colours_of.front());
  }
  EXPECT_GE(found.size(), std::min<std::size_t>(cascades.size(), 3));
}

TEST_P(DebugViews, TheMaskIsTheOneTheResolveRead) {
  const Views views = this->views("poles-and-fence", "screen-tent-5-masked");
  const Colours colours = views.draw("PenumbraMask");
  int filtered = 0;
  int spared = 0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    if (!views.seen(i)) continue;
    const bool grey = colours[i].r == colours[i].b;
    ASSERT_EQ(grey, views.chain.masked_out[i] != 0) << i;
    (grey ? spared : filtered) += 1;
  }
  EXPECT_GT(filtered, 100);
  EXPECT_GT(spared, 100);
}

TEST_P(DebugViews, WithoutAMaskAllIsFiltered) {
  const Views views = this->views("contact-boxes", "screen-pcss-angular-24-16");
  const Colours colours = views.draw("PenumbraMask");
  for (std::size_t i = 0; i < colours.size(); ++i) {
    if (!views.seen(i)) continue;
    ASSERT_GT(colours[i].r, colours[i].b + 0.1f) << i;
  }
}

// The hue goes by straight lines over blue, yellow and vermilion of Okabe and Ito.
glm::dvec3 texel_hue(double share) {
  const glm::dvec3 middle(0.941, 0.894, 0.259);
  return share < 0.5 ? glm::mix(glm::dvec3(0.0, 0.447, 0.698), middle, 2.0 * share)
                     : glm::mix(middle, glm::dvec3(0.835, 0.369, 0.0), 2.0 * share - 1.0);
}

// The texel's width in pixels gives the hue, and the chequers give the brightness; both come from the
// cascade's matrix and the lens.
TEST(DebugViewOfTexels, AreAsLargeAsTheMapsAre) {
  const Views views(drawn("slabs", 1, true), "preset-ultra", RowOrder::top_first);
  const Colours colours = views.draw("ShadowTexels");
  const parameters::Cascade& cascade = views.frame.cascades.cascades.front();
  const parameters::Camera& camera = views.frame.camera;
  int compared = 0;
  int light_ones = 0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    if (!views.seen(i)) continue;
    const glm::dvec4 shadow = cascade.world_to_shadow * glm::dvec4(views.position(i), 1.0);
    const double x = shadow.x * views.frame.atlas.width;
    const double y = shadow.y * views.frame.atlas.height;
    const bool light = (static_cast<int>(std::floor(x)) + static_cast<int>(std::floor(y))) % 2 != 0;
    const double away = glm::dot(views.position(i) - camera.position, glm::normalize(camera.forward));
    const double metres_per_pixel =
        2.0 * away * std::tan(glm::radians(camera.fov_y_degrees / 2.0)) / views.camera.height;
    // The rasteriser rounds vertices to a 256th of a pixel, and the view has its place from the depth there.
    const double unsure = 0.02 * std::max(1.0, metres_per_pixel / cascade.texel_size_metres);
    const auto border = [unsure](double v) { return std::abs(v - std::round(v)) < unsure; };
    if (border(x) || border(y)) continue;
    const double pixels = std::clamp(cascade.texel_size_metres / metres_per_pixel, 1.0, 8.0);
    const double share = std::log(pixels) / std::log(8.0);
    const glm::dvec3 hue = texel_hue(share);
    ASSERT_TRUE(near(colours[i], hue * (light ? 1.0 : 0.65) * views.shade(i), 0.02))
        << i << ": " << colours[i].r << " " << colours[i].g << " " << colours[i].b << ", share " << share
        << ", texel " << x << " " << y << ", shade " << views.shade(i);
    ++compared;
    light_ones += light ? 1 : 0;
  }
  EXPECT_GT(compared, 1000);
  EXPECT_NEAR(light_ones, compared / 2, compared / 10);
}

INSTANTIATE_TEST_SUITE_P(Package, DebugViews,
                         testing::Values(std::tuple(1, true, RowOrder::top_first),
                                         std::tuple(4, false, RowOrder::bottom_first)));

// A thin board is above the ground under a light from straight above: everywhere in its penumbra the width is
// 2 tan(a/2) times its height.
scene::Scene board_at(double height) {
  scene::Scene scene;
  scene.name = "board";
  scene::MeshBuilder mesh;
  mesh.ground({0.0, 0.0, 0.0}, 8.0);
  mesh.box({{0.0, height, 0.0}, glm::dmat3(1.0)}, {3.0, 0.01, 3.0});
  scene.mesh = mesh.take();
  scene.camera = scene::camera_looking({0.0, 1.2, -5.0}, {0.0, 0.0, 0.0});
  scene.light_direction = {0.0, -1.0, 0.0};
  scene.shadow_distance_metres = 12.0;
  return scene;
}

TEST(DebugViewOfTheWidth, IsTheBlockersHeightTimesTheLightsDiameter) {
  for (const double height : {1.0, 3.0}) {
    const scene::Scene scene = board_at(height);
    scene::FrameSettings settings = screen_settings(1, true);
    settings.shadows.resolution = 2048;
    settings.shadows.distance_metres = scene.shadow_distance_metres;
    settings.shadows.depth_bias = 0.0;  // a bias would lower the board
    const scene::Frame frame = scene::rasterise(test_device(), scene, settings);
    const Views views(frame, "screen-pcss-angular-24-16", RowOrder::top_first);
    const Colours colours = views.draw("PenumbraWidth");
    const double expected = 2.0 * std::tan(glm::radians(settings.angular_diameter_degrees / 2.0)) * height;
    const double texel = frame.cascades.cascades.front().texel_size_metres;
    ASSERT_GT(expected, 2.0 * texel);
    int compared = 0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const bool on_ground = views.seen(i) && std::abs(views.position(i).y) < 1e-3;
      const bool in_penumbra = views.visibility()[i] > 0.1f && views.visibility()[i] < 0.9f;
      if (!on_ground || !in_penumbra) continue;
      // The colour is a black body's: red, green and blue rise one after the other, so their sum tells how
      // far it has come.
      const double share = (colours[i].r + colours[i].g + colours[i].b) / 3.0;
      const double metres = 0.01 * std::pow(100.0, share);
      ASSERT_NEAR(metres, expected, 0.02 * expected) << height << " m, pixel " << i;
      ++compared;
    }
    EXPECT_GT(compared, 30) << height;
  }
}

// Where the map cannot show the penumbra, the view says so and gives no figure.
TEST(DebugViewOfTheWidth, IsBlueWhereATexelIsWider) {
  const scene::Scene scene = board_at(1.0);
  scene::FrameSettings settings = screen_settings(1, true);
  settings.shadows.resolution = 256;
  settings.shadows.distance_metres = scene.shadow_distance_metres;
  settings.angular_diameter_degrees = 0.53;
  const scene::Frame frame = scene::rasterise(test_device(), scene, settings);
  ASSERT_GT(frame.cascades.cascades.front().texel_size_metres, 0.02);
  const Views views(frame, "screen-pcss-angular-24-16", RowOrder::top_first);
  const Colours colours = views.draw("PenumbraWidth");
  int blue = 0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const bool in_penumbra = views.visibility()[i] > 0.1f && views.visibility()[i] < 0.9f;
    if (!views.seen(i) || std::abs(views.position(i).y) > 1e-3 || !in_penumbra) continue;
    ASSERT_GT(colours[i].b, colours[i].r + 0.5f) << i;
    ++blue;
  }
  EXPECT_GT(blue, 30);
}

TEST(DebugViewShader, HasAPassForEachViewAndNamesTheNearestToAnother) {
  const shaders::PackageShader shader(shaders::debug_shader_file());
  EXPECT_THAT(shader.pass_names(), testing::ElementsAre("Visibility", "Cascades", "ShadowTexels",
                                                        "PenumbraWidth", "PenumbraMask"));
  EXPECT_THAT([&] { DebugView(test_device(), shader, "Cascade", true); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("did you mean 'Cascades'?")));
}

}  // namespace
}  // namespace penumbra::resolve
