#include "parameters/golden_vectors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

#include "parameters/golden_cameras.h"
#include "parameters/settings_input.h"
#include "parameters/update_schedule.h"

namespace penumbra::parameters {
namespace {

std::vector<SoftShadowParameters> awkward_settings() {
  SoftShadowParameters point;
  point.angular_diameter_degrees = 0;
  point.hdrp_search_degrees = 0;
  point.hdrp_min_filter_degrees = 0;
  const SoftShadowParameters low{.angular_diameter_degrees = -5,
                                 .blocker_samples = -3,
                                 .filter_samples = 0,
                                 .blocker_clump = -1,
                                 .min_filter_texels = -2,
                                 .max_penumbra_metres = -1,
                                 .max_sampling_metres = -1,
                                 .search_radius_metres = -1,
                                 .hdrp_search_degrees = -1,
                                 .hdrp_min_filter_degrees = -1};
  const SoftShadowParameters high{.angular_diameter_degrees = 31,
                                  .blocker_samples = 1000,
                                  .filter_samples = 1000,
                                  .blocker_clump = 9,
                                  .min_filter_texels = 65,
                                  .max_penumbra_metres = 1e7,
                                  .max_sampling_metres = 1e7,
                                  .search_radius_metres = 1e7,
                                  .hdrp_search_degrees = 120,
                                  .hdrp_min_filter_degrees = 180};
  SoftShadowParameters narrow_search;
  narrow_search.angular_diameter_degrees = 20;
  SoftShadowParameters wide_filter;
  wide_filter.hdrp_min_filter_degrees = 25;
  return {SoftShadowParameters{}, point, low, high, narrow_search, wide_filter};
}

glm::dmat4 scaled(const glm::dmat4& matrix, double across, double along) {
  glm::dmat4 result(1.0);
  for (int column = 0; column < 4; ++column) {
    result[column][0] = as_float(matrix[column][0] * across);
    result[column][1] = as_float(matrix[column][1] * across);
    result[column][2] = as_float(matrix[column][2] * along);
  }
  return result;
}

std::vector<GoldenCascade> awkward_cascades() {
  ShadowSetup setup;
  setup.shadows.cascades = 4;
  GoldenCascade usual;
  usual.name = "four cascades";
  usual.world_to_shadow = scaled(setup.fit().cascades[1].world_to_shadow, 1, 1);
  std::vector<GoldenCascade> list{usual};
  const auto add = [&](const char* name, auto&& change) {
    list.push_back(usual);
    list.back().name = name;
    change(list.back());
  };
  add("point light", [](GoldenCascade& c) { c.parameters.angular_diameter_degrees = 0; });
  add("widest light", [](GoldenCascade& c) { c.parameters.angular_diameter_degrees = 30; });
  add("angle near nothing", [](GoldenCascade& c) { c.parameters.angular_diameter_degrees = 1e-30; });
  add("no bias", [](GoldenCascade& c) { c.depth_bias = c.normal_bias = 0; });
  add("a thousand kilometres wide",
      [](GoldenCascade& c) { c.world_to_shadow = scaled(c.world_to_shadow, 1e-5, 1e-5); });
  add("a tenth of a millimetre wide",
      [](GoldenCascade& c) { c.world_to_shadow = scaled(c.world_to_shadow, 1e5, 1e5); });
  add("near the smallest floats",
      [](GoldenCascade& c) { c.world_to_shadow = scaled(c.world_to_shadow, 1e-30, 1e-33); });
  add("near the largest floats",
      [](GoldenCascade& c) { c.world_to_shadow = scaled(c.world_to_shadow, 1e30, 1e33); });
  add("flat in depth", [](GoldenCascade& c) { c.world_to_shadow = scaled(c.world_to_shadow, 1, 1e9); });
  add("sheared", [](GoldenCascade& c) { c.world_to_shadow[1][0] = c.world_to_shadow[0][2] = 0.25; });
  add("far from the origin", [](GoldenCascade& c) { c.world_to_shadow[3] = {1e9, -1e9, 1e9, 1}; });
  add("smallest map", [](GoldenCascade& c) { c.resolution = 8; });
  add("odd map of two", [](GoldenCascade& c) {
    c.resolution = 1023;
    c.cascades = 2;
  });
  return list;
}

void add_random_cascades(int count, SetupGenerator& generator, std::vector<GoldenCascade>& list) {
  for (int i = 0; i < count; ++i) {
    const ShadowSetup setup = generator.next();
    const SoftShadowParameters parameters = random_settings(generator);
    const CascadeSet set = setup.fit();
    const int index = generator.integer(0, setup.shadows.cascades - 1);
    list.push_back(
        {.name = fmt::format("random {}", i),
         .world_to_shadow = scaled(set.cascades[static_cast<std::size_t>(index)].world_to_shadow, 1, 1),
         .resolution = setup.shadows.resolution,
         .cascades = setup.shadows.cascades,
         .parameters = parameters,
         .depth_bias = as_float(generator.uniform(0, 10)),
         .normal_bias = as_float(generator.uniform(0, 10)),
         .quality = setup.shadows.soft_quality});
  }
}

std::string number(double value) {
  return fmt::format("{}", static_cast<float>(value));
}

std::string numbers(const glm::dvec4& v) {
  return fmt::format("[{}, {}, {}, {}]", number(v.x), number(v.y), number(v.z), number(v.w));
}

std::string numbers(const glm::dmat4& row_major_of) {
  std::vector<float> values;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      values.push_back(static_cast<float>(row_major_of[column][row]));
    }
  }
  return fmt::format("[{}]", fmt::join(values, ", "));
}

