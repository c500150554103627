// Compares contact shadows through the package's .shader with the same march written here in long double and
// in another way, over planes, against ray tracing, and over rubbish.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "reference/lit_receiver.h"
#include "reference/trace_visibility.h"
#include "resolve/drawn_scenes.h"
#include "resolve/graph_runner.h"
#include "resolve/pass_runner.h"
#include "resolve/run_once.h"
#include "scene/mesh_builder.h"

namespace penumbra::resolve {
namespace {

using Real = long double;
using Real3 = glm::vec<3, Real>;
using Real4 = glm::vec<4, Real>;

struct TraceSettings {
  float length = 0.5f;
  float height_share = 0.0f;
  float steps = 12.0f;
  float thickness = 0.3f;
  float thickness_share = 0.0f;
  float end_fade = 0.25f;
  float border_fade = 0.05f;
  float grazing = 0.05f;
  float fade_pixels = 2.0f;
  float jitter = 1.0f;
};

UniformValues trace_uniforms(const TraceSettings& settings, const glm::vec3& toward_sun,
                             float strength = 1.0f) {
  UniformValues values;
  values.set("_PenumbraScreenTraceParameters0",
             glm::vec4(settings.length, settings.height_share, settings.steps, settings.thickness));
  values.set("_PenumbraScreenTraceParameters1",
             glm::vec4(settings.thickness_share, settings.end_fade, settings.border_fade, settings.grazing));
  values.set("_PenumbraScreenTraceParameters2", glm::vec4(settings.fade_pixels, settings.jitter, 0.0f, 0.0f));
  values.set("_MainLightPosition", glm::vec4(toward_sun, 0.0f));
  values.set("_MainLightShadowParams", glm::vec4(strength, 0.0f, 0.0f, 0.0f));
  values.set("_PenumbraMainLightParams", glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
  return values;
}

std::filesystem::path trace_shader() {
  return shaders::package_shader_file().parent_path() / "PenumbraScreenTrace.shader";
}

PassRunner& trace_pass(const std::string& pass, bool reversed_z) {
  static KeptOnDevice<std::map<std::pair<std::string, bool>, std::unique_ptr<PassRunner>>> runners;
  std::unique_ptr<PassRunner>& runner = (*runners)[{pass, reversed_z}];
  if (runner == nullptr) runner = std::make_unique<PassRunner>(pass, trace_shader(), reversed_z);
  return *runner;
}

// The depth in HandCamera's view, in either direction of depth.
float stored_depth(double z, bool reversed_z) {
  const double near = HandCamera::kNear;
  const double far = HandCamera::kFar;
  const double reversed = near * far / (far - near) / z - near / (far - near);
  return static_cast<float>(reversed_z ? reversed : 1.0 - reversed);
}

glm::dmat4 hand_matrix(bool reversed_z) {
  glm::dmat4 matrix = HandCamera::screen_to_world();
  if (!reversed_z) {
    matrix[3] += matrix[2];
    matrix[2] = -matrix[2];
  }
  return matrix;
}

UniformValues with_camera(UniformValues values, bool reversed_z) {
  const std::array<glm::dmat4, 2> eyes{hand_matrix(reversed_z), hand_matrix(reversed_z)};
  values.set("_PenumbraScreenToWorld", std::span<const glm::dmat4>(eyes));
  return values;
}

HandImage traced(const HandImage& depth, bool reversed_z, const TraceSettings& settings,
                 const glm::vec3& toward_sun) {
  return trace_pass("ScreenTraceAlone", reversed_z)
      .run(depth, filled(1, 1, 0.0f), depth.width, depth.height,
           with_camera(trace_uniforms(settings, toward_sun), reversed_z))
      .image;
}

// The image of distances along the view; 0 is the sky.
HandImage image_of_distances(const HandImage& distances, bool reversed_z) {
  HandImage depth = filled(distances.width, distances.height, reversed_z ? 0.0f : 1.0f);
  for (std::size_t i = 0; i < depth.texels.size(); ++i)
    if (distances.texels[i] > 0.0f) depth.texels[i] = stored_depth(distances.texels[i], reversed_z);
  return depth;
}

// The distances are those of a floor or wall, and of boxes that face the camera before it at various
// distances.
HandImage random_distances(int width, int height, std::uint32_t seed) {
  std::mt19937 engine(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  const glm::dvec3 normal(between(-0.5, 0.5), between(-2.0, 2.0), -1.0);
  const double distance = between(2.0, 8.0);
  HandImage distances = filled(width, height, 0.0f);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double z = HandCamera::on_plane(normal, distance, x, y, width, height);
      if (z > 1.0 && z < 100.0) distances.at(x, y) = static_cast<float>(z);
    }
  }
  for (int box = 0; box < 6; ++box) {
    const int left = static_cast<int>(engine() % static_cast<unsigned>(width));
    const int top = static_cast<int>(engine() % static_cast<unsigned>(height));
    const double z = between(1.5, 8.0);
    for (int y = top; y < std::min(top + height / 4, height); ++y)
      for (int x = left; x < std::min(left + width / 6, width); ++x)
        if (distances.at(x, y) == 0.0f || z < distances.at(x, y)) distances.at(x, y) = static_cast<float>(z);
  }
  return distances;
}

float gradient_noise(int x, int y) {
  const float inner = (float(x) + 0.5f) * 0.06711056f + (float(y) + 0.5f) * 0.00583715f;
  const float amplified = 52.9829189f * (inner - std::floor(inner));
  return amplified - std::floor(amplified);
}

// The march goes over positions of the world projected by the inverse matrix.
class MarchInTheWorld {
 public:
  struct Answer {
    Real visibility = 1;
    bool near_a_decision = false;  // whether rounding may turn a decision
  };

