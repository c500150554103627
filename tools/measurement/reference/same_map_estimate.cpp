#include "reference/same_map_estimate.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input/input_error.h"
#include "platform/hashed_fields.h"
#include "reference/disc_coverage.h"
#include "reference/lit_receiver.h"
#include "reference/tile_search.h"

namespace penumbra::reference {
namespace {

constexpr int same_map_version = 1;  // increased whenever a change affects any result

void check(const MapView& view) {
  const scene::ShadowAtlas& atlas = view.atlas;
  if (atlas.width <= 0 || atlas.height <= 0 ||
      atlas.depth.size() != static_cast<std::size_t>(atlas.width) * static_cast<std::size_t>(atlas.height)) {
    throw InputError("", "the shadow atlas does not hold width x height texels");
  }
  if (view.cascades.cascades.empty()) {
    throw InputError("", "there is no cascade",
                     "the same-map estimate is of the sun's maps; a spot light's has none yet");
  }
}

std::string key_of(const MapView& view) {
  return platform::hash_of(std::string_view("T2"), same_map_version, view.atlas, view.cascades,
                           view.receivers, view.origin);
}

class SameMap {
 public:
  SameMap(const MapView& view, const DiscLight& light) : view_(view), light_(light) {
    for (std::size_t cascade = 0; cascade < view.cascades.cascades.size(); ++cascade) {
      tiles_.emplace_back(view.atlas, view.cascades, cascade);
    }
  }

  HalfCounts lit_points(std::size_t pixel) const {
    constexpr auto half = static_cast<std::uint16_t>(DiscPoints::count / 2);
    LitReceiver receiver = lit_receiver(view_.receivers, pixel, light_).value();
    const glm::dvec3 surface = view_.origin + glm::dvec3(view_.receivers.position_relative[pixel]);
    const int cascade = select_cascade(view_.cascades, surface);
    if (cascade < 0) return {half, half};
    const TileSearch& tile = tiles_[static_cast<std::size_t>(cascade)];
    receiver.position += view_.origin;
    if (light_.tan_half > 0.0) {
      return DiscPoints::uncovered(tile.covered(receiver, light_.tan_half, points_));
    }
    return tile.blocked(receiver) ? HalfCounts{0, 0} : HalfCounts{half, half};
  }

 private:
  const MapView& view_;
  DiscLight light_;
  std::vector<TileSearch> tiles_;
  DiscPoints points_;
};

}  // namespace

int select_cascade(const parameters::CascadeSet& cascades, const glm::dvec3& position_ws) {
  if (cascades.cascades.size() == 1) return 0;
  for (std::size_t index = 0; index < cascades.cascades.size(); ++index) {
    const glm::dvec4& sphere = cascades.cascades[index].split_sphere;
    const glm::dvec3 from_centre = position_ws - glm::dvec3(sphere);
    if (glm::dot(from_centre, from_centre) < sphere.w * sphere.w) return static_cast<int>(index);
  }
  return -1;
}

VisibilityImage same_map_estimate(const MapView& view, const RunOptions& run, const ReferenceCache* cache) {
  check(view);
  const DiscLight light = disc_light({view.cascades.light_direction, view.cascades.angular_diameter_degrees});
  RowJob job;
  job.size = {view.receivers.width, view.receivers.height};
  job.valid = valid_receivers(view.receivers, light);
  job.samples = DiscPoints::count;
  job.rays_per_pixel = light.tan_half > 0.0 ? DiscPoints::count : 1;
  job.key = key_of(view);
  if (std::optional<VisibilityImage> kept = kept_image(job, cache)) return *std::move(kept);
  const SameMap map(view, light);
  job.count = [&](std::size_t pixel) { return map.lit_points(pixel); };
  return run_rows(job, run, cache);
}

}  // namespace penumbra::reference