// A JSON object on one line, key by key.
class Record {
 public:
  Record& add(const char* key, const std::string& json) {
    text_ += fmt::format("{}\"{}\": {}", text_.empty() ? "" : ", ", key, json);
    return *this;
  }
  Record& add(const char* key, double value) { return add(key, number(value)); }
  Record& add(const char* key, int value) { return add(key, fmt::format("{}", value)); }
  Record& add(const char* key, bool value) { return add(key, std::string(value ? "true" : "false")); }
  Record& add_vector(const char* key, const glm::dvec4& value) { return add(key, numbers(value)); }
  Record& add_matrix(const char* key, const glm::dmat4& value) { return add(key, numbers(value)); }
  Record& add_name(const char* key, const std::string& name) { return add(key, "\"" + name + "\""); }

  std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

using Records = std::vector<std::string>;

std::string section(const char* name, const Records& records) {
  return fmt::format("  \"{}\": [\n    {}\n  ]", name, fmt::join(records, ",\n    "));
}

Records angles(int count, SetupGenerator& generator) {
  std::vector<double> degrees{
      0,  std::numeric_limits<float>::denorm_min(), 1e-30, 1e-6, 0.53, 1, 12, 29.999998, 30, -1, 30.000002,
      1e9};
  for (int i = 0; i < count; ++i) {
    degrees.push_back(i % 2 == 0 ? generator.uniform(0, 30) : std::pow(10.0, generator.uniform(-12, 1.47)));
  }
  Records records;
  for (const double given : degrees) {
    const double tan_half = as_float(tan_half_of(as_float(given)));
    Record record;
    record.add("degrees", given).add("tan_half", tan_half).add("degrees_back", degrees_of(tan_half));
    records.push_back(record.text());
  }
  return records;
}

Records atlases() {
  Records records;
  for (const int resolution : {8, 256, 1000, 1023, 2048, 8192, 16384}) {
    for (int cascades = 1; cascades <= 4; ++cascades) {
      const AtlasLayout layout = atlas_layout(resolution, cascades);
      std::vector<std::string> tiles;
      tiles.reserve(static_cast<std::size_t>(cascades));
      for (int i = 0; i < cascades; ++i) tiles.push_back(numbers(tile_rectangle(layout, i)));
      Record record;
      record.add("resolution", resolution).add("cascades", cascades).add("width", layout.width);
      record.add("height", layout.height).add("tile_resolution", layout.tile_resolution);
      record.add_vector("texel_size", shader_uniforms({}, layout, cascades, 0).atlas_texel_size);
      records.push_back(record.add("tiles", fmt::format("[{}]", fmt::join(tiles, ", "))).text());
    }
  }
  return records;
}

Records schedules() {
  Records records;
  constexpr std::array kPeriods{1, 2, 8, 64};
  for (int i = 0; i < 256; i += 3) {
    std::vector<int> periods;
    for (int rest = i, cascade = 0; cascade < 1 + i % 4; ++cascade, rest /= 4)
      periods.push_back(kPeriods.at(static_cast<std::size_t>(rest % 4)));
    const UpdateSchedule schedule = update_schedule(periods);
    const auto all = [](const std::array<int, kMostScheduled>& of) {
      return numbers({of[0], of[1], of[2], of[3]});
    };
    const int frame = 7 * i - 500;  // negative ones, too
    Record record;
    record.add("cascades", schedule.cascades).add("periods", all(schedule.periods));
    record.add("phases", all(schedule.phases)).add("frame", frame).add("due", schedule.due(frame));
    records.push_back(record.text());
  }
  return records;
}

Record& add_parameters(Record& record, const SoftShadowParameters& parameters) {
  return record.add("degrees", parameters.angular_diameter_degrees)
      .add("blocker_samples", parameters.blocker_samples)
      .add("filter_samples", parameters.filter_samples)
      .add("blocker_clump", parameters.blocker_clump)
      .add("min_filter_texels", parameters.min_filter_texels)
      .add("max_penumbra_metres", parameters.max_penumbra_metres)
      .add("max_sampling_metres", parameters.max_sampling_metres)
      .add("search_radius_metres", parameters.search_radius_metres)
      .add("hdrp_search_degrees", parameters.hdrp_search_degrees)
      .add("hdrp_min_filter_degrees", parameters.hdrp_min_filter_degrees);
}

Records uniforms(int count, SetupGenerator& generator) {
  Records records;
  for (const SoftShadowParameters& given : golden_settings(count, generator)) {
    const int resolution = 256 << generator.integer(0, 5);
    const int cascades = generator.integer(1, 4);
    const int frame = generator.integer(-100, 1000000);
    const ShaderUniforms packed = shader_uniforms(given, atlas_layout(resolution, cascades), cascades, frame);
    Record record;
    add_parameters(record, given).add("resolution", resolution).add("cascades", cascades).add("frame", frame);
    record.add_vector("atlas_texel_size", packed.atlas_texel_size)
        .add_vector("main_light_params", packed.main_light_params)
        .add("hdrp_search_tan_half", packed.hdrp_tan_half.x)
        .add("hdrp_min_filter_tan_half", packed.hdrp_tan_half.y);
    records.push_back(record.text());
  }
  return records;
}

Cascade answer_to(const GoldenCascade& given) {
  const AtlasLayout layout = atlas_layout(given.resolution, given.cascades);
  CascadeSet set;
  set.angular_diameter_degrees = given.parameters.angular_diameter_degrees;
  set.tile_resolution = layout.tile_resolution;
  ShadowSettings settings;
  settings.depth_bias = given.depth_bias;
  settings.normal_bias = given.normal_bias;
  settings.soft_quality = given.quality;
  Cascade cascade;
  cascade.world_to_shadow = given.world_to_shadow;
  cascade.offset_scale = tile_rectangle(layout, 0);
  derive_scales(set, settings, cascade);
  return cascade;
}

Records cascades(int count, SetupGenerator& generator) {
  Records records;
  for (const GoldenCascade& given : golden_cascades(count, generator)) {
    const Cascade cascade = answer_to(given);
    const HdrpVectors hdrp = hdrp_vectors(cascade, given.parameters);
    Record record;
    record.add_name("name", given.name).add_matrix("world_to_shadow", given.world_to_shadow);
    record.add("resolution", given.resolution).add("cascades", given.cascades);
    add_parameters(record, given.parameters);
    record.add("depth_bias", given.depth_bias).add("normal_bias", given.normal_bias);
    record.add_name("soft_quality", name_of(given.quality));
    record.add("uv_per_metre", cascade.uv_per_metre)
        .add("depth_per_metre", cascade.depth_per_metre)
        .add("depth_to_radial", cascade.depth_to_radial)
        .add("radial_to_depth", cascade.radial_to_depth.value_or(0.0))
        .add("depth_to_radial_hdrp", cascade.depth_to_radial_hdrp)
        .add("texel_size_metres", cascade.texel_size_metres)
        .add("max_penumbra_texels", cascade.max_penumbra_texels)
        .add("bias_depth", cascade.depth_bias_metres)
        .add("bias_normal", cascade.normal_bias_metres)
        .add_vector("hdrp_params0", hdrp.params0)
        .add_vector("hdrp_params1", hdrp.params1);
    records.push_back(record.text());
  }
  return records;
}

Records projections(int count, SetupGenerator& generator) {
  Records records;
  for (int i = 0; i < count; ++i) {
    const ShadowSetup setup = generator.next();
    const CascadeSet set = setup.fit();
    glm::dmat4 projection = set.cascades.back().projection;
    projection[0][0] = as_float(projection[0][0]);
    ShadowSettings settings = setup.shadows;
    settings.depth_bias = as_float(generator.uniform(0, 10));
    settings.normal_bias = as_float(generator.uniform(0, 10));
    const glm::dvec2 bias = bias_of_projection(projection, set.tile_resolution, settings);
    Record record;
    record.add("m00", projection[0][0]).add("tile_resolution", set.tile_resolution);
    record.add("depth_bias", settings.depth_bias).add("normal_bias", settings.normal_bias);
    record.add_name("soft_quality", name_of(settings.soft_quality));
    records.push_back(record.add("bias_depth", bias.x).add("bias_normal", bias.y).text());
  }
  return records;
}

Records cameras(int count, SetupGenerator& generator) {
  Records records;
  for (const GoldenCamera& camera : golden_cameras(count, generator)) {
    const auto answer = screen_to_world(camera.view, camera.gpu_projection, camera.conventions);
    Record record;
    record.add_name("name", camera.name).add_matrix("view", camera.view);
    record.add_matrix("gpu_projection", camera.gpu_projection);
    record.add("uv_starts_at_top", camera.conventions.uv_starts_at_top);
    record.add("depth_is_zero_to_one", camera.conventions.depth_is_zero_to_one);
    records.push_back(record.add_matrix("screen_to_world", answer.value_or(glm::dmat4(0.0))).text());
  }
  return records;
}

}  // namespace