  MarchInTheWorld(const CameraImage& camera, bool reversed_z, const TraceSettings& settings,
                  const glm::vec3& toward_sun)
      : camera_(camera),
        seen_(camera),
        reversed_z_(reversed_z),
        settings_(settings),
        sun_(glm::normalize(Real3(toward_sun))),
        to_world_(glm::mat4(camera.screen_to_world)),
        to_screen_(glm::inverse(to_world_)) {}

  Answer at(int x, int y) const {
    Answer answer;
    const std::optional<double> depth = seen_.depth(x, y);
    if (!depth || !(settings_.length > 0.0f || settings_.height_share > 0.0f)) return answer;
    const Real3 place((x + Real(0.5)) / camera_.width, (y + Real(0.5)) / camera_.height, *depth);
    const Real3 receiver = world(place);
    const Real3 across = world({place.x + Real(1) / camera_.width, place.y, place.z}) - receiver;
    const Real3 down = world({place.x, place.y + Real(1) / camera_.height, place.z}) - receiver;
    Real3 normal = Real3(seen_.normal(x, y, *depth));
    if (!(glm::length(normal) > 0)) return answer;
    const Real3 to_eye = glm::normalize(eye() - receiver);
    if (glm::dot(normal, to_eye) < 0) normal = -normal;
    answer.near_a_decision = std::fabs(glm::dot(normal, to_eye)) < Real(1e-3);

    const Real lift = (std::fabs(glm::dot(normal, across)) + std::fabs(glm::dot(normal, down))) / 2;
    const Real pixel = std::min(glm::length(across), glm::length(down));
    const Real height = pixel * camera_.height;
    length_ = std::max(Real(settings_.length), settings_.height_share * height);
    thickness_ = settings_.thickness + settings_.thickness_share * height;
    Real weight = share(length_ / pixel, settings_.fade_pixels / Real(2), settings_.fade_pixels);
    const Real facing = glm::dot(normal, sun_);
    weight *= facing > 0 ? share(facing, 0, settings_.grazing) : Real(0);
    if (std::fabs(facing) < Real(1e-4) ||
        std::fabs(length_ / pixel - settings_.fade_pixels / Real(2)) < Real(1e-4))
      answer.near_a_decision = true;
    if (!(weight > 0)) return answer;
    const Real4 lifted = screen(receiver + normal * lift);
    const Real rounding = screen_z_toward_viewer() * std::ldexp(Real(*depth), -20);
    march(world(Real3(lifted) / lifted.w + Real3(0, 0, rounding)), weight,
          settings_.jitter * gradient_noise(x, y), answer);
    return answer;
  }

 private:
  static Real share(Real value, Real low, Real high) {
    if (high > low) return std::clamp((value - low) / (high - low), Real(0), Real(1));
    return value >= low ? Real(1) : Real(0);
  }

