// Cross-compiles SPIR-V to the languages of other APIs, with SPIRV-Cross.
//
// GLSL and ESSL get combined image samplers, named <texture>_<sampler> or <texture> for plain loads, and
// bindings counted from 0 per kind, as in GL; so are HLSL's registers. MSL is emitted for macOS; matrix order
// and clip space are those of the module.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "hlsl/diagnostic.h"

namespace penumbra::shaders {

enum class Target { essl300, essl310, glsl410, glsl450, msl20, msl22, msl23, hlsl50, hlsl51 };

constexpr Target all_targets[] = {Target::essl300, Target::essl310, Target::glsl410,
                                  Target::glsl450, Target::msl20,   Target::msl22,
                                  Target::msl23,   Target::hlsl50,  Target::hlsl51};

enum class TargetLanguage { essl, glsl, msl, hlsl };

const char* target_name(Target target);  // "essl310", ...
TargetLanguage target_language(Target target);
bool is_gl(Target target);  // ESSL or GLSL: gl_check() takes it
std::optional<Target> find_target(std::string_view name);

struct CrossCompileResult {
  std::string text;                           // empty when a diagnostic is an error
  std::vector<hlsl::Diagnostic> diagnostics;  // their file is the target's name
};

class SpirvCrossModule;

// Compiles one module for several targets and parses it once. Not thread-safe.
class CrossCompiler {
 public:
  // The module must be legalised (CompileRequest::optimise).
  explicit CrossCompiler(std::vector<std::uint32_t> spirv);
  ~CrossCompiler();

  // Does not throw for a module that the target cannot express.
  CrossCompileResult to(Target target);

 private:
  std::string emit(Target target);

  std::vector<std::uint32_t> spirv_;
  std::unique_ptr<SpirvCrossModule> module_;  // created for the first target
};

// Compiles for a single target.
CrossCompileResult cross_compile(const std::vector<std::uint32_t>& spirv, Target target);

}  // namespace penumbra::shaders
