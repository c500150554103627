#include "fxc/profile.h"

namespace penumbra::fxc {

namespace {

const char* prefix_of(hlsl::Stage stage) {
  switch (stage) {
    case hlsl::Stage::vertex:
      return "vs_";
    case hlsl::Stage::hull:
      return "hs_";
    case hlsl::Stage::domain:
      return "ds_";
    case hlsl::Stage::geometry:
      return "gs_";
    case hlsl::Stage::fragment:
      return "ps_";
    case hlsl::Stage::compute:
      break;
  }
  return "cs_";
}

}  // namespace

std::string profile_for(hlsl::Stage stage, int shader_target) {
  const bool model_5 = stage == hlsl::Stage::compute || stage == hlsl::Stage::hull ||
                       stage == hlsl::Stage::domain || shader_target >= 45;
  return std::string(prefix_of(stage)) + (model_5 ? "5_0" : "4_0");
}

}  // namespace penumbra::fxc
