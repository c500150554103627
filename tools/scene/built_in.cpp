#include <array>

#include "input/input_error.h"
#include "input/nearest_name.h"
#include "scene/built_in_scenes.h"

namespace penumbra::scene {
namespace {

struct Entry {
  const char* name;
  Scene (*build)();
};

constexpr std::array entries{
    Entry{"contact-boxes", contact_boxes},
    Entry{"poles-and-fence", poles_and_fence},
    Entry{"trees", trees},
    Entry{"slabs", slabs},
    Entry{"colonnade", colonnade},
    Entry{"street", street},
    Entry{"garden", garden_scene},
};

}  // namespace

std::vector<std::string> built_in_names() {
  std::vector<std::string> names;
  names.reserve(entries.size());
  for (const Entry& entry : entries) names.emplace_back(entry.name);
  return names;
}

Scene built_in(std::string_view name) {
  for (const Entry& entry : entries) {
    if (name == entry.name) {
      Scene scene = entry.build();
      scene.name = entry.name;
      return scene;
    }
  }
  throw InputError("", "unknown scene '" + std::string(name) + "'",
                   unknown_name_way_out(name, built_in_names()));
}

}  // namespace penumbra::scene
