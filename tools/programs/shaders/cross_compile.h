// SPIR-V to the texts other APIs take, by SPIRV-Cross.
//
// GLSL and ESSL get combined image samplers, named <texture>_<sampler> or <texture> for plain loads, and
// bindings counted from 0 per kind, as GL has them; so are HLSL's registers. MSL is emitted for macOS; row
// and column order and the clip space are those of the module.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

// A module that goes to several targets: it is read once. Not for several threads at once.
class CrossCompiler {
 public:
  // The module must be legalised (CompileRequest::optimise).
  explicit CrossCompiler(std::vector<std::uint32_t> spirv);
  ~CrossCompiler();

  // Never throws for a module that the target cannot express.
  CrossCompileResult to(Target target);

 private:
  std::string emit(Target target);

  std::vector<std::uint32_t> spirv_;
  std::unique_ptr<SpirvCrossModule> module_;  // once the first target has asked
};

// For a single target.
CrossCompileResult cross_compile(const std::vector<std::uint32_t>& spirv, Target target);

}  // namespace penumbra::shaders
