// Measures errors of soft shadows through distance fields against ray tracing: those of several marches by
// the penumbra's width, and those of several ways to combine objects. It writes JSON, from which
// scripts/pages makes the tables of Documentation~/other-shadows.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "bake/made_shapes.h"
#include "bake/ray_traced_share.h"
#include "bake/visibility_kernel.h"
#include "input/json_lines.h"
#include "platform/atomic_file.h"
#include "platform/source_commit.h"
#include "scene/scene.h"

namespace penumbra::bake {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVoxels = 64;
constexpr std::size_t kReceivers = 1024;
constexpr int kRays = 1024;
const glm::dvec3 kTowards = glm::normalize(glm::dvec3(0.36, 0.8, 0.48));

class Random {
 public:
  explicit Random(std::uint32_t seed) : bits_(seed) {}
  double chance() { return static_cast<double>(bits_()) * 0x1p-32; }
  double between(double low, double high) { return low + (high - low) * chance(); }

 private:
  std::mt19937 bits_;
};

// The scene scaled so that its longest side is 1 m, with its middle at the origin.
scene::Scene of_one_metre(scene::Scene scene) {
  const parameters::Bounds bounds = scene.bounds();
  const glm::dvec3 size = bounds.maximum - bounds.minimum, middle = 0.5 * (bounds.maximum + bounds.minimum);
  const double longest = std::max({size.x, size.y, size.z});
  for (glm::vec3& position : scene.mesh.positions)
    position = glm::vec3((glm::dvec3(position) - middle) / longest);
  return scene;
}

struct Receivers {
  std::vector<glm::vec4> places;
  std::vector<double> exact;
};

// Places in a penumbra, on a plane across the light, so far below the origin.
Receivers in_penumbra(const reference::EmbreeScene& rays, const SeenDisc& light, double below, double reach) {
  Receivers all;
  Random random(3);
  for (int i = 0; i < 200'000 && all.places.size() < kReceivers; ++i) {
    const glm::dvec3 at = -below * light.towards + random.between(-reach, reach) * light.right() +
                          random.between(-reach, reach) * light.up();
    const double rough = lit_share(rays, at, light, 32);
    if (rough == 0.0 || rough == 1.0) continue;
    all.places.emplace_back(glm::vec3(at), 1.0F);
    all.exact.push_back(lit_share(rays, at, light, kRays));
  }
  return all;
}

double rounded(double value) {
  return std::round(1e4 * value) / 1e4;
}

double rmse(const std::vector<double>& seen, const std::vector<double>& exact) {
  double sum = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) sum += (seen[i] - exact[i]) * (seen[i] - exact[i]);
  return std::sqrt(sum / static_cast<double>(exact.size()));
}

struct MarchParameters {
  float corner[4];
  float size[4];
  float light[4];
  float march[4];
};

Json errors_of(const gpu::Device& device, const std::string& name, const scene::Scene& scene) {
  ObjectFields fields = bake_object_fields(scene, {1, {kVoxels, 0.1}});
  const gpu::Image image = texture_of(device, fields.voxels, fields.texels());
  const std::vector<glm::vec4> rows = fields.rows(glm::dvec3(0.0));
  const reference::EmbreeScene rays(scene);
  Json all = Json::array();
  for (const double width : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
    constexpr double kBelow = 2.0;
    const SeenDisc light{kTowards, width / (2.0 * kBelow)};
    const Receivers receivers = in_penumbra(rays, light, kBelow, 0.75 + width);
    MarchParameters parameters{};
    for (int i = 0; i < 3; ++i) parameters.light[i] = static_cast<float>(light.towards[i]);
    for (int i = 0; i < 4; ++i) {
      parameters.corner[i] = rows[3][i];
      parameters.size[i] = rows[4][i];
    }
    parameters.light[3] = static_cast<float>(light.tan_half);
    parameters.march[0] = 1000.0F;
    parameters.march[1] = 256.0F;
    for (const char* march : {"Quilez", "Aaltonen", "QuilezInner", "Cone", "Soft"}) {
      const std::vector<float> answers = run_kernel(device, "FieldMarches.hlsl", march, {{"_Field", &image}},
                                                    parameters, receivers.places, 2);
      std::vector<double> seen;
      double fetches = 0.0, bias = 0.0;
      for (std::size_t i = 0; i < receivers.exact.size(); ++i) {
        seen.push_back(static_cast<double>(answers[2 * i]));
        bias += seen.back() - receivers.exact[i];
        fetches += static_cast<double>(answers[2 * i + 1]);
      }
      const auto count = static_cast<double>(receivers.exact.size());
      all.push_back({{"shape", name},
                     {"width_metres", width},
                     {"march", march},
                     {"rmse", rounded(rmse(seen, receivers.exact))},
                     {"bias", rounded(bias / count)},
                     {"fetches", std::round(fetches / count)},
                     {"receivers", receivers.exact.size()}});
    }
  }
  return all;
}