  Real3 world(const Real3& screen) const {
    const Real4 h = to_world_ * Real4(screen, 1);
    return Real3(h) / h.w;
  }

  Real screen_z_toward_viewer() const { return reversed_z_ ? 1 : -1; }

  // w has the sign of that of all points before the camera, or that of the other ones behind it.
  Real4 screen(const Real3& world) const { return to_screen_ * Real4(world, 1); }

  Real3 eye() const { return Real3(to_world_[2]) / to_world_[2].w; }

  void march(const Real3& start, Real weight, Real moved, Answer& answer) const {
    const Real4 from = screen(start);
    const Real3 begin = Real3(from) / from.w;
    Real metres = length_;
    while (!(screen(start + sun_ * metres).w * from.w > Real(1e-3) * from.w * from.w)) metres *= Real(0.75);
    const Real4 to = screen(start + sun_ * metres);
    Real3 way = Real3(to) / to.w - begin;
    // Behind the camera's plane the line goes on without an end.
    if (metres < length_) way *= Real(1e12) / glm::length(way);
    Real inside = 1;
    for (int k = 0; k < 3; ++k) {
      if (way[k] > 0) inside = std::min(inside, (1 - begin[k]) / way[k]);
      if (way[k] < 0) inside = std::min(inside, begin[k] / -way[k]);
    }
    if (!(inside > 0)) return;
    way *= inside;
    const Real pixels = std::max(std::fabs(way.x) * camera_.width, std::fabs(way.y) * camera_.height);
    const Real wanted = std::max(std::ceil(pixels), Real(1));
    const int steps = std::clamp(static_cast<int>(std::min(settings_.steps, 64.0f)), 1,
                                 static_cast<int>(std::min(wanted, Real(64))));
    if (wanted < 64 && std::fabs(pixels - std::round(pixels)) < Real(1e-2)) answer.near_a_decision = true;
    for (int i = 0; i < steps; ++i) {
      const Real3 here = begin + way * ((i + 1 - moved) / steps);
      const Real column = here.x * camera_.width;
      const Real row = here.y * camera_.height;
      const Real loose = Real(1e-3) + Real(1e-4) * pixels / steps;
      if (std::fabs(column - std::round(column)) < loose || std::fabs(row - std::round(row)) < loose)
        answer.near_a_decision = true;
      if (column < 0 || row < 0 || column >= camera_.width || row >= camera_.height) return;
      const std::optional<double> depth = seen_.depth(static_cast<int>(column), static_cast<int>(row));
      if (!depth) continue;
      const Real gap = (Real(*depth) - here.z) * (reversed_z_ ? 1 : -1);
      if (std::fabs(gap) < Real(2e-5) * (reversed_z_ ? std::max(Real(*depth), here.z) : Real(1)))
        answer.near_a_decision = true;
      if (!(gap > 0)) continue;
      const Real behind = glm::distance(world({here.x, here.y, Real(*depth)}), world(here));
      if (std::fabs(behind - thickness_) < Real(1e-3) * (1 + thickness_)) answer.near_a_decision = true;
      if (!(behind < thickness_)) continue;
      const Real left = std::max(1 - glm::dot(world(here) - start, sun_) / length_, Real(0));
      const Real border = std::min({here.x, 1 - here.x, here.y, 1 - here.y});
      answer.visibility =
          1 - weight * share(left, 0, settings_.end_fade) * share(border, 0, settings_.border_fade);
      return;
    }
  }

