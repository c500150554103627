#include "lighting/sky_light.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "lighting/seen_materials.h"
#include "platform/byte_stream.h"
#include "platform/cache_store.h"
#include "platform/hashed_fields.h"
#include "reference/embree_scene.h"
#include "reference/lit_receiver.h"
#include "scene/cut_out.h"

namespace penumbra::lighting {
namespace {

constexpr std::array<float, 5> kSpline{1.0F / 16, 1.0F / 4, 3.0F / 8, 1.0F / 4, 1.0F / 16};

// Returns 1 for a neighbour on the same plane that faces the same way. The weight falls towards 0 over some
// 15 degrees or a slope of one tenth.
float likeness(const SurfacePoint& point, const SurfacePoint& other) {
  const float cosine = glm::dot(point.normal, other.normal);
  if (cosine <= 0.9F) return 0.0F;
  const glm::vec3 apart = other.position - point.position;
  const float distance = glm::length(apart);
  if (distance == 0.0F) return 1.0F;
  const float slope = std::abs(glm::dot(apart, point.flat_normal)) / distance;
  const float facing = (cosine - 0.9F) * 10.0F;
  return facing * facing * std::max(1.0F - 10.0F * slope, 0.0F);
}

std::vector<glm::vec3> one_pass(const SeenMaterials& seen, const std::vector<glm::vec3>& light, int step,
                                const reference::RunOptions& run) {
  std::vector<glm::vec3> result(light.size(), glm::vec3(0.0F));
  const auto index = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(seen.width) +
           static_cast<std::size_t>(column);
  };
  reference::for_each_row(seen.height, run, [&](int row) {
    for (int column = 0; column < seen.width; ++column) {
      const std::size_t pixel = index(column, row);
      if (seen.seen[pixel] == 0) continue;
      glm::vec3 sum(0.0F);
      float weights = 0.0F;
      for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
          const int x = column + i * step;
          const int y = row + j * step;
          if (x < 0 || y < 0 || x >= seen.width || y >= seen.height || seen.seen[index(x, y)] == 0) continue;
          const std::size_t other = index(x, y);
          const float weight = kSpline[static_cast<std::size_t>(i + 2)] *
                               kSpline[static_cast<std::size_t>(j + 2)] *
                               likeness(seen.points[pixel], seen.points[other]);
          sum += light[other] * weight;
          weights += weight;
        }
      }
      result[pixel] = weights > 0.0F ? sum / weights : light[pixel];
    }
  });
  return result;
}

constexpr std::string_view kKind = "light";
constexpr int kVersion = 1;  // increased whenever a change affects any result

std::string key_of(const scene::Scene& scene, const SeenMaterials& seen, const Surroundings& surroundings,
                   int rays) {
  std::vector<float> translucencies;
  for (const scene::Material& material : scene.materials) translucencies.push_back(material.translucency);
  return platform::hash_of(kKind, kVersion, rays, scene.mesh.positions, scene.mesh.indices,
                           scene.mesh.triangle_materials, scene::CutOuts(scene), mean_colours(scene),
                           translucencies, surroundings.sky.table(), surroundings.to_sun, surroundings.sun,
                           seen.width, seen.height, seen.seen, seen.points);
}

constexpr int kPacket = 16;
constexpr float kUnbounded = std::numeric_limits<float>::infinity();
constexpr float kSkySeenByOthers = 0.5F;  // share of the sky that reaches a surface which a ray meets

// Two axes beside a unit one (Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017).
struct Axes {
  explicit Axes(const glm::vec3& normal) : n(normal) {
    const float sign = std::copysign(1.0F, n.z);
    const float a = -1.0F / (sign + n.z);
    const float b = n.x * n.y * a;
    t = {1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x};
    s = {b, sign + n.y * n.y * a, -n.y};
  }

  glm::vec3 n, t, s;
};

// Returns two numbers in [0, 1) that differ from pixel to pixel (PCG, Jarzynski and Olano, JCGT 2020).
glm::vec2 turn_of(std::size_t pixel) {
  const auto pcg = [](std::uint32_t value) {
    const std::uint32_t state = value * 747796405U + 2891336453U;
    const std::uint32_t word = ((state >> ((state >> 28U) + 4U)) ^ state) * 277803737U;
    return (word >> 22U) ^ word;
  };
  const std::uint32_t first = pcg(static_cast<std::uint32_t>(pixel));
  constexpr float kScale = 1.0F / 16777216.0F;
  return {float(first >> 8U) * kScale, float(pcg(first) >> 8U) * kScale};
}

