// The known names in #pragma lines, for spell checking. Internal to this folder.
//
// Sources: Unity Manual, "pragma directives in HLSL" (SL-PragmaDirectives), "Targeting shader models and GPU
// features" (SL-ShaderCompileTargets), "Targeting graphics APIs and platforms" (SL-ShaderCompilationAPIs),
// "GPU instancing" (instancing_options); Microsoft's HLSL reference for pragmas of the language itself.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "variants/keyword_set.h"

namespace penumbra::variants {

// A name such as multi_compile_local_fragment, parsed; suffixes may be in any order, each at most once.
struct KeywordPragmaName {
  enum class Base { multi_compile, shader_feature, dynamic_branch };
  Base base = Base::multi_compile;
  bool local = false;
  StageSet stages = StageSet::all();
};
std::optional<KeywordPragmaName> keyword_pragma_name(std::string_view name);

// Returns whether it is a known pragma that has no effect here.
bool is_option_pragma(std::string_view name);

const std::vector<std::string>& pragma_names();  // every known name, for "did you mean"
const std::vector<std::string>& renderer_names();
const std::vector<std::string>& feature_names();  // names for #pragma require
const std::vector<std::string>& instancing_option_names();

// Returns the value of SHADER_TARGET for "4.5", "es3.1", or nothing.
std::optional<int> shader_model(std::string_view name);

}  // namespace penumbra::variants
