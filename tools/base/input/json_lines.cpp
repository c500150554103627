#include "input/json_lines.h"

#include <nlohmann/json.hpp>

namespace penumbra {
namespace {

using Json = nlohmann::ordered_json;

std::string lines(const Json& json, std::size_t depth) {
  constexpr std::size_t kDeepest = 2;
  if (depth == kDeepest || !json.is_structured() || json.empty()) return json.dump();
  std::string text = json.is_object() ? "{" : "[";
  const char* before = "\n";
  for (const auto& [key, value] : json.items()) {
    text += before + std::string(depth + 1, ' ');
    if (json.is_object()) text += Json(key).dump() + ": ";
    text += lines(value, depth + 1);
    before = ",\n";
  }
  return text + "\n" + std::string(depth, ' ') + (json.is_object() ? "}" : "]");
}

}  // namespace

std::string json_lines(std::string_view json) {
  return lines(Json::parse(json), 0) + "\n";
}

}  // namespace penumbra
