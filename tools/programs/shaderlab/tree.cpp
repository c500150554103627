#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

const std::string* find_tag(const std::vector<Tag>& tags, std::string_view key) {
  for (const Tag& tag : tags)
    if (tag.key.text == key) return &tag.value.text;
  return nullptr;
}

const char* language_name(Language language) {
  switch (language) {
    case Language::hlsl:
      return "HLSL";
    case Language::cg:
      return "CG";
    case Language::glsl:
      break;
  }
  return "GLSL";
}

}  // namespace penumbra::shaderlab
