#include "reference/shadow_overlaps.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <stdexcept>

#include "platform/thread_group.h"
#include "reference/disc_samples.h"
#include "reference/embree_scene.h"
#include "reference/lit_receiver.h"

namespace penumbra::reference {
namespace {

constexpr std::uint32_t kRays = 32;
constexpr std::size_t kPixelsOfTask = 4096;

struct Gaps {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = 0.0;
};

// A ray to a point of the disc finds the lowest caster, and one that comes back from beyond the scene the
// highest.
Gaps gaps_over(const EmbreeScene& scene, const LitReceiver& receiver, const DiscLight& light, double beyond,
               std::uint64_t seed) {
  Gaps gaps;
  for (std::uint32_t i = 0; i < kRays; ++i) {
    const glm::dvec2 point = concentric_disc(scrambled_sobol(i, seed)) * light.tan_half;
    const glm::dvec3 direction = glm::normalize(light.to_light + point.x * light.right + point.y * light.up);
    const std::optional<float> low =
        scene.first_hit(glm::vec3(receiver.position), glm::vec3(direction), static_cast<float>(beyond));
    if (!low) continue;
    const double lowest = *low;
    const std::optional<float> from_beyond =
        scene.first_hit(glm::vec3(receiver.position + beyond * direction), glm::vec3(-direction),
                        static_cast<float>(beyond - lowest));
    gaps.lowest = std::min(gaps.lowest, lowest);
    gaps.highest = std::max(gaps.highest, from_beyond ? beyond - *from_beyond : lowest);
  }
  return gaps;
}

}  // namespace

std::vector<std::uint8_t> shadow_overlaps(const scene::Scene& scene, const scene::Receivers& receivers,
                                          const parameters::Light& light, const VisibilityImage& visibility,
                                          int jobs) {
  const std::size_t pixels = visibility.visibility.size();
  if (receivers.position_relative.size() != pixels || visibility.valid.size() != pixels)
    throw std::invalid_argument("receivers and visibility of different pictures");
  const EmbreeScene embree(scene);
  const DiscLight disc = disc_light(light);
  const parameters::Bounds bounds = scene.bounds();
  const double beyond = 2.0 * glm::length(bounds.maximum - bounds.minimum) + 1.0;
  std::vector<std::uint8_t> overlaps(pixels, 0);
  platform::run_all((pixels + kPixelsOfTask - 1) / kPixelsOfTask, jobs, [&](std::size_t task) {
    const std::size_t end = std::min((task + 1) * kPixelsOfTask, pixels);
    for (std::size_t pixel = task * kPixelsOfTask; pixel < end; ++pixel) {
      if (visibility.valid[pixel] == 0 || visibility.visibility[pixel] >= 1.0F) continue;
      const std::optional<LitReceiver> receiver = lit_receiver(receivers, pixel, disc);
      if (!receiver) continue;
      const Gaps gaps = gaps_over(embree, *receiver, disc, beyond, pixel);
      overlaps[pixel] = gaps.highest >= kOverlapRatio * gaps.lowest ? 1 : 0;
    }
  });
  return overlaps;
}

}  // namespace penumbra::reference