std::string golden_vectors_json(int count, std::uint32_t seed) {
  SetupGenerator generator(seed);
  const std::vector<std::string> sections{
      fmt::format("  \"written_by\": \"penumbra constants --golden {} --seed {}\"", count, seed),
      "  \"matrix_order\": \"row-major\"",
      section("angles", angles(count, generator)),
      section("atlases", atlases()),
      section("cascades", cascades(count, generator)),
      section("projections", projections(count, generator)),
      section("uniforms", uniforms(count, generator)),
      section("cameras", cameras(count, generator)),
      section("schedules", schedules())};
  return fmt::format("{{\n{}\n}}\n", fmt::join(sections, ",\n"));
}

double as_float(double value) {
  return static_cast<double>(static_cast<float>(value));
}

SoftShadowParameters as_floats(SoftShadowParameters parameters) {
  for (double SoftShadowParameters::*field :
       {&SoftShadowParameters::angular_diameter_degrees, &SoftShadowParameters::blocker_clump,
        &SoftShadowParameters::min_filter_texels, &SoftShadowParameters::max_penumbra_metres,
        &SoftShadowParameters::max_sampling_metres, &SoftShadowParameters::search_radius_metres,
        &SoftShadowParameters::hdrp_search_degrees, &SoftShadowParameters::hdrp_min_filter_degrees}) {
    parameters.*field = as_float(parameters.*field);
  }
  return parameters;
}

