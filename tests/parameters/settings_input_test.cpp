// Tests --config files: what is read, and what a person is told about what is wrong.
#include "parameters/settings_input.h"

#include <cmath>
#include <limits>

#include "input/input_error_matcher.h"
#include "input/located_json.h"

namespace penumbra::parameters {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

FitInput read(const std::string& text) {
  return read_settings(LocatedJson::parse(text, "f"));
}

TEST(Settings, EmptyObjectGivesUrpsDefaults) {
  const FitInput input = read("{}");
  EXPECT_EQ(input.camera.fov_y_degrees, 60.0);
  EXPECT_EQ(input.camera.near_plane, 0.3);
  EXPECT_EQ(input.camera.far_plane, 1000.0);
  EXPECT_EQ(input.shadows.distance_metres, 50.0);
  EXPECT_EQ(input.shadows.cascades, 1);
  EXPECT_EQ(input.shadows.resolution, 2048);
  EXPECT_EQ(input.shadows.depth_bias, 1.0);
  EXPECT_EQ(input.light.angular_diameter_degrees, 0.53);
}

TEST(Settings, EveryKeyIsRead) {
  const FitInput input = read(R"({
    "camera": {"position": [1, 2, 3], "forward": [1, 0, 0], "up": [0, 0, 1], "fov_y_degrees": 40,
               "aspect": 1.5, "near": 0.1, "far": 900},
    "light": {"direction": [0, -1, 0], "angular_diameter_degrees": 2},
    "shadows": {"distance_metres": 80, "cascades": 3, "splits": [0.2, 0.5], "resolution": 4096,
                "depth_bias": 0.5, "normal_bias": 0.25, "soft_quality": "high", "reversed_z": false,
                "clip_depth": "minus_one_to_one", "fit_to_bounds": true, "near_plane_offset_metres": 1,
                "caster_bounds": {"min": [-1, -2, -3], "max": [4, 5, 6]}}})");
  EXPECT_EQ(input.camera.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(input.camera.forward, glm::dvec3(1, 0, 0));
  EXPECT_EQ(input.camera.up, glm::dvec3(0, 0, 1));
  EXPECT_EQ(input.camera.aspect, 1.5);
  EXPECT_EQ(input.light.direction, glm::dvec3(0, -1, 0));
  EXPECT_EQ(input.light.angular_diameter_degrees, 2.0);
  EXPECT_EQ(input.shadows.splits[1], 0.5);
  EXPECT_EQ(input.shadows.resolution, 4096);
  EXPECT_EQ(input.shadows.soft_quality, SoftQuality::high);
  EXPECT_FALSE(input.shadows.reversed_z);
  EXPECT_EQ(input.shadows.clip_depth, ClipDepth::minus_one_to_one);
  EXPECT_EQ(input.shadows.caster_bounds->maximum, glm::dvec3(4, 5, 6));
  EXPECT_TRUE(input.shadows.fit_to_bounds);
  EXPECT_EQ(read(R"({"shadows": {"depth_range_metres": 7}})").shadows.depth_range_metres, 7.0);
}

// Unity's asset holds three splits whatever the number of cascades.
TEST(Settings, ThreeSplitsServeAnyNumberOfCascades) {
  EXPECT_EQ(read(R"({"shadows": {"cascades": 2, "splits": [0.3, 0.5, 0.7]}})").shadows.splits[0], 0.3);
  EXPECT_EQ(read(R"({"shadows": {"splits": [0.3, 0.5, 0.7]}})").shadows.cascades, 1);
}

struct BadFile {
  const char* text;
  const char* place;
  const char* message;
};

TEST(Settings, BadFilesAreAnsweredAtTheirPlace) {
  const BadFile files[] = {
      {"", "f", "empty"},
      {"[]", "f:1:1", "object"},
      {R"({"camera": 3})", "f:1:2", "object"},
      {R"({"camra": {}})", "f:1:2", "did you mean 'camera'"},
      {R"({"light": {"angular_diameter": 1}})", "f:1:12", "angular_diameter_degrees"},
      {R"({"shadows": {"cascades": 0}})", "f:1:14", "is 0, outside 1 .. 4"},
      {R"({"shadows": {"cascades": 5}})", "f:1:14", "is 5, outside 1 .. 4"},
      {R"({"shadows": {"cascades": 1.5}})", "f:1:14", "whole number"},
      {R"({"shadows": {"resolution": -2048}})", "f:1:14", "is -2048"},
      {R"({"shadows": {"distance_metres": -5}})", "f:1:14", "is -5"},
      {R"({"shadows": {"depth_bias": -1}})", "f:1:14", "is -1"},
      {R"({"shadows": {"depth_range_metres": 0}})", "f:1:14", "is 0"},
      {R"({"shadows": {"soft_quality": "hgh"}})", "f:1:14", "did you mean 'high'"},
      {R"({"shadows": {"cascades": 3, "splits": [0.5, 0.2]}})", "f:1:29", "not greater than 0.5"},
      {R"({"shadows": {"cascades": 2, "splits": [1.5]}})", "f:1:29", "between 0 and 1"},
      {R"({"shadows": {"cascades": 2, "splits": [0.001]}})", "f:1:29", "near plane"},
      {R"({"shadows": {"cascades": 4, "splits": [0.1]}})", "f:1:29", "3 numbers"},
      {R"({"shadows": {"fit_to_bounds": true}})", "f:1:14", "caster_bounds"},
      {R"({"shadows": {"caster_bounds": {"min": [0, 0, 0]}}})", "f:1:14", "'max'"},
      {R"({"shadows": {"caster_bounds": {"min": [1, 0, 0], "max": [0, 1, 1]}}})", "f:1:14",
       "above its maximum"},
      {R"({"light": {"direction": [0, 0, 0]}})", "f:1:12", "length 0"},
      {R"({"light": {"angular_diameter_degrees": -1}})", "f:1:12", "outside 0 .. 30"},
      {R"({"light": {"angular_diameter_degrees": 31}})", "f:1:12", "outside 0 .. 30"},
      {R"({"camera": {"fov_y_degrees": 0}})", "f:1:13", "between 0 and 180"},
      {R"({"camera": {"fov_y_degrees": 180}})", "f:1:13", "between 0 and 180"},
      {R"({"camera": {"near": 10, "far": 5}})", "f:1:13", "not closer than the far plane"},
      {R"({"camera": {"up": [0, 0, 2]}})", "f:1:13", "parallel"},
      {R"({"camera": {"position": [1e999, 0, 0]}})", "f:1:", ""},
  };
  for (const BadFile& file : files) {
    SCOPED_TRACE(file.text);
    expect_input_error([&] { read(file.text); }, AllOf(StartsWith(file.place), HasSubstr(file.message)));
  }
}

// Settings that come from flags or code have no place, but get the same answers, also for what is not a
// number.
TEST(Settings, NotANumberIsRefusedWhereverItStands) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    expect_input_error(
        [&] {
          fit_cascades({.position = {0, bad, 0}}, {}, {});
        },
        HasSubstr("camera/position"));
    expect_input_error([&] { fit_cascades({.forward = {bad, 0, 0}}, {}, {}); }, HasSubstr("camera/forward"));
    expect_input_error([&] { fit_cascades({.fov_y_degrees = bad}, {}, {}); }, HasSubstr("fov_y_degrees"));
    expect_input_error([&] { fit_cascades({.aspect = bad}, {}, {}); }, HasSubstr("aspect"));
    expect_input_error([&] { fit_cascades({.far_plane = bad}, {}, {}); }, HasSubstr("camera/far"));
    expect_input_error(
        [&] {
          fit_cascades({}, {.direction = {0, bad, 0}}, {});
        },
        HasSubstr("light/direction"));
    expect_input_error([&] { fit_cascades({}, {.angular_diameter_degrees = bad}, {}); },
                       HasSubstr("angular"));
    expect_input_error([&] { fit_cascades({}, {}, {.distance_metres = bad}); }, HasSubstr("distance_metres"));
    expect_input_error(
        [&] {
          fit_cascades({}, {}, {.cascades = 2, .splits = {bad, 0, 0}});
        },
        HasSubstr("splits"));
    expect_input_error([&] { fit_cascades({}, {}, {.normal_bias = bad}); }, HasSubstr("normal_bias"));
    expect_input_error([&] { fit_cascades({}, {}, {.depth_range_metres = bad}); }, HasSubstr("depth_range"));
    expect_input_error(
        [&] {
          fit_cascades({}, {}, {.caster_bounds = Bounds{{bad, 0, 0}, {1, 1, 1}}});
        },
        HasSubstr("bounds"));
  }
}

// Settings that are each in range may still lead to figures that no float holds; the output never has "inf".
TEST(Settings, FiguresBeyondFloatAreRefused) {
  const auto refused = HasSubstr("overflow 32-bit floats");
  expect_input_error([&] { fit_cascades({}, {.angular_diameter_degrees = 1e-42}, {}); }, refused);
  const Bounds speck{{0, 1, 9}, {1e-150, 1, 9}};
  const ShadowSettings on_a_speck{.caster_bounds = speck, .fit_to_bounds = true};
  expect_input_error(
      [&] {
        fit_cascades({.position = {0, 0, 0}}, {.direction = {0, 0, 1}}, on_a_speck);
      },
      refused);
}

}  // namespace
}  // namespace penumbra::parameters
