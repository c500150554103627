// Matrices dumped from Unity are equal to what was given, or are refused with the reason and the place.
#include "parameters/matrices_input.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "input/input_error_matcher.h"
#include "input/located_json.h"
#include "parameters/random_setup.h"
#include "parameters/verify.h"

namespace penumbra::parameters {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

struct DumpOptions {
  bool row_major = true;
  bool pair = true;
  bool shadow = true;
  std::string clip_depth = "minus_one_to_one";
  bool reversed_z = true;
  std::string extra = {};
};

std::string numbers(const glm::dmat4& m, bool row_major) {
  std::string text;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      // Unity writes the matrices as floats.
      text +=
          fmt::format("{}{}", text.empty() ? "" : ", ", static_cast<float>(row_major ? m[j][i] : m[i][j]));
    }
  }
  return "[" + text + "]";
}

std::string dump_text(const CascadeSet& set, const DumpOptions& options) {
  std::string cascades;
  for (const Cascade& c : set.cascades) {
    std::string fields;
    if (options.pair) {
      fields += fmt::format("\"view\": {},\n\"projection\": {}", numbers(c.view, options.row_major),
                            numbers(c.projection, options.row_major));
    }
    if (options.shadow) {
      fields += fmt::format("{}\"world_to_shadow\": {}", fields.empty() ? "" : ",\n",
                            numbers(c.world_to_shadow, options.row_major));
    }
    cascades += fmt::format("{}{{{}}}", cascades.empty() ? "" : ",\n", fields);
  }
  return fmt::format(
      "{{\"matrix_order\": \"{}\", \"clip_depth\": \"{}\", \"reversed_z\": {}, \"resolution\": 2048{},\n"
      "\"cascades\": [{}]}}",
      options.row_major ? "row-major" : "column-major", options.clip_depth, options.reversed_z, options.extra,
      cascades);
}

MatricesDump read(const std::string& text) {
  return read_matrices(LocatedJson::parse(text, "f"));
}

CascadeSet unitys(int cascades = 4, bool reversed = true) {
  return fit_cascades(
      {}, {}, {.cascades = cascades, .reversed_z = reversed, .clip_depth = ClipDepth::minus_one_to_one});
}

void expect_equal(const glm::dmat4& given, const glm::dmat4& read) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) EXPECT_EQ(static_cast<float>(given[c][r]), static_cast<float>(read[c][r]));
  }
}

TEST(Matrices, AreKeptToTheBitInBothOrders) {
  for (const bool row_major : {true, false}) {
    for (int cascades = 1; cascades <= 4; ++cascades) {
      const CascadeSet set = unitys(cascades);
      const MatricesDump dump = read(dump_text(set, {.row_major = row_major}));
      ASSERT_EQ(dump.set.cascades.size(), set.cascades.size());
      for (std::size_t i = 0; i < set.cascades.size(); ++i) {
        expect_equal(set.cascades[i].view, dump.set.cascades[i].view);
        expect_equal(set.cascades[i].projection, dump.set.cascades[i].projection);
        expect_equal(set.cascades[i].world_to_shadow, dump.set.cascades[i].world_to_shadow);
      }
    }
  }
}

void expect_same_figures(const CascadeSet& set, const CascadeSet& read) {
  for (std::size_t i = 0; i < set.cascades.size(); ++i) {
    const Cascade& a = set.cascades[i];
    const Cascade& b = read.cascades[i];
    EXPECT_EQ(a.offset_scale, b.offset_scale);
    EXPECT_NEAR(a.depth_to_radial, b.depth_to_radial, 1e-6 * a.depth_to_radial);
    EXPECT_NEAR(a.texel_size_metres, b.texel_size_metres, 1e-6 * a.texel_size_metres);
    EXPECT_NEAR(a.depth_bias_metres, b.depth_bias_metres, 1e-6);
    EXPECT_EQ(b.depth_to_radial_hdrp, 2.0 * b.depth_to_radial);
  }
}

