#include "variants/pragma_names.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "variants/built_in_sets.h"

namespace penumbra::variants {
namespace {

constexpr std::pair<std::string_view, KeywordPragmaName::Base> bases[] = {
    {"multi_compile", KeywordPragmaName::Base::multi_compile},
    {"shader_feature", KeywordPragmaName::Base::shader_feature},
    {"dynamic_branch", KeywordPragmaName::Base::dynamic_branch}};

constexpr std::string_view stage_suffixes[] = {"vertex", "fragment", "hull",
                                               "domain", "geometry", "raytracing"};

const std::vector<std::string>& read_pragmas() {
  static const std::vector<std::string> names{"vertex",
                                              "fragment",
                                              "geometry",
                                              "hull",
                                              "domain",
                                              "surface",
                                              "kernel",
                                              "target",
                                              "require",
                                              "only_renderers",
                                              "exclude_renderers",
                                              "skip_variants",
                                              "hardware_tier_variants",
                                              "instancing_options"};
  return names;
}

const std::vector<std::string>& option_pragmas() {
  static const std::vector<std::string> names{"editor_sync_compilation",
                                              "enable_d3d11_debug_symbols",
                                              "enable_debug_symbols",
                                              "enable_vulkan_debug_symbols",
                                              "enable_ray_tracing_shader_debug_symbols",
                                              "skip_optimizations",
                                              "hlslcc_bytecode_disassembly",
                                              "disable_fastmath",
                                              "enable_cbuffer",
                                              "prefer_hlslcc",
                                              "use_dxc",
                                              "never_use_dxc",
                                              "require_dxc",
                                              "glsl",
                                              "glsl_es2",
                                              "glsl_no_auto_normalization",
                                              "fragmentoption",
                                              "profileoption",
                                              "force_concat_matrix",
                                              "raytracing",
                                              "max_recursion_depth",
                                              "once",
                                              "warning",
                                              "pack_matrix",
                                              "message",
                                              "def",
                                              "ruledisable",
                                              "dxc",
                                              "debug",
                                              "PSSL_target_output_format"};
  return names;
}

std::vector<std::string> all_names() {
  std::vector<std::string> names = read_pragmas();
  names.insert(names.end(), option_pragmas().begin(), option_pragmas().end());
  for (const std::string& name : built_in_set_names()) names.push_back(name);
  for (const auto& [base, kind] : bases) {
    for (const std::string local : {"", "_local"}) {
      names.push_back(std::string(base) + local);
      for (const std::string_view stage : stage_suffixes)
        names.push_back(std::string(base) + local + "_" + std::string(stage));
    }
  }
  return names;
}

}  // namespace

std::optional<KeywordPragmaName> keyword_pragma_name(std::string_view name) {
  for (const auto& [base, kind] : bases) {
    if (name.substr(0, base.size()) != base) continue;
    std::string_view rest = name.substr(base.size());
    if (!rest.empty() && rest.front() != '_') return std::nullopt;
    KeywordPragmaName result;
    result.base = kind;
    StageSet stages;
    std::vector<std::string_view> seen;
    while (!rest.empty()) {
      const std::string_view suffix = rest.substr(1, rest.find('_', 1) - 1);
      rest.remove_prefix(1 + suffix.size());
      if (std::find(seen.begin(), seen.end(), suffix) != seen.end()) return std::nullopt;
      if (suffix == "local") {
        result.local = true;
      } else if (std::find(std::begin(stage_suffixes), std::end(stage_suffixes), suffix) ==
                 std::end(stage_suffixes)) {
        return std::nullopt;
      } else if (const std::optional<hlsl::Stage> stage = hlsl::find_stage(suffix)) {
        stages.add(*stage);
      }
      seen.push_back(suffix);
    }
    const bool for_all_stages = seen.size() == (result.local ? 1 : 0);
    if (!for_all_stages) result.stages = stages;
    return result;
  }
  return std::nullopt;
}

bool is_option_pragma(std::string_view name) {
  const std::vector<std::string>& names = option_pragmas();
  return std::find(names.begin(), names.end(), name) != names.end();
}

const std::vector<std::string>& pragma_names() {
  static const std::vector<std::string> names = all_names();
  return names;
}

const std::vector<std::string>& renderer_names() {
  static const std::vector<std::string> names{
      "d3d11",  "d3d11_9x", "d3d9",  "xboxone", "xboxseries", "gamecore", "glcore",      "opengl",
      "gles",   "gles3",    "metal", "vulkan",  "ps4",        "ps5",      "playstation", "psp2",
      "switch", "switch2",  "wiiu",  "n3ds",    "webgpu",     "nomrt",    "xbox360",     "ps3"};
  return names;
}

const std::vector<std::string>& feature_names() {
  static const std::vector<std::string> names{"interpolators10",
                                              "interpolators15",
                                              "interpolators32",
                                              "integers",
                                              "mrt4",
                                              "mrt8",
                                              "derivatives",
                                              "samplelod",
                                              "fragcoord",
                                              "2darray",
                                              "cubearray",
                                              "instancing",
                                              "geometry",
                                              "tessellation",
                                              "compute",
                                              "randomwrite",
                                              "tesshw",
                                              "msaatex",
                                              "sparsetex",
                                              "framebufferfetch",
                                              "fbfetch",
                                              "inlineraytracing",
                                              "setrtarrayindexfromanyshader",
                                              "wavebasic",
                                              "wavevote",
                                              "waveballot",
                                              "wavemath",
                                              "wavemultiprefix",
                                              "quadshuffle",
                                              "int64",
                                              "int64bufferatomics",
                                              "int64groupsharedatomics",
                                              "native16bit",
                                              "barycentrics",
                                              "variable_rate_shading"};
  return names;
}

const std::vector<std::string>& instancing_option_names() {
  static const std::vector<std::string> names{"forcemaxcount",    "maxcount",     "assumeuniformscaling",
                                              "nolodfade",        "nolightprobe", "nolightmap",
                                              "renderinglayer",   "procedural",   "lodfade",
                                              "norenderinglayer", "nomatrices"};
  return names;
}

std::optional<int> shader_model(std::string_view name) {
  if (name == "es3.0") return 35;
  if (name == "es3.1") return 45;
  if (name == "gl4.1") return 46;
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (name.size() != 3 || name[1] != '.' || !digit(name[0]) || !digit(name[2])) return std::nullopt;
  const int model = (name[0] - '0') * 10 + (name[2] - '0');
  return model >= 20 && model < 70 ? std::optional<int>(model) : std::nullopt;
}

}  // namespace penumbra::variants
