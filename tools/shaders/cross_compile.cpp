#include "shaders/cross_compile.h"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>

#include "shaders/spirv_cross_session.h"

namespace penumbra::shaders {

namespace {

struct TargetTraits {
  const char* name;
  spvc_backend backend;
};

TargetTraits traits(Target target) {
  switch (target) {
    case Target::essl310:
      return {"essl310", SPVC_BACKEND_GLSL};
    case Target::glsl450:
      return {"glsl450", SPVC_BACKEND_GLSL};
    case Target::msl23:
      return {"msl23", SPVC_BACKEND_MSL};
    case Target::hlsl50:
      break;
  }
  return {"hlsl50", SPVC_BACKEND_HLSL};
}

void set_options(const SpirvCrossSession& session, Target target) {
  spvc_compiler_options options = nullptr;
  session.require(spvc_compiler_create_compiler_options(session.compiler(), &options));
  const auto set = [&](spvc_compiler_option option, unsigned value) {
    session.require(spvc_compiler_options_set_uint(options, option, value));
  };
  if (traits(target).backend == SPVC_BACKEND_GLSL) {
    const bool es = target == Target::essl310;
    set(SPVC_COMPILER_OPTION_GLSL_VERSION, es ? 310 : 450);
    set(SPVC_COMPILER_OPTION_GLSL_ES, es ? 1 : 0);
    set(SPVC_COMPILER_OPTION_GLSL_VULKAN_SEMANTICS, 0);
    set(SPVC_COMPILER_OPTION_GLSL_ES_DEFAULT_FLOAT_PRECISION_HIGHP, 1);
    set(SPVC_COMPILER_OPTION_GLSL_ES_DEFAULT_INT_PRECISION_HIGHP, 1);
  } else if (target == Target::msl23) {
    set(SPVC_COMPILER_OPTION_MSL_VERSION, SPVC_MAKE_MSL_VERSION(2, 3, 0));
  } else {
    set(SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, 50);
  }
  session.require(spvc_compiler_install_compiler_options(session.compiler(), options));
}

// GL knows no separate textures: every pair that is used becomes one sampler.
void combine_samplers(const SpirvCrossSession& session) {
  const spvc_compiler compiler = session.compiler();
  spvc_variable_id dummy = 0;  // stands in for the sampler a plain load does not have
  session.require(spvc_compiler_build_dummy_sampler_for_combined_images(compiler, &dummy));
  session.require(spvc_compiler_build_combined_image_samplers(compiler));
  const spvc_combined_image_sampler* pairs = nullptr;
  std::size_t count = 0;
  session.require(spvc_compiler_get_combined_image_samplers(compiler, &pairs, &count));
  for (std::size_t i = 0; i < count; ++i) {
    std::string name = spvc_compiler_get_name(compiler, pairs[i].image_id);
    if (pairs[i].sampler_id != dummy)
      name += std::string("_") + spvc_compiler_get_name(compiler, pairs[i].sampler_id);
    spvc_compiler_set_name(compiler, pairs[i].combined_id, name.c_str());
    spvc_compiler_set_decoration(compiler, pairs[i].combined_id, SpvDecorationBinding,
                                 static_cast<unsigned>(i));
  }
}

// One run of numbers from 0 over resources of several kinds.
void number_from_zero(const SpirvCrossSession& session, std::initializer_list<spvc_resource_type> types) {
  spvc_resources resources = nullptr;
  session.require(spvc_compiler_create_shader_resources(session.compiler(), &resources));
  unsigned next = 0;
  for (const spvc_resource_type type : types) {
    const spvc_reflected_resource* list = nullptr;
    std::size_t count = 0;
    session.require(spvc_resources_get_resource_list_for_type(resources, type, &list, &count));
    for (std::size_t i = 0; i < count; ++i)
      spvc_compiler_set_decoration(session.compiler(), list[i].id, SpvDecorationBinding, next++);
  }
}

// GL and Direct3D count each kind of resource for itself, and only so far.
void number_bindings(const SpirvCrossSession& session, Target target) {
  number_from_zero(session, {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER});
  if (target == Target::hlsl50) {
    number_from_zero(session, {SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS});
    // A buffer is a t or a u register, as its use has it: one run serves both, with the scarce u first.
    number_from_zero(session, {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, SPVC_RESOURCE_TYPE_STORAGE_IMAGE,
                               SPVC_RESOURCE_TYPE_SEPARATE_IMAGE});
  } else {
    number_from_zero(session, {SPVC_RESOURCE_TYPE_STORAGE_BUFFER});
    number_from_zero(session, {SPVC_RESOURCE_TYPE_STORAGE_IMAGE});
  }
}

std::string emit(const std::vector<std::uint32_t>& spirv, Target target) {
  const SpirvCrossSession session(spirv, traits(target).backend);
  set_options(session, target);
  if (traits(target).backend == SPVC_BACKEND_GLSL) combine_samplers(session);
  if (target != Target::msl23) number_bindings(session, target);  // MSL numbers by itself
  const char* text = nullptr;
  session.require(spvc_compiler_compile(session.compiler(), &text));
  return text;
}

}  // namespace

const char* target_name(Target target) {
  return traits(target).name;
}

std::optional<Target> find_target(std::string_view name) {
  const auto* found = std::find_if(std::begin(all_targets), std::end(all_targets),
                                   [&](Target target) { return name == target_name(target); });
  return found == std::end(all_targets) ? std::nullopt : std::optional<Target>(*found);
}

CrossCompileResult cross_compile(const std::vector<std::uint32_t>& spirv, Target target) {
  try {
    return {emit(spirv, target), {}};
  } catch (const std::invalid_argument& problem) {
    return {{}, {{target_name(target), 0, 0, hlsl::Severity::error, problem.what(), {}}}};
  }
}

}  // namespace penumbra::shaders
