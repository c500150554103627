#include "parameters/golden_cascades.h"

#include <fmt/format.h>

namespace penumbra::parameters {

namespace {

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

}  // namespace

std::vector<GoldenCascade> golden_cascades(int random, SetupGenerator& generator) {
  std::vector<GoldenCascade> list = awkward_cascades();
  for (GoldenCascade& awkward : list) awkward.parameters = as_floats(awkward.parameters);
  add_random_cascades(random, generator, list);
  return list;
}

}  // namespace penumbra::parameters