  const CameraImage& camera_;
  SeenByDepth seen_;
  bool reversed_z_;
  TraceSettings settings_;
  Real3 sun_;
  glm::mat<4, 4, Real> to_world_;
  glm::mat<4, 4, Real> to_screen_;
  mutable Real length_ = 0;
  mutable Real thickness_ = 0;
};

const std::vector<glm::vec3>& suns() {
  static const std::vector<glm::vec3> directions{
      {0.3f, 0.8f, -0.5f},  {-0.6f, 0.5f, 0.2f}, {0.1f, 0.9f, 0.4f},  {0.0f, 0.0f, -1.0f},
      {0.7f, 0.1f, -0.05f}, {0.0f, 1.0f, 0.0f},  {0.0f, 0.02f, -9.0f}};
  return directions;
}

std::vector<TraceSettings> various_settings() {
  TraceSettings far_reaching;
  far_reaching.length = 3.0f;
  far_reaching.steps = 40.0f;
  far_reaching.thickness = 4.0f;
  TraceSettings relative;
  relative.length = 0.0f;
  relative.height_share = 0.15f;
  relative.thickness = 0.0f;
  relative.thickness_share = 0.1f;
  relative.border_fade = 0.3f;
  TraceSettings plain;
  plain.end_fade = plain.border_fade = plain.grazing = plain.fade_pixels = plain.jitter = 0.0f;
  plain.steps = 200.0f;
  plain.length = plain.thickness = 2.0f;
  return {TraceSettings{}, far_reaching, relative, plain};
}

TEST(ScreenTrace, IsTheMarchOverTheWorldPixelByPixel) {
  const int width = 53;
  const int height = 37;
  long long compared = 0;
  long long dark = 0;
  long long left_out = 0;
  long long wrong = 0;
  std::string first;
  for (const bool reversed_z : {true, false}) {
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
      const HandImage depth = image_of_distances(random_distances(width, height, seed), reversed_z);
      const CameraImage camera{width, height, RowOrder::top_first, depth.texels, hand_matrix(reversed_z)};
      for (const TraceSettings& settings : various_settings()) {
        for (const glm::vec3& sun : suns()) {
          const HandImage image = traced(depth, reversed_z, settings, sun);
          const MarchInTheWorld march(camera, reversed_z, settings, sun);
          for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
              const MarchInTheWorld::Answer answer = march.at(x, y);
              if (answer.near_a_decision) {
                ++left_out;
                continue;
              }
              ++compared;
              if (answer.visibility < Real(0.5)) ++dark;
              if (std::abs(image.at(x, y) - double(answer.visibility)) > 2e-3) {
                ++wrong;
                first = first.empty()
                            ? std::to_string(image.at(x, y)) + " and not " +
                                  std::to_string(double(answer.visibility)) + " at " + std::to_string(x) +
                                  ", " + std::to_string(y) + "; seed " + std::to_string(seed) + ", sun " +
                                  std::to_string(sun.x) + " " + std::to_string(sun.y) + " " +
                                  std::to_string(sun.z) + ", length " + std::to_string(settings.length) +
                                  (reversed_z ? ", reversed" : "")
                            : first;
              }
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(wrong, 0) << "of " << compared << "; " << first;
  EXPECT_GT(dark, compared / 100);
  EXPECT_LT(left_out, compared / 4);
}

// The offset promises that nothing is in a plane's way, at any slope, distance and resolution.
TEST(ScreenTrace, APlaneDoesNotShadowItself) {
  std::mt19937 engine(81);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  TraceSettings settings;
  settings.length = 5.0f;
  settings.thickness = 100.0f;
  settings.steps = 64.0f;
  settings.end_fade = settings.border_fade = settings.fade_pixels = 0.0f;
  int seen = 0;
  for (int round = 0; round < 60; ++round) {
    const bool reversed_z = round % 2 == 0;
    const glm::dvec3 normal =
        glm::normalize(glm::dvec3(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)));
    const double distance = std::pow(10.0, between(0.0, 1.7));
    HandImage distances = filled(64, 40, 0.0f);
    HandImage depth = filled(64, 40, reversed_z ? 0.0f : 1.0f);
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 64; ++x) {
        const double z = HandCamera::on_plane(normal, distance, x, y, 64, 40);
        if (z > 0.2 && z < 500.0) {
          depth.at(x, y) = stored_depth(z, reversed_z);
          ++seen;
        }
      }
    }
    glm::dvec3 sun = glm::normalize(glm::dvec3(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)));
    // The sun is on the side of the plane that the camera sees; on the other, all is dark.
    if (glm::dot(sun, normal) * normal.z > 0.0) sun = -sun;
    ASSERT_THAT(traced(depth, reversed_z, settings, glm::vec3(sun)).texels, testing::Each(1.0f))
        << "normal " << normal.x << " " << normal.y << " " << normal.z << ", sun " << sun.x << " " << sun.y
        << " " << sun.z << (reversed_z ? ", reversed" : "");
  }
  EXPECT_GT(seen, 40000);
}

TEST(ScreenTrace, StaysInRangeWhateverItReads) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> rubbish{nan, -nan, infinity, -infinity, -3.0f, 5.0f, 0.0f, 1.0f, 1e-30f};
  std::vector<glm::vec3> directions = suns();
  directions.insert(directions.end(), {{0.0f, 0.0f, 1.0f},
                                       {0.0f, 0.0f, 0.0f},
                                       {nan, 0.0f, 1.0f},
                                       {infinity, 1.0f, 0.0f},
                                       {1e30f, 1e30f, 1e30f},
                                       {1e-35f, 0.0f, 0.0f}});
  std::vector<TraceSettings> settings = various_settings();
  for (const float value : {nan, infinity, -1.0f, 0.0f, 1e30f})
    settings.push_back({value, value, value, value, value, value, value, value, value, value});
  std::mt19937 engine(82);
  for (const auto& [width, height] :
       {std::pair(1, 1), std::pair(1, 9), std::pair(9, 1), std::pair(2, 2), std::pair(37, 23)}) {
    for (const bool reversed_z : {true, false}) {
      HandImage depth = image_of_distances(random_distances(width, height, 83), reversed_z);
      for (float& texel : depth.texels)
        if (engine() % 3 == 0) texel = rubbish[engine() % rubbish.size()];
      for (const TraceSettings& of : settings)
        for (const glm::vec3& sun : directions)
          ASSERT_THAT(traced(depth, reversed_z, of, sun).texels,
                      testing::Each(testing::AllOf(testing::Ge(0.0f), testing::Le(1.0f))));
    }
  }
}

