#include "validation/target_check.h"

#include <cstdlib>
#include <optional>

#include "fxc/fxc.h"
#include "shaders/gl_check.h"
#include "validation/spirv_target.h"

namespace penumbra::validation {

std::string why_absent(hlsl::Stage stage, const std::string& target) {
  const std::optional<shaders::Target> known = shaders::find_target(target);
  if (!known) return {};
  const shaders::TargetLanguage language = shaders::target_language(*known);
  const bool geometry = stage == hlsl::Stage::geometry;
  const bool tessellates = stage == hlsl::Stage::hull || stage == hlsl::Stage::domain;
  if (language == shaders::TargetLanguage::msl && geometry) return "Metal has no geometry stage";
  if (language == shaders::TargetLanguage::hlsl && (geometry || tessellates))
    return "SPIRV-Cross writes no hull, domain and geometry stages in HLSL";
  return {};
}

shaders::CrossCompileResult check_target(shaders::CrossCompiler& module, hlsl::Stage stage,
                                         const std::string& target, bool with_driver) {
  const std::optional<shaders::Target> known = shaders::find_target(target);
  if (!known || !why_absent(stage, target).empty()) return {};
  shaders::CrossCompileResult emitted = module.to(*known);
  if (!hlsl::has_errors(emitted.diagnostics)) {
    if (with_driver && shaders::is_gl(*known))
      emitted.diagnostics = shaders::gl_check({{stage, emitted.text}}, *known);
  }
  return emitted;
}

std::string checking_driver(const std::string& target) {
  if (target == fxc_target) return fxc::require_fxc().hash;
  const std::optional<shaders::Target> known = shaders::find_target(target);
  return known && shaders::is_gl(*known) ? shaders::gl_driver(*known) : std::string();
}

void open_drivers(const std::vector<std::string>& targets) {
#ifndef _WIN32
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // NOLINT(concurrency-mt-unsafe): before any thread
#endif
  for (const std::string& target : targets) checking_driver(target);
}

std::string checked_by(const std::string& target) {
  if (const std::optional<shaders::VulkanVersion> vulkan = spirv_target(target))
    return std::string("glslang, then SPIRV-Tools for Vulkan ") + shaders::vulkan_version_name(*vulkan);
  if (target == fxc_target) return fxc::name_of(fxc::require_fxc()) + ", Unity's compiler";
  const std::string driver = checking_driver(target);
  if (!driver.empty()) return "compiled and linked by OpenGL driver " + driver;
  return "emitted by SPIRV-Cross, not compiled";
}

}  // namespace penumbra::validation