TEST(Matrices, FiguresFollowFromEitherFormInEveryConvention) {
  for (const bool reversed : {true, false}) {
    for (const ClipDepth clip : {ClipDepth::zero_to_one, ClipDepth::minus_one_to_one}) {
      const CascadeSet set =
          fit_cascades({}, {}, {.cascades = 4, .reversed_z = reversed, .clip_depth = clip});
      for (const bool pair : {true, false}) {
        for (const bool shadow : {true, false}) {
          if (!pair && !shadow) continue;
          const MatricesDump dump = read(dump_text(
              set, {.pair = pair,
                    .shadow = shadow,
                    .clip_depth = clip == ClipDepth::zero_to_one ? "zero_to_one" : "minus_one_to_one",
                    .reversed_z = reversed}));
          expect_same_figures(set, dump.set);
          EXPECT_NEAR(glm::dot(dump.set.light_direction, set.light_direction), 1.0, 1e-9);
          for (const CascadeErrors& errors : verify_dump(dump.settings, dump.set)) {
            EXPECT_LE(worst_ulp(errors), 0.501);
          }
        }
      }
    }
  }
}

// View and projection are made up from the shadow matrix alone, and lead back to it.
TEST(Matrices, DerivedViewAndProjectionGiveTheShadowMatrix) {
  for (const bool reversed : {true, false}) {
    const CascadeSet set = unitys(4, reversed);
    for (const Cascade& c : read(dump_text(set, {.pair = false, .reversed_z = reversed})).set.cascades) {
      const glm::dmat4 back =
          shadow_transform(c.view, c.projection, ClipDepth::minus_one_to_one, reversed, c.offset_scale);
      for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
          EXPECT_NEAR(back[column][row], c.world_to_shadow[column][row], 1e-6) << column << " " << row;
        }
      }
    }
  }
}

TEST(Matrices, OrderMustBeStatedAndTrue) {
  const std::string text = dump_text(unitys(), {});
  std::string wrong = text;
  wrong.replace(wrong.find("row-major"), 9, "column-major");
  expect_input_error([&] { read(wrong); }, AllOf(StartsWith("f:2:"), HasSubstr("matrix_order is wrong")));
  std::string unknown = text;
  unknown.replace(unknown.find("row-major"), 9, "rowmajor");
  expect_input_error([&] { read(unknown); }, AllOf(StartsWith("f:1:"), HasSubstr("row-major")));
  std::string missing = text;
  missing.replace(missing.find("\"matrix_order\": \"row-major\", "), 29, "");
  expect_input_error([&] { read(missing); }, HasSubstr("'matrix_order' is missing"));
}

TEST(Matrices, WrongConventionIsSeenAndTheRightOneNamed) {
  const CascadeSet set = unitys();
  expect_input_error([&] { read(dump_text(set, {.clip_depth = "zero_to_one"})); },
                     HasSubstr("it matches with clip_depth minus_one_to_one and reversed_z true"));
  expect_input_error([&] { read(dump_text(set, {.reversed_z = false})); },
                     HasSubstr("it matches with clip_depth minus_one_to_one and reversed_z true"));
  const std::string light = fmt::format(", \"light_direction\": [{}, {}, {}]", set.light_direction.x,
                                        set.light_direction.y, set.light_direction.z);
  EXPECT_NO_THROW(read(dump_text(set, {.pair = false, .extra = light})));
  expect_input_error([&] { read(dump_text(set, {.pair = false, .reversed_z = false, .extra = light})); },
                     HasSubstr("depth runs against the light"));
}

TEST(Matrices, DeviceProjectionIsRefusedWithTheRemedy) {
  CascadeSet set = unitys();
  for (Cascade& c : set.cascades) {
    c.projection[2][2] *= -1.0;
    c.projection[3][2] *= -1.0;
  }
  expect_input_error([&] { read(dump_text(set, {.shadow = false})); },
                     AllOf(HasSubstr("already reversed"), HasSubstr("GetGPUProjectionMatrix")));
}

