#include <array>

#include "input/input_error.h"
#include "input/nearest_name.h"
#include "scene/built_in_scenes.h"

namespace penumbra::scene {
namespace {

struct Entry {
  const char* name;
  const char* description;
  Scene (*build)();
};

// The first are a sample of what games draw; the others are measured only when they are named.
constexpr std::size_t kSampleOfScenes = 7;
constexpr std::array entries{
    Entry{"contact-boxes", "boxes that touch, lean on and hover over the ground, for contact shadows",
          contact_boxes},
    Entry{"poles-and-fence", "thin poles, wires of 1 to 3 cm and chain-link under a low sun",
          poles_and_fence},
    Entry{"trees", "six trees and eight bushes with 67,000 leaves of 5 to 11 cm", trees},
    Entry{"slabs", "low slabs under high slabs: two and three blockers above one receiver", slabs},
    Entry{"colonnade", "24 columns on steps with a wall behind them, for wide umbrae", colonnade},
    Entry{"street", "a street of 45 m with houses, balconies, lamps, cables, cars and trees", street},
    Entry{"garden",
          "a walled garden with textured materials: stones, leaves, a wire fence, an awning, a laid table",
          garden_scene},
    // Casters that blend.
    Entry{"wires-and-smoke",
          "a line of thin wires and puffs of smoke, which blend, over a yard with opaque things",
          wires_and_smoke},
    // Shadows of low and of high casters that lie over each other.
    Entry{"overlaps",
          "low casters in the shadow of high ones: a table and a rail under trees, poles before eaves, two "
          "fences",
          overlaps},
    // Ground beyond the shadow distance.
    Entry{"valley-5", "a valley of 10 km x 10 km under a sun 5 degrees high, with trees near the camera",
          valley_5},
    Entry{"valley-20", "the same under a sun 20 degrees high", valley_20},
    Entry{"valley-20-clouds", "the same under broken clouds 1,600 m high", valley_20_clouds},
    Entry{"valley-45", "the same under a sun 45 degrees high", valley_45},
};

const Entry& entry_of(std::string_view name) {
  for (const Entry& entry : entries)
    if (name == entry.name) return entry;
  throw InputError("", "unknown scene '" + std::string(name) + "'",
                   unknown_name_remedy(name, all_built_in_names()));
}

}  // namespace

std::vector<std::string> built_in_names() {
  std::vector<std::string> names = all_built_in_names();
  names.resize(kSampleOfScenes);
  return names;
}

std::vector<std::string> all_built_in_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.emplace_back(entry.name);
  return names;
}

std::string built_in_description(std::string_view name) {
  return entry_of(name).description;
}

Scene built_in(std::string_view name) {
  const Entry& entry = entry_of(name);
  Scene scene = entry.build();
  scene.name = entry.name;
  scene.description = entry.description;
  return scene;
}

}  // namespace penumbra::scene
