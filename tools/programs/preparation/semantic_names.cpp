#include "preparation/semantic_names.h"

#include <algorithm>

namespace penumbra::preparation {

namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

std::string without_index(const std::string& semantic) {
  const std::size_t last = semantic.find_last_not_of("0123456789");
  return last == std::string::npos ? std::string() : semantic.substr(0, last + 1);
}

}  // namespace

std::string system_value_of(const std::string& semantic, hlsl::Stage stage, bool input) {
  const std::string name = upper(without_index(semantic));
  const std::string index = semantic.substr(name.size());
  if (stage == hlsl::Stage::vertex && !input && name == "POSITION") return "SV_Position" + index;
  if (stage != hlsl::Stage::fragment) return {};
  if (input) return name == "VPOS" ? "SV_Position" + index : std::string();
  return name == "COLOR" ? "SV_Target" + index : name == "DEPTH" ? "SV_Depth" + index : std::string();
}

// glslang gives up on clip and cull distances of these stages.
std::string distance_problem(const std::string& semantic, hlsl::Stage stage, bool input) {
  const std::string name = without_index(semantic);
  if (upper(name) != "SV_CLIPDISTANCE" && upper(name) != "SV_CULLDISTANCE") return {};
  if (stage == hlsl::Stage::geometry && input)
    return "cannot be read in a geometry program here: pass the distance in a TEXCOORD, and write " + name +
           " in the geometry program";
  if (stage == hlsl::Stage::hull || stage == hlsl::Stage::domain)
    return std::string("is not supported in a ") + hlsl::stage_name(stage) + " program";
  return {};
}

}  // namespace penumbra::preparation