constexpr std::size_t kParts = 6;

// The shares of several objects, combined in the three ways.
struct Shares {
  double product = 1.0, least = 1.0, covered = 0.0;

  void add(double share) {
    product *= share;
    least = std::min(least, share);
    covered += 1.0 - share;
  }
  double sum() const { return std::max(0.0, 1.0 - covered); }
};

struct SceneParameters {
  float light[4];
  float march[4];
  float normal[4];
};

// The errors of each object's share alone, and of the shares combined in the three ways.
Json errors_of_objects(const gpu::Device& device, const std::string& name,
                       const std::vector<scene::Scene>& objects, double width) {
  const scene::Scene scene = joined(objects);
  const ObjectFields fields = bake_object_fields(scene, {static_cast<int>(objects.size()), {32, 0.1}});
  const gpu::Image image = texture_of(device, fields.voxels, fields.texels());
  const reference::EmbreeScene rays(scene);
  constexpr double kBelow = 4.0;
  const SeenDisc light{kTowards, width / (2.0 * kBelow)};
  const Receivers receivers = in_penumbra(rays, light, kBelow, 1.5 + width);
  SceneParameters parameters{};
  for (int i = 0; i < 3; ++i) parameters.light[i] = static_cast<float>(light.towards[i]);
  parameters.light[3] = static_cast<float>(light.tan_half);
  parameters.march[0] = 1000.0F;
  parameters.march[1] = 256.0F;
  const std::vector<glm::vec4> uniforms = field_uniforms(fields);
  std::vector<std::vector<float>> alone;  // six parts of each receiver
  for (std::size_t i = 0; i < fields.objects.size(); ++i) {
    std::vector<glm::vec4> one = uniforms;
    one[0].w = 1.0F;
    for (std::size_t row = 0; row < 6; ++row) one[1 + row] = uniforms[1 + 6 * i + row];
    alone.push_back(run_kernel(device, "FieldScene.hlsl", "Parts", {{"_Field", &image}}, parameters,
                               receivers.places, kParts, one));
  }
  std::map<std::string, std::vector<double>> combined;
  std::vector<double> exact;
  for (std::size_t i = 0; i < receivers.exact.size(); ++i) {
    Shares whole;
    std::array<Shares, kParts> parts;
    int partly = 0;
    for (const std::vector<float>& object : alone) {
      double mean = 0.0;
      for (std::size_t part = 0; part < kParts; ++part) {
        const double share = static_cast<double>(object[kParts * i + part]);
        parts[part].add(share);
        mean += share / kParts;
      }
      whole.add(mean);
      partly += mean < 1.0 - 1e-6 ? 1 : 0;
    }
    if (partly < 2) continue;
    combined["product"].push_back(whole.product);
    combined["minimum"].push_back(whole.least);
    combined["sum"].push_back(whole.sum());
    double product = 0.0, least = 0.0, sum = 0.0;
    for (const Shares& part : parts) {
      product += part.product / kParts;
      least += part.least / kParts;
      sum += part.sum() / kParts;
    }
    combined["product_of_parts"].push_back(product);
    combined["minimum_of_parts"].push_back(least);
    combined["sum_of_parts"].push_back(sum);
    exact.push_back(receivers.exact[i]);
  }
  if (exact.empty()) throw std::runtime_error("no receiver of '" + name + "' is in two penumbrae");
  Json record = {{"scene", name}, {"objects", fields.objects.size()}, {"width_metres", width}};
  for (const char* way :
       {"product", "minimum", "sum", "product_of_parts", "minimum_of_parts", "sum_of_parts"})
    record[way] = rounded(rmse(combined[way], exact));
  record["receivers"] = exact.size();
  return record;
}

