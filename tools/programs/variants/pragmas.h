// The #pragma lines of a shader program: entry points, keywords, targets and the rest of what Unity's
// importer reads before anything is compiled.
//
// The lines that count are those that count in Unity (Unity Manual, "pragma directives in HLSL",
// SL-PragmaDirectives, and "include and include_with_pragmas directives"):
// - the program's own text, with the blocks that the .shader file puts before it, and files that it includes
//   by #include_with_pragmas, directly or indirectly. Files included by a plain #include do not count:
//   neither their pragmas nor, here, their #defines;
// - under #if, the lines that are active with `defines` and with the #defines of the text read so far. Unity
//   evaluates these conditions once, before there are variants: with the program's own #defines,
//   UNITY_VERSION and the platform's constants (the Manual names SHADER_API_MOBILE, SHADER_API_DESKTOP,
//   UNITY_NO_RGBM, UNITY_USE_NATIVE_HDR, UNITY_FRAMEBUFFER_FETCH_AVAILABLE, UNITY_NO_CUBEMAP_ARRAY). A
//   keyword is never defined there, and a pragma under a condition that depends on one gets a warning. Every
//   other unknown identifier is 0, as in C.
//
// Guarantees: linear in the size of the texts read; accepts any text. Files that include themselves end in a
// message; at most 4,096 files and 64 MiB of text are read in total. At most 200 messages.
#pragma once

#include <functional>
#include <map>
#include <utility>

#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"
#include "variants/keyword_set.h"

namespace penumbra::variants {

struct IncludedText {
  std::string name;  // the file's name in diagnostics; two includes of one file have one name
  std::string text;
};
using FindIncluded =
    std::function<std::optional<IncludedText>(const std::string& name, const std::string& including_file)>;

struct ProgramText {
  std::string file;
  std::string text;                            // LF line ends; lines and columns are the file's own
  std::map<std::string, std::string> defines;  // see platform_defines.h
  FindIncluded find_included;                  // if empty, nothing is found
};

struct EntryPoint {
  hlsl::Stage stage = hlsl::Stage::vertex;
  std::string function;
  Place place;
};

// The pragma is #pragma kernel NAME MACRO=VALUE ...
struct Kernel {
  std::string function;
  std::vector<std::pair<std::string, std::string>> defines;  // MACRO alone has the value "1"
  Place place;
};

// The pragma is #pragma surface FUNCTION MODEL OPTION...: the editor writes the program from it, so it cannot
// be compiled without the editor; a warning says so.
struct SurfaceFunction {
  std::string function;
  std::string lighting_model;
  Keywords options;
  Place place;
};

// The pragma is #pragma target MODEL KEYWORD...: 4.5 is 45, the value of SHADER_TARGET. Without keywords it
// is for every variant, with keywords for those where one of them is on.
struct ShaderTarget {
  int model = 0;
  Keywords keywords;
  Place place;
};

// The pragma is #pragma require FEATURE... : KEYWORD...
struct Requirement {
  std::vector<std::string> features;
  Keywords keywords;
  Place place;
};

// A known pragma that has no effect here, or whose argument list the caller reads.
struct PragmaOption {
  std::string name;
  std::vector<std::string> arguments;
  Place place;
};

struct Pragmas {
  std::vector<EntryPoint> entry_points;  // at most one per stage: the last one
  std::vector<Kernel> kernels;
  std::optional<SurfaceFunction> surface;
  std::vector<KeywordSet> keyword_sets;  // sets in source order; shortcuts as their sets
  std::vector<DynamicKeyword> dynamic_keywords;
  std::vector<Clause> clauses;  // clauses of skip_variants, and the shortcuts' constraints on their keywords
  std::vector<ShaderTarget> targets;
  std::vector<Requirement> requirements;
  std::vector<std::string> only_renderers;  // if empty, all
  std::vector<std::string> excluded_renderers;
  std::vector<std::string> tier_renderers;  // renderers of hardware_tier_variants
  std::string procedural_function;          // name in instancing_options procedural:NAME
  std::vector<PragmaOption> options;
  std::vector<std::string> files;  // files in the order in which they were read, the program's own first
  std::vector<hlsl::Diagnostic> diagnostics;
};

Pragmas read_pragmas(const ProgramText& program);

// Returns whether the program is meant for a graphics API, by its name in only_renderers: "vulkan", "d3d11",
// "gles3".
bool compiles_for(const Pragmas& pragmas, const std::string& renderer);

// Returns whether a #pragma use_dxc selects DXC on that graphics API.
bool compiles_with_dxc(const Pragmas& pragmas, const std::string& renderer);

// Returns SHADER_TARGET of a variant: the highest model that applies, at least 25 (the default), 40 with a
// geometry and 46 with a tessellation stage, 50 for compute shaders (Unity Manual, "Targeting shader models
// and GPU features", SL-ShaderCompileTargets).
int shader_target(const Pragmas& pragmas, const Keywords& variant);

}  // namespace penumbra::variants