// A matrix of the last cascade is spoilt; the message stands at that matrix's line.
std::string spoilt_projection(const glm::dmat4& matrix) {
  CascadeSet set = unitys(2);
  set.cascades[1].projection = matrix;
  return dump_text(set, {.shadow = false});
}

TEST(Matrices, OnlyOrthographicLightProjectionsPass) {
  const glm::dmat4 good = unitys(2).cascades[1].projection;
  glm::dmat4 singular = good;
  singular[2][2] = 0.0;
  glm::dmat4 flat = good;
  flat[0] = glm::dvec4(good[0][0], good[0][0], 0, 0);
  flat[1] = glm::dvec4(0.0);
  glm::dmat4 sheared = good;
  sheared[1][0] = 0.1 * good[1][1];
  glm::dmat4 stretched = good;
  stretched[0][0] *= 1.01;
  struct Case {
    glm::dmat4 matrix;
    const char* reason;
  };
  const Case cases[] = {
      {glm::perspective(1.0, 1.0, 0.1, 100.0), "perspective projection: its last row is 0 0 -1 0"},
      {singular, "singular: row 2 is zero"},
      {flat, "singular: its rows lie in one plane"},
      {sheared, "sheared: the angle between rows 0 and 1"},
      {stretched, "stretched"},
      {glm::dmat4(0.0), "perspective"}};
  for (const Case& bad : cases) {
    expect_input_error([&] { read(spoilt_projection(bad.matrix)); },
                       AllOf(StartsWith("f:5:"), HasSubstr(bad.reason)));
  }
  EXPECT_NO_THROW(read(spoilt_projection(good)));
}

TEST(Matrices, ScaledViewIsRefused) {
  CascadeSet set = unitys(1);
  for (int c = 0; c < 3; ++c) set.cascades[0].view[c] *= 2.0;
  expect_input_error([&] { read(dump_text(set, {.shadow = false})); }, HasSubstr("is scaled: row 0"));
}

TEST(Matrices, InfiniteEntriesAreRefused) {
  std::string text = dump_text(unitys(1), {.pair = false});
  const auto first = text.find("\"world_to_shadow\": [") + 20;
  text.replace(first, text.find(',', first) - first, "1e999");
  expect_input_error([&] { read(text); }, StartsWith("f:2:"));
}

TEST(Matrices, NumberOfCascadesIsOneToFour) {
  CascadeSet set = unitys(4);
  set.cascades.push_back(set.cascades[0]);  // the no-op entry of _MainLightWorldToShadow
  expect_input_error([&] { read(dump_text(set, {})); },
                     AllOf(HasSubstr("5 cascades, outside 1 .. 4"), HasSubstr("no-op")));
  set.cascades.clear();
  expect_input_error([&] { read(dump_text(set, {})); }, HasSubstr("0 cascades"));
}

TEST(Matrices, OtherMistakesAreNamed) {
  const CascadeSet set = unitys(1);
  const auto with = [&](const char* extra) { return dump_text(set, {.extra = extra}); };
  expect_input_error([&] { read(with(", \"depth_bais\": 1")); }, HasSubstr("did you mean 'depth_bias'"));
  expect_input_error([&] { read(with(", \"angular_diameter_degrees\": 40")); }, HasSubstr("outside 0 .. 30"));
  expect_input_error([&] { read(with(", \"depth_bias\": -1")); }, HasSubstr("outside 0 .. 1000"));
  expect_input_error([&] { read(with(", \"light_direction\": [0, 0, 0]")); },
                     HasSubstr("is the zero vector"));
  expect_input_error([&] { read(dump_text(set, {.pair = false, .shadow = false})); }, HasSubstr("no matrix"));
  expect_input_error([&] { read("{}"); }, HasSubstr("matrix_order"));
  expect_input_error([&] { read(""); }, HasSubstr("empty"));
}

}  // namespace
}  // namespace penumbra::parameters
