#include "shaderlab/tag_values.h"

#include <algorithm>
#include <vector>

#include "shaderlab/characters.h"
#include "shaderlab/cursor.h"

namespace penumbra::shaderlab {

namespace {

struct KnownTag {
  const char* key;
  std::vector<std::string> values;
  bool others_allowed = false;  // user-defined names: only likely typing errors are reported
};

const std::vector<KnownTag>& known_tags() {
  static const std::vector<std::string> truth{"True", "False"};
  static const std::vector<KnownTag> tags{
      {"Queue", {"Background", "Geometry", "AlphaTest", "Transparent", "Overlay"}},
      // The last two belong to older versions, and to Unity's own pages about them.
      {"RenderPipeline",
       {"UniversalPipeline", "HDRenderPipeline", "UniversalRenderPipeline", "LightweightPipeline"},
       true},
      {"DisableBatching", {"True", "False", "LODFading"}},
      {"ForceNoShadowCasting", truth},
      {"IgnoreProjector", truth},
      {"CanUseSpriteAtlas", truth},
      {"PreviewType", {"Sphere", "Plane", "Skybox", "Cube"}, true}};
  return tags;
}

// Returns "Transparent" for "Transparent+10".
std::string_view without_offset(std::string_view queue) {
  return trimmed(queue.substr(0, queue.find_first_of("+-")));
}

}  // namespace

std::string tag_problem(const Tag& tag) {
  for (const KnownTag& known : known_tags()) {
    if (!same_keyword(known.key, tag.key.text)) continue;
    const bool is_queue = known.key == std::string_view("Queue");
    const std::string_view value =
        is_queue ? without_offset(tag.value.text) : std::string_view(tag.value.text);
    if (value.empty() || is_digit(value.front())) return {};
    if (std::any_of(known.values.begin(), known.values.end(),
                    [&](const std::string& name) { return same_keyword(name, value); }))
      return {};
    const std::string hint = near_name_hint(value, known.values);
    if (hint.empty() && known.others_allowed) return {};
    return "'" + std::string(value.substr(0, 40)) + "' is not a known value of the tag " + known.key +
           (hint.empty() ? "" : ": " + hint);
  }
  return {};
}

}  // namespace penumbra::shaderlab