// Returns the direction of ray i of count, cosine-weighted about +n: a golden spiral over the disc, lifted
// onto the hemisphere.
glm::vec3 cosine_direction(const Axes& axes, int i, int count, const glm::vec2& turn) {
  const float radius2 = (float(i) + turn.x) / float(count);
  const float angle =
      2.0F * std::numbers::pi_v<float> * (float(i) * (std::numbers::phi_v<float> - 1.0F) + turn.y);
  const float radius = std::sqrt(radius2);
  return axes.t * (radius * std::cos(angle)) + axes.s * (radius * std::sin(angle)) +
         axes.n * std::sqrt(std::max(1.0F - radius2, 0.0F));
}

glm::vec3 lifted(const glm::vec3& position, const glm::vec3& normal) {
  return position + normal * static_cast<float>(reference::surface_offset(position));
}

class Gatherer {
 public:
  Gatherer(const scene::Scene& scene, const Surroundings& surroundings, int rays)
      : scene_(scene),
        surroundings_(surroundings),
        embree_(scene),
        colours_(mean_colours(scene)),
        packets_((rays + kPacket - 1) / kPacket) {}

  glm::vec3 gather(const SurfacePoint& point, std::size_t pixel) const {
    const int count = packets_ * kPacket;
    const int behind = static_cast<int>(std::lround(point.translucency * float(count)));
    const glm::vec2 turn = turn_of(pixel);
    glm::vec3 sum(0.0F);
    for (int packet = 0; packet < packets_; ++packet) {
      alignas(64) RTCRayHit16 rays;
      glm::vec3 directions[kPacket];
      for (int lane = 0; lane < kPacket; ++lane) {
        // The rays of both sides are interleaved, so that each side's rays cover the whole spiral.
        const int i = packet * kPacket + lane;
        const bool other_side = behind > 0 && (i * behind) % count < behind;
        directions[lane] = direction(point, i, count, turn, other_side);
        set_ray(rays, lane, lifted(point.position, other_side ? -point.flat_normal : point.flat_normal),
                directions[lane]);
      }
      sum += light_along(rays, directions);
    }
    return sum / float(count);
  }

 private:
  static glm::vec3 direction(const SurfacePoint& point, int i, int count, const glm::vec2& turn,
                             bool behind) {
    const float side = behind ? -1.0F : 1.0F;
    const glm::vec3 flat = side * point.flat_normal;
    const glm::vec3 direction = cosine_direction(Axes(side * point.normal), i, count, turn);
    const float height = glm::dot(direction, flat);
    return height > 0.0F ? direction : direction - 2.0F * height * flat;
  }

  static void set_ray(RTCRayHit16& rays, int lane, const glm::vec3& origin, const glm::vec3& direction) {
    rays.ray.org_x[lane] = origin.x;
    rays.ray.org_y[lane] = origin.y;
    rays.ray.org_z[lane] = origin.z;
    rays.ray.dir_x[lane] = direction.x;
    rays.ray.dir_y[lane] = direction.y;
    rays.ray.dir_z[lane] = direction.z;
    rays.ray.tnear[lane] = 0.0F;
    rays.ray.tfar[lane] = kUnbounded;
    rays.ray.time[lane] = 0.0F;
    rays.ray.mask[lane] = ~0U;
    rays.ray.id[lane] = 0;
    rays.ray.flags[lane] = 0;
    rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
  }

  struct Met {
    glm::vec3 position;
    glm::vec3 normal;  // towards the ray
    const glm::vec3* colour;
    float translucency;
  };

  glm::vec3 light_along(RTCRayHit16& rays, const glm::vec3* directions) const {
    alignas(64) int all[kPacket];
    std::fill(all, all + kPacket, -1);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect16(all, embree_.handle(), &context, &rays);

    glm::vec3 sum(0.0F);
    alignas(64) int asks[kPacket];  // lanes that need a shadow ray to the sun
    // Where Embree traces 16 rays as two packets of 8, it also looks at the rays that are not asked for.
    alignas(64) RTCRay16 shadow{};
    glm::vec3 of_sun[kPacket];
    for (int lane = 0; lane < kPacket; ++lane) {
      asks[lane] = 0;
      shadow.tfar[lane] = -1.0F;  // before tnear, which is 0: no ray
      if (rays.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) {
        sum += surroundings_.sky.radiance(directions[lane]);
        continue;
      }
      const Met met = met_by(rays, lane, directions[lane]);
      const glm::vec3 under_sky = surroundings_.sky.irradiance(met.normal) * kSkySeenByOthers;
      sum += *met.colour * under_sky / std::numbers::pi_v<float>;
      const float cosine = glm::dot(met.normal, surroundings_.to_sun);
      const float share = cosine > 0.0F ? 1.0F - met.translucency : met.translucency;
      if (share == 0.0F) continue;
      of_sun[lane] = *met.colour * surroundings_.sun * (share * std::abs(cosine) / std::numbers::pi_v<float>);
      set_shadow_ray(shadow, lane, lifted(met.position, cosine > 0.0F ? met.normal : -met.normal));
      asks[lane] = -1;
    }
    if (std::none_of(asks, asks + kPacket, [](int ask) { return ask != 0; })) return sum;
    rtcOccluded16(asks, embree_.handle(), &context, &shadow);
    for (int lane = 0; lane < kPacket; ++lane) {
      if (asks[lane] != 0 && shadow.tfar[lane] >= 0.0F) sum += of_sun[lane];
    }
    return sum;
  }