std::vector<scene::Scene> strewn(int count, std::uint32_t seed, double spread) {
  Random random(seed);
  std::vector<scene::Scene> all;
  for (int i = 0; i < count; ++i) {
    const double size = random.between(0.15, 0.35);
    const glm::dvec3 place(random.between(-spread, spread), random.between(-spread, spread),
                           random.between(-spread, spread));
    const scene::Scene shape =
        i % 2 == 0 ? sphere(size, 32, 24)
                   : box(glm::vec3(static_cast<float>(size), 0.6F * static_cast<float>(size), 0.2F));
    all.push_back(moved(shape, place));
  }
  return all;
}

Json run() {
  const gpu::Device device({.name = "", .validation = false});
  scene::ImportOptions import;
  import.ground = false;
  const std::vector<std::pair<std::string, scene::Scene>> shapes{
      {"sphere", sphere(1.0, 96, 64)},
      {"box", box({1.0F, 0.6F, 0.4F})},
      {"torus", torus(1.0, 0.2, 96, 48)},
      {"bar", box({0.05F, 1.0F, 0.05F})},
      {"plate", box({1.0F, 0.05F, 0.6F})},
      {"package:glmark2/bunny", scene::load("package:glmark2/bunny", import)}};
  Json marches = Json::array(), objects = Json::array();

  for (const auto& [name, scene] : shapes)
    for (Json& record : errors_of(device, name, of_one_metre(scene))) marches.push_back(std::move(record));
  for (const double width : {0.1, 0.4, 1.0}) {
    std::vector<scene::Scene> row;
    for (int i = 0; i < 5; ++i)
      row.push_back(moved(box({0.05F, 0.8F, 0.05F}), glm::dvec3(0.25 * i - 0.5, 0.0, 0.0)));
    objects.push_back(errors_of_objects(device, "bars side by side", row, width));
    std::vector<scene::Scene> crossed{box({0.9F, 0.08F, 0.08F}),
                                      moved(box({0.08F, 0.08F, 0.9F}), 0.8 * kTowards)};
    objects.push_back(errors_of_objects(device, "crossed bars", crossed, width));
    std::vector<scene::Scene> stacked{sphere(0.4, 48, 32), moved(sphere(0.4, 48, 32), 1.0 * kTowards)};
    objects.push_back(errors_of_objects(device, "one behind the other", stacked, width));
    for (const int count : {4, 8, 16})
      objects.push_back(errors_of_objects(device, fmt::format("{} strewn", count),
                                          strewn(count, static_cast<std::uint32_t>(count), 1.0), width));
  }
  return {{"command", "penumbra_field_errors FILE"},
          {"commit", platform::source_commit().value_or("")},
          {"device", device.info().name},
          {"voxels", kVoxels},
          {"rays", kRays},
          {"marches", std::move(marches)},
          {"objects", std::move(objects)}};
}

}  // namespace
}  // namespace penumbra::bake

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "usage: penumbra_field_errors FILE\n");
    return 2;
  }
  try {
    penumbra::platform::write_file_atomically(arguments[1],
                                              penumbra::json_lines(penumbra::bake::run().dump()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "penumbra_field_errors: {}\n", error.what());
    return 1;
  }
  return 0;
}
