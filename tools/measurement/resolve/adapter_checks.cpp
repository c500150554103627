#include "resolve/adapter_checks.h"

#include "input/input_error.h"
#include "resolve/frame_on_device.h"
#include "shaders/discards.h"
#include "shaders/function_results.h"
#include "shaders/sampler_uses.h"
#include "shaders/spirv_module.h"
#include "shaders/texture_kinds.h"

namespace penumbra::resolve {
namespace {

using shaders::SpirvModule;

std::string text_of(const shaders::SourcePlace& place, const std::string& shader) {
  return place.line == 0 ? shader : place.file + ":" + std::to_string(place.line);
}

bool compares(const std::string& sampler) {
  // Samplers of the user's textures do not compare.
  return FrameOnDevice::sampler_compares(sampler).value_or(false);
}

// The shader may declare a sampler as another kind than the one its name stands for.
void refuse_misused_samplers(const SpirvModule& module, const std::string& shader) {
  for (const shaders::SamplerUse& use : shaders::sampler_uses(module)) {
    if (use.compares == compares(use.sampler)) continue;
    if (use.compares) {
      throw InputError(text_of(use.place, shader),
                       "compares through '" + use.sampler + "', which is not a comparison sampler",
                       "use sampler_LinearClampCompare, or read without comparing");
    }
    throw InputError(text_of(use.place, shader),
                     "reads without comparing through '" + use.sampler + "', which is a comparison sampler",
                     "use sampler_LinearClamp or SAMPLE_TEXTURE2D_SHADOW");
  }
}

// A pixel that is discarded writes no result, so what is read there is whatever the memory held.
void refuse_discard(const SpirvModule& module, const std::string& shader) {
  const std::optional<shaders::SourcePlace> place = shaders::first_discard(module);
  if (!place) return;
  throw InputError(text_of(*place, shader), "discards the pixel, so there is no visibility to measure there",
                   "return 1.0 (lit) or 0.0 (in shadow) instead of 'discard' and 'clip'");
}

// HLSL would take the first of several numbers without a message.
void refuse_several_numbers(const SpirvModule& unoptimised, const std::string& where) {
  if (!shaders::returns_several_numbers(unoptimised, "ShadowVisibility")) return;
  throw InputError(where, "ShadowVisibility returns more than one number",
                   "it returns a float, the visibility: 1 = lit, 0 = in shadow");
}

std::string place_of(const std::map<std::string, std::string>& places, const std::string& name,
                     const std::string& shader) {
  const auto found = places.find(name);
  return found == places.end() ? shader : found->second;
}

void refuse_other_textures(const SpirvModule& module, const std::map<std::string, std::string>& places,
                           const std::string& shader) {
  for (const std::string& texture : shaders::textures_that_are_not_2d(module)) {
    throw InputError(place_of(places, texture, shader), "'" + texture + "' is not a plain 2D texture",
                     "only 2D textures are provided: TEXTURE2D");
  }
}

}  // namespace

void check_adapter(std::vector<std::uint32_t> unoptimised, const std::string& shader,
                   const std::map<std::string, std::string>& places) {
  refuse_several_numbers(unoptimised, place_of(places, "ShadowVisibility", shader));
  SpirvModule module = std::move(unoptimised);
  std::vector<std::string> problems;
  // The checks apply to the module that ships.
  if (!shaders::optimise(module, shaders::VulkanVersion::v1_1, problems)) return;
  refuse_misused_samplers(module, shader);
  refuse_discard(module, shader);
  refuse_other_textures(module, places, shader);
}

}  // namespace penumbra::resolve