  Met met_by(const RTCRayHit16& rays, int lane, const glm::vec3& direction) const {
    const std::size_t triangle = embree_.triangle(rays.hit.geomID[lane], rays.hit.primID[lane]);
    const glm::vec3 origin(rays.ray.org_x[lane], rays.ray.org_y[lane], rays.ray.org_z[lane]);
    glm::vec3 normal(rays.hit.Ng_x[lane], rays.hit.Ng_y[lane], rays.hit.Ng_z[lane]);
    normal = glm::normalize(glm::dot(normal, direction) > 0.0F ? -normal : normal);
    const std::size_t material = scene_.mesh.material_of(triangle);
    return {origin + direction * rays.ray.tfar[lane], normal, &colours_[material],
            std::clamp(scene_.materials[material].translucency, 0.0F, 1.0F)};
  }

  void set_shadow_ray(RTCRay16& rays, int lane, const glm::vec3& origin) const {
    rays.org_x[lane] = origin.x;
    rays.org_y[lane] = origin.y;
    rays.org_z[lane] = origin.z;
    rays.dir_x[lane] = surroundings_.to_sun.x;
    rays.dir_y[lane] = surroundings_.to_sun.y;
    rays.dir_z[lane] = surroundings_.to_sun.z;
    rays.tnear[lane] = 0.0F;
    rays.tfar[lane] = kUnbounded;
    rays.time[lane] = 0.0F;
    rays.mask[lane] = ~0U;
    rays.id[lane] = 0;
    rays.flags[lane] = 0;
  }

  const scene::Scene& scene_;
  const Surroundings& surroundings_;
  reference::EmbreeScene embree_;
  std::vector<glm::vec3> colours_;
  int packets_;
};

}  // namespace

std::vector<glm::vec3> sky_light(const scene::Scene& scene, const SeenMaterials& seen,
                                 const Surroundings& surroundings, int rays,
                                 const reference::RunOptions& run) {
  const Gatherer gatherer(scene, surroundings, std::max(rays, 1));
  std::vector<glm::vec3> light(seen.points.size(), glm::vec3(0.0F));
  reference::for_each_row(seen.height, run, [&](int row) {
    const std::size_t begin = static_cast<std::size_t>(row) * static_cast<std::size_t>(seen.width);
    for (std::size_t pixel = begin; pixel < begin + static_cast<std::size_t>(seen.width); ++pixel) {
      if (seen.seen[pixel] != 0) light[pixel] = gatherer.gather(seen.points[pixel], pixel);
    }
  });
  return light;
}

std::vector<glm::vec3> kept_sky_light(const scene::Scene& scene, const SeenMaterials& seen,
                                      const Surroundings& surroundings, int rays,
                                      const std::filesystem::path& folder, const reference::RunOptions& run) {
  const std::string key = key_of(scene, seen, surroundings, rays);
  const platform::CacheStore store(folder.empty() ? platform::cache_directory("reference") : folder);
  if (const std::optional<std::string> entry = store.find(kKind, key)) {
    platform::ByteReader reader(*entry);
    std::vector<glm::vec3> kept = reader.values<glm::vec3>();
    if (reader.exhausted() && kept.size() == seen.points.size()) return kept;
  }
  std::vector<glm::vec3> light = sky_light(scene, seen, surroundings, rays, run);
  platform::ByteWriter writer;
  writer.values(light);
  store.store(kKind, key, writer.take());
  return light;
}

std::vector<glm::vec3> smoothed(const SeenMaterials& seen, std::vector<glm::vec3> light, int passes,
                                const reference::RunOptions& run) {
  for (int pass = 0; pass < passes; ++pass) light = one_pass(seen, light, 1 << pass, run);
  return light;
}

}  // namespace penumbra::lighting
