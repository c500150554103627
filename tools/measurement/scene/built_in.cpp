#include <array>
#include <span>

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
};

// These scenes have a spot light.
constexpr std::array spot_entries{
    Entry{"spot-table",
          "a room under one lamp: a table, chairs, wires of 6 to 22 mm, slats half way to the lamp",
          spot_table},
};

// These scenes have casters that blend.
constexpr std::array blended_entries{
    Entry{"wires-and-smoke",
          "a line of thin wires and puffs of smoke, which blend, over a yard with opaque things",
          wires_and_smoke},
};

// In these scenes shadows of low and of high casters lie over each other.
constexpr std::array overlap_entries{
    Entry{"overlaps",
          "low casters in the shadow of high ones: a table and a rail under trees, poles before eaves, two "
          "fences",
          overlaps},
};

// These scenes have ground beyond the shadow distance.
constexpr std::array landscape_entries{
    Entry{"valley-5", "a valley of 10 km x 10 km under a sun 5 degrees high, with trees near the camera",
          valley_5},
    Entry{"valley-20", "the same under a sun 20 degrees high", valley_20},
    Entry{"valley-20-clouds", "the same under broken clouds 1,600 m high", valley_20_clouds},
    Entry{"valley-45", "the same under a sun 45 degrees high", valley_45},
};

// All of them, in the order in which they are listed.
constexpr std::array<std::span<const Entry>, 5> all_entries{entries, spot_entries, blended_entries,
                                                            overlap_entries, landscape_entries};

std::vector<std::string> names_of(std::span<const Entry> all) {
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Entry& entry : all) names.emplace_back(entry.name);
  return names;
}

const Entry& entry_of(std::string_view name) {
  for (const std::span<const Entry> some : all_entries)
    for (const Entry& entry : some)
      if (name == entry.name) return entry;
  throw InputError("", "unknown scene '" + std::string(name) + "'",
                   unknown_name_remedy(name, all_built_in_names()));
}

}  // namespace

std::vector<std::string> built_in_names() {
  return names_of(entries);
}

std::vector<std::string> spot_scene_names() {
  return names_of(spot_entries);
}

std::vector<std::string> blended_scene_names() {
  return names_of(blended_entries);
}

std::vector<std::string> overlap_scene_names() {
  return names_of(overlap_entries);
}

std::vector<std::string> landscape_scene_names() {
  return names_of(landscape_entries);
}

std::vector<std::string> all_built_in_names() {
  std::vector<std::string> names;
  for (const std::span<const Entry> some : all_entries)
    for (const Entry& entry : some) names.emplace_back(entry.name);
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