TEST(ScreenTrace, NothingIsTracedWithoutLengthThicknessOrSun) {
  const HandImage depth = image_of_distances(random_distances(64, 40, 0), true);
  TraceSettings thin;
  thin.thickness = 0.0f;
  TraceSettings none;
  none.length = 0.0f;
  const glm::vec3 sun = suns().front();
  EXPECT_THAT(traced(depth, true, {}, sun).texels, testing::Contains(testing::Lt(0.5f)));
  EXPECT_THAT(traced(depth, true, thin, sun).texels, testing::Each(1.0f));
  EXPECT_THAT(traced(depth, true, none, sun).texels, testing::Each(1.0f));
  EXPECT_THAT(traced(depth, true, {}, {0.0f, 0.0f, 0.0f}).texels, testing::Each(1.0f));
}

TEST(ScreenTrace, ReadsTheSurfaceAndOneDepthForEachStepOrPixel) {
  const HandImage depth = image_of_distances(filled(96, 54, 4.0f), true);
  TraceSettings settings;
  settings.thickness = 0.0f;
  const auto fetches = [&](float length, float steps) {
    settings.length = length;
    settings.steps = steps;
    // The view has a wall across it and a sun beside it: 96 pixels are 8 m.
    return trace_pass("ScreenTraceAlone", true)
        .run(depth, filled(1, 1, 0.0f), 96, 54,
             with_camera(trace_uniforms(settings, {1.0f, 0.0f, -0.1f}), true))
        .fetches[static_cast<std::size_t>(27 * 96 + 20)];
  };
  EXPECT_EQ(fetches(0.0f, 12.0f), 0);
  EXPECT_EQ(fetches(2.0f, 12.0f), 5 + 12);
  EXPECT_EQ(fetches(2.0f, 1.0f), 5 + 1);
  EXPECT_EQ(fetches(0.5f, 12.0f), 5 + 6) << "5.7 pixels";
}

TEST(ScreenTrace, IsMultipliedIntoTheSourceDownToTheStrength) {
  const HandImage depth = image_of_distances(random_distances(64, 40, 1), true);
  const glm::vec3 sun = suns().front();
  const HandImage alone = traced(depth, true, {}, sun);
  HandImage source = filled(64, 40, 0.0f);
  std::mt19937 engine(84);
  for (float& texel : source.texels) texel = float(engine() % 9) / 8.0f;
  source.at(3, 3) = std::numeric_limits<float>::quiet_NaN();
  source.at(4, 4) = 7.0f;
  for (const float strength : {1.0f, 0.75f, 0.0f}) {
    const PassAnswer answer =
        trace_pass("ScreenTrace", true)
            .run(depth, source, 64, 40, with_camera(trace_uniforms({}, sun, strength), true));
    int dark = 0;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 64; ++x) {
        const float before = std::isnan(source.at(x, y)) ? 1.0f : std::min(source.at(x, y), 1.0f);
        const float least = 1.0f - strength;
        const float expected = before > least ? least + (before - least) * alone.at(x, y) : before;
        ASSERT_NEAR(answer.image.at(x, y), expected, 1e-6f) << strength << ": " << x << ", " << y;
        if (before > least) continue;
        ++dark;
        ASSERT_EQ(answer.fetches[static_cast<std::size_t>(y * 64 + x)], 1);
      }
    }
    EXPECT_GT(dark, 200);
  }
}

