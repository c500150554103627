#include "shaders/cross_compile.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <utility>

#include "shaders/spirv_cross_session.h"
#include "shaders/target_corrections.h"
#include "shaders/word_blocks.h"

namespace penumbra::shaders {

namespace {

struct TargetTraits {
  Target target;
  const char* name;
  TargetLanguage language;
  unsigned version;  // version in SPIRV-Cross's format
};

constexpr std::array<TargetTraits, std::size(all_targets)> all_traits{
    {{Target::essl300, "essl300", TargetLanguage::essl, 300},
     {Target::essl310, "essl310", TargetLanguage::essl, 310},
     {Target::glsl410, "glsl410", TargetLanguage::glsl, 410},
     {Target::glsl450, "glsl450", TargetLanguage::glsl, 450},
     {Target::msl20, "msl20", TargetLanguage::msl, SPVC_MAKE_MSL_VERSION(2, 0, 0)},
     {Target::msl22, "msl22", TargetLanguage::msl, SPVC_MAKE_MSL_VERSION(2, 2, 0)},
     {Target::msl23, "msl23", TargetLanguage::msl, SPVC_MAKE_MSL_VERSION(2, 3, 0)},
     {Target::hlsl50, "hlsl50", TargetLanguage::hlsl, 50},
     {Target::hlsl51, "hlsl51", TargetLanguage::hlsl, 51}}};

const TargetTraits& traits(Target target) {
  return *std::find_if(all_traits.begin(), all_traits.end(),
                       [target](const TargetTraits& one) { return one.target == target; });
}

spvc_backend backend(Target target) {
  switch (target_language(target)) {
    case TargetLanguage::msl:
      return SPVC_BACKEND_MSL;
    case TargetLanguage::hlsl:
      return SPVC_BACKEND_HLSL;
    case TargetLanguage::essl:
    case TargetLanguage::glsl:
      break;
  }
  return SPVC_BACKEND_GLSL;
}

void set_options(const SpirvCrossSession& session, Target target) {
  spvc_compiler_options options = nullptr;
  session.require(spvc_compiler_create_compiler_options(session.compiler(), &options));
  const auto set = [&](spvc_compiler_option option, unsigned value) {
    session.require(spvc_compiler_options_set_uint(options, option, value));
  };
  if (is_gl(target)) {
    const bool es = target_language(target) == TargetLanguage::essl;
    set(SPVC_COMPILER_OPTION_GLSL_VERSION, traits(target).version);
    set(SPVC_COMPILER_OPTION_GLSL_ES, es ? 1 : 0);
    set(SPVC_COMPILER_OPTION_GLSL_VULKAN_SEMANTICS, 0);
    set(SPVC_COMPILER_OPTION_GLSL_ES_DEFAULT_FLOAT_PRECISION_HIGHP, 1);
    set(SPVC_COMPILER_OPTION_GLSL_ES_DEFAULT_INT_PRECISION_HIGHP, 1);
  } else if (target_language(target) == TargetLanguage::msl) {
    set(SPVC_COMPILER_OPTION_MSL_VERSION, traits(target).version);
    set(SPVC_COMPILER_OPTION_MSL_FRAMEBUFFER_FETCH_SUBPASS, 1);  // [[color(n)]], as Unity has it on Metal
  } else {
    set(SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, traits(target).version);
  }
  session.require(spvc_compiler_install_compiler_options(session.compiler(), options));
}

// GL has no separate textures: every texture-sampler pair that is used becomes one combined sampler.
void combine_samplers(const SpirvCrossSession& session) {
  const spvc_compiler compiler = session.compiler();
  spvc_variable_id dummy = 0;  // dummy for the sampler that a plain load does not have
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

// Gives consecutive numbers from 0 to resources of several kinds.
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

// GL and Direct3D number each kind of resource separately, with limits.
void number_bindings(const SpirvCrossSession& session, Target target) {
  number_from_zero(session, {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER});
  if (target_language(target) == TargetLanguage::hlsl) {
    number_from_zero(session, {SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS});
    // A buffer is a t or a u register, depending on its use: both are numbered together, and the scarce u
    // come first.
    number_from_zero(session, {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, SPVC_RESOURCE_TYPE_STORAGE_IMAGE,
                               SPVC_RESOURCE_TYPE_SEPARATE_IMAGE});
  } else {
    number_from_zero(session, {SPVC_RESOURCE_TYPE_STORAGE_BUFFER});
    number_from_zero(session, {SPVC_RESOURCE_TYPE_STORAGE_IMAGE});
  }
}

// gl_ClipDistance and gl_CullDistance are in ESSL by an extension, which SPIRV-Cross does not request.
void request_distances(const SpirvCrossSession& session) {
  spvc_compiler compiler = session.compiler();
  spvc_compiler_update_active_builtins(compiler);
  for (const SpvStorageClass storage : {SpvStorageClassInput, SpvStorageClassOutput})
    for (const SpvBuiltIn distance : {SpvBuiltInClipDistance, SpvBuiltInCullDistance})
      if (spvc_compiler_has_active_builtin(compiler, distance, storage) != SPVC_FALSE)
        session.require(spvc_compiler_require_extension(compiler, "GL_EXT_clip_cull_distance"));
}

std::string emit_module(const SpirvCrossModule& module, Target target) {
  const SpirvCrossSession session(module, backend(target));
  set_options(session, target);
  const VertexLayer layer(session, target);
  if (is_gl(target)) combine_samplers(session);
  if (target_language(target) == TargetLanguage::essl) request_distances(session);
  if (target_language(target) != TargetLanguage::msl)
    number_bindings(session, target);  // SPIRV-Cross numbers MSL's resources itself
  const char* text = nullptr;
  session.require(spvc_compiler_compile(session.compiler(), &text));
  return layer.completed(text);
}

// Amends a module for which SPIRV-Cross's own output would be wrong or missing.
std::string emit_amended(const SpirvCrossModule& module, const SpirvModule& spirv, Target target) {
  if (target_language(target) == TargetLanguage::hlsl)
    if (const std::optional<SpirvModule> gathers = with_marked_gathers(spirv))
      return with_named_gathers(emit_module(SpirvCrossModule(*gathers), target));
  std::string text = emit_module(module, target);
  if (target_language(target) != TargetLanguage::essl || !reads_lost_copy(text)) return text;
  return emit_module(SpirvCrossModule(without_relaxed_precision(spirv)), target);
}

}  // namespace

const char* target_name(Target target) {
  return traits(target).name;
}

TargetLanguage target_language(Target target) {
  return traits(target).language;
}

bool is_gl(Target target) {
  return target_language(target) == TargetLanguage::essl || target_language(target) == TargetLanguage::glsl;
}

std::optional<Target> find_target(std::string_view name) {
  const auto* found = std::find_if(std::begin(all_targets), std::end(all_targets),
                                   [&](Target target) { return name == target_name(target); });
  return found == std::end(all_targets) ? std::nullopt : std::optional<Target>(*found);
}

CrossCompiler::CrossCompiler(std::vector<std::uint32_t> spirv) : spirv_(std::move(spirv)) {}
CrossCompiler::~CrossCompiler() = default;

CrossCompileResult CrossCompiler::to(Target target) {
  try {
    return {emit(target), {}};
  } catch (const std::invalid_argument& problem) {
    return {{}, {{target_name(target), 0, 0, hlsl::Severity::error, problem.what(), {}}}};
  }
}

std::string CrossCompiler::emit(Target target) {
  if (target == Target::glsl450)
    if (const std::optional<SpirvModule> words = with_word_blocks(spirv_, BlocksAsWords::overlapping_in_gl))
      return emit_amended(SpirvCrossModule(*words), *words, target);
  if (!module_) module_ = std::make_unique<SpirvCrossModule>(spirv_);
  try {
    return emit_amended(*module_, spirv_, target);
  } catch (const std::invalid_argument&) {
    const std::optional<SpirvModule> words = with_word_blocks(spirv_, BlocksAsWords::not_for_gl);
    if (!words) throw;
    return emit_amended(SpirvCrossModule(*words), *words, target);
  }
}

CrossCompileResult cross_compile(const std::vector<std::uint32_t>& spirv, Target target) {
  return CrossCompiler(spirv).to(target);
}

}  // namespace penumbra::shaders
