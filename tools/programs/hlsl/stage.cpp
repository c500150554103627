#include "hlsl/stage.h"

namespace penumbra::hlsl {

const char* stage_name(Stage stage) {
  switch (stage) {
    case Stage::vertex:
      return "vertex";
    case Stage::hull:
      return "hull";
    case Stage::domain:
      return "domain";
    case Stage::geometry:
      return "geometry";
    case Stage::fragment:
      return "fragment";
    case Stage::compute:
      break;
  }
  return "compute";
}

std::optional<Stage> find_stage(std::string_view name) {
  for (const Stage stage : all_stages)
    if (name == stage_name(stage)) return stage;
  return std::nullopt;
}

}  // namespace penumbra::hlsl