// A person's eye sees boxes that stand on the ground and are no taller than the ray is long.
scene::Scene boxes_on_the_ground() {
  scene::Scene scene;
  scene::MeshBuilder builder;
  builder.ground(glm::dvec3(0.0), 30.0);
  for (int row = 0; row < 4; ++row)
    for (int column = -3; column <= 3; ++column)
      builder.standing_box({0.8 * column + 0.1 * row, 0.0, 2.0 + 0.7 * row}, {0.2, 0.15, 0.2},
                           17.0 * column + 5.0 * row);
  builder.move_into(scene);
  scene.name = "boxes-on-the-ground";
  scene.camera = scene::camera_looking({0.0, 1.6, -0.5}, {0.0, 0.0, 3.2});
  scene.light_direction = glm::normalize(glm::dvec3(-0.75, -0.6, 0.25));
  return scene;
}

// Whether all pixels around it are of one visibility: an outline is drawn to a pixel, and none of it is here.
bool is_inside(const reference::VisibilityImage& image, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(image.width);
  const std::size_t x = pixel % width;
  const std::size_t y = pixel / width;
  if (x == 0 || y == 0 || x + 1 == width || y + 1 == static_cast<std::size_t>(image.height)) return false;
  for (std::size_t row = y - 1; row <= y + 1; ++row)
    for (std::size_t column = x - 1; column <= x + 1; ++column) {
      const std::size_t beside = row * width + column;
      if (!image.valid[beside] || image.visibility[beside] != image.visibility[pixel]) return false;
    }
  return true;
}

TEST(ScreenTrace, ContactsWithinItsLengthAreThoseOfRayTracing) {
  const scene::Scene scene = boxes_on_the_ground();
  scene::Rasteriser rasteriser(test_device(), scene);
  scene::FrameSettings settings;
  settings.angular_diameter_degrees = 0.0;
  settings.width = 480;
  settings.height = 270;
  for (const bool reversed_z : {true, false}) {
    settings.shadows.reversed_z = reversed_z;
    const scene::Frame frame = rasteriser.frame(settings);
    parameters::Light light;
    light.direction = frame.cascades.light_direction;
    light.angular_diameter_degrees = 0.0;
    const reference::VisibilityImage exact = reference::trace_visibility(scene, frame.receivers, light);
    const FrameOnDevice on_device(test_device(), frame);
    const techniques::Technique& technique = library_techniques().find("screen-trace-12");
    ShadowGraph graph = technique_graph(library_techniques(), technique, Taps::as_listed, reversed_z);
    graph.parameters.set("_PenumbraScreenTraceParameters0", glm::vec4(0.5f, 0.0f, 64.0f, 0.3f));
    GraphRunner runner(test_device(), compile(graph));
    for (const RowOrder rows : {RowOrder::top_first, RowOrder::bottom_first}) {
      const CameraImage camera = camera_image(frame, rows);
      const GraphResult result = runner.run(on_device, &camera, kOnce);
      int dark = 0, leaks = 0, lit = 0, false_shadows = 0;
      for (std::size_t i = 0; i < exact.visibility.size(); ++i) {
        if (!is_inside(exact, i)) continue;
        const float visibility = result.visibility[0][i];
        (exact.visibility[i] < 0.5f ? dark : lit) += 1;
        if (exact.visibility[i] < 0.5f && visibility > 0.1f) ++leaks;
        if (exact.visibility[i] >= 0.5f && visibility < 0.9f) ++false_shadows;
      }
      RecordProperty("leaks", std::to_string(double(leaks) / dark));
      RecordProperty("false_shadows", std::to_string(double(false_shadows) / lit));
      EXPECT_GT(dark, 500);
      EXPECT_LT(leaks, 0.01 * dark) << dark;
      EXPECT_LT(false_shadows, 0.01 * lit) << lit;
    }
  }
}

}  // namespace
}  // namespace penumbra::resolve