SoftShadowParameters random_settings(SetupGenerator& generator) {
  const auto up_to = [&](double high) { return as_float(generator.uniform(0, high)); };
  SoftShadowParameters parameters;
  parameters.angular_diameter_degrees = up_to(30);
  parameters.blocker_samples = generator.integer(1, 128);
  parameters.filter_samples = generator.integer(1, 64);
  parameters.blocker_clump = up_to(8);
  parameters.min_filter_texels = up_to(64);
  parameters.max_penumbra_metres = up_to(100);
  parameters.max_sampling_metres = up_to(1000);
  parameters.search_radius_metres = up_to(10);
  parameters.hdrp_search_degrees = up_to(40);
  parameters.hdrp_min_filter_degrees = up_to(40);
  return parameters;
}

std::vector<SoftShadowParameters> golden_settings(int random, SetupGenerator& generator) {
  std::vector<SoftShadowParameters> list;
  for (const SoftShadowParameters& awkward : awkward_settings()) list.push_back(as_floats(awkward));
  for (int i = 0; i < random; ++i) list.push_back(random_settings(generator));
  return list;
}

std::vector<GoldenCascade> golden_cascades(int random, SetupGenerator& generator) {
  std::vector<GoldenCascade> list = awkward_cascades();
  for (GoldenCascade& awkward : list) awkward.parameters = as_floats(awkward.parameters);
  add_random_cascades(random, generator, list);
  return list;
}

}  // namespace penumbra::parameters
