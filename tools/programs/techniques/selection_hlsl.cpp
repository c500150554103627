#include "techniques/selection_hlsl.h"

#include <fmt/format.h>

#include <algorithm>

#include "input/input_error.h"
#include "techniques/parameter_packing.h"
#include "techniques/technique_call.h"

namespace penumbra::techniques {
namespace {

constexpr const char* kLibrary = "../";  // the library's folder as the written file sees it

constexpr const char* kTechniqueByKeyword = R"(// Penumbra: the technique that a shader keyword selects.
// Written by `penumbra emit` from the manifests, *.technique.json; do not edit.
//
// Computes:   visibility with the filter of the enabled keyword:
{filters}// Source:     see each filter's file.
// Inputs:     shadow map, its comparison and point samplers, ShadowReceiver, ShadowTile; the uniforms below, which the
//             C# structs of these names in Runtime/Parameters set; cascade: the receiver's cascade, for techniques with
//             rules for far cascades. The uniforms of a rule have its first cascade in their names. Some filters read
//             maps that passes make from the shadow map, the textures below: those are for the renderer feature's own
//             screen pass. Other shaders get an error, unless they define PENUMBRA_MAPS_BOUND and are drawn after
//             these passes, while the feature's technique is the keyword's or one that publishes the same maps.
// Cost:       the technique's fetches.
// Guarantees: [0, 1]. Only the file of the selected filter is included.
// Use it:     after a pipeline's bindings, as Shadows.hlsl and Hdrp.hlsl do. Not: directly from a shader.
#ifndef PENUMBRA_TECHNIQUE_BY_KEYWORD_HLSL
#define PENUMBRA_TECHNIQUE_BY_KEYWORD_HLSL

#include "{library}Core/ShadowStructs.hlsl"

// These filters, or the passes before them, read raw depths from a texture that has a comparison sampler. That is
// undefined in OpenGL, OpenGL ES and WebGL, and before ES 3.1 there is no gather: a filter that only compares is used
// instead; on WebGPU too, where no frame was seen yet. Define PENUMBRA_RAW_DEPTH_READS where the map is bound without
// comparison there.
#if !defined(PENUMBRA_RAW_DEPTH_READS) && \
    (defined(SHADER_API_GLCORE) || defined(SHADER_API_GLES) || defined(SHADER_API_GLES3) || \
     defined(SHADER_API_WEBGL) || defined(SHADER_API_WEBGPU))
#define PENUMBRA_WITHOUT_GATHER
#endif

{choices}
{maps_rule}{includes}{maps}{structs}{rules}
float FilterByKeyword(TEXTURE2D_SHADOW_PARAM(shadowMap, sampler_shadowMap), SAMPLER(sampler_point),
                      ShadowReceiver receiver, ShadowTile tile, int cascade)
{{
{calls}}}

#endif
)";

constexpr const char* kFilter = R"(//               {:<{}}  {:<{}}  {}
)";

constexpr const char* kWithoutGather = R"({} defined(PENUMBRA_WITHOUT_GATHER) && \
    ({})
)";

constexpr const char* kMapsRule =
    R"(// The renderer feature's passes bind these maps while its technique is this keyword's.
#if defined(PENUMBRA_READS_MAPS) && !defined(PENUMBRA_MAPS_BOUND)
#error "this keyword's filter reads maps that only the renderer feature's passes make: choose another, or define PENUMBRA_MAPS_BOUND where they are bound"
#endif

)";

// A filter's lines among those of the other filters.
constexpr const char* kBranch = R"({} {}
{})";

constexpr const char* kUniforms = R"(
#include "{library}{folder}Parameters/{name}.hlsl"
{uniforms}
{name} {function}()
{{
    return Unpack{name}({vectors});
}}
)";

constexpr const char* kRules = R"(
#if {}
{}#endif
)";

constexpr const char* linear_sampler = "linearSampler";
constexpr const char* linear_sampler_name = "sampler_PenumbraLinearClamp";  // Unity makes it from the words
constexpr std::size_t kWidest = 100;  // characters of a condition in a line
constexpr std::size_t kWidestCall = 119;

// Returns "PENUMBRA_USES_PCSS" for "_PENUMBRA_PCSS".
std::string macro_of(const Selection& selection) {
  return "PENUMBRA_USES_" + selection.keyword.substr(std::string("_PENUMBRA_").size());
}

class KeywordWriter {
 public:
  explicit KeywordWriter(const TechniqueList& list) : list_(list) {
    for (const Selection& selection : list.selections) {
      if (selection.draws_visibility) continue;
      in_shaders_.push_back(&selection);
      if (selection.keyword.empty())
        otherwise_ = &selection;
      else
        by_keyword_.push_back(&selection);
    }
    if (otherwise_ == nullptr)
      throw InputError(list.package.string(), "no selection is without a keyword",
                       "give the one that shaders use without any: \"keyword\": \"\"");
  }

  std::string text() const {
    return fmt::format(kTechniqueByKeyword, fmt::arg("filters", filters()), fmt::arg("library", kLibrary),
                       fmt::arg("choices", choices()), fmt::arg("maps_rule", any_maps() ? kMapsRule : ""),
                       fmt::arg("includes", includes()), fmt::arg("maps", maps()),
                       fmt::arg("structs", uniforms()), fmt::arg("rules", rules()),
                       fmt::arg("calls", calls()));
  }

 private:
  static std::string in_library(const std::string& file) {
    constexpr std::string_view library = "ShaderLibrary/";
    return file.starts_with(library) ? file.substr(library.size()) : file;
  }

  static std::string file_of(const FilterCall& filter) { return in_library(filter.file); }

  const std::vector<CascadeRule>& rules_of(const Selection& selection) const {
    return list_.find(selection.technique).cascades;
  }

  std::string filters() const {
    std::size_t keyword = 0;
    std::size_t function = 0;
    for (const Selection* selection : in_shaders_) {
      keyword = std::max(keyword, selection->keyword.size());
      function = std::max(function, selection->filter.function.size());
    }
    const auto line = [&](const std::string& name, const Selection& selection) {
      return fmt::format(kFilter, name, keyword, selection.filter.function, function,
                         file_of(selection.filter));
    };
    std::string lines;
    for (const Selection* selection : by_keyword_) lines += line(selection->keyword, *selection);
    return lines + line("none of them", *otherwise_);
  }

  // Defines one macro for the filter that is used, and none for the one without a keyword.
  std::string choices() const {
    std::string text;
    const auto directive = [&] { return text.empty() ? "#if" : "#elif"; };
    for (const Selection* fallback : in_shaders_) {
      std::string keywords;
      std::size_t width = 0;
      for (const Selection* selection : by_keyword_) {
        if (selection->fallback != fallback->name) continue;
        const std::string one = "defined(" + selection->keyword + ")";
        const bool fits = keywords.empty() || width + one.size() < kWidest;
        keywords += keywords.empty() ? "" : fits ? " || " : " || \\\n     ";
        width = (fits ? width + 4 : 0) + one.size();
        keywords += one;
      }
      if (keywords.empty()) continue;
      text += fmt::format(kWithoutGather, directive(), keywords);
      if (!fallback->keyword.empty()) text += definition_of(macro_of(*fallback));
    }
    for (const Selection* selection : by_keyword_) {
      text += fmt::format(kBranch, directive(), "defined(" + selection->keyword + ")",
                          definition_of(macro_of(*selection)));
      if (selection->reads_raw_depth()) text += definition_of("PENUMBRA_READS_RAW_DEPTH");
      if (!selection->textures.empty()) text += definition_of("PENUMBRA_READS_MAPS");
    }
    return text + "#endif\n";
  }

  static std::string definition_of(const std::string& macro) { return "#define " + macro + "\n"; }

  bool any_maps() const {
    return std::any_of(by_keyword_.begin(), by_keyword_.end(),
                       [](const Selection* selection) { return !selection->textures.empty(); });
  }

  // Joins the lines of each filter with a keyword that has some, in #if and #elif.
  template <typename Lines>
  std::string branches(Lines lines) const {
    std::string text;
    for (const Selection* selection : by_keyword_)
      if (const std::string own = lines(*selection); !own.empty())
        text += fmt::format(kBranch, text.empty() ? "#if" : "#elif", "defined(" + macro_of(*selection) + ")",
                            own);
    return text;
  }

  // Declares the filters' arguments besides the shadow map, each for the filters that take it.
  std::string maps() const {
    const std::string text = branches([](const Selection& selection) {
      std::string lines;
      for (const std::string& argument : selection.filter.arguments)
        if (argument == linear_sampler) lines += "SAMPLER(" + std::string(linear_sampler_name) + ");\n";
      for (const GraphTexture& texture : selection.textures) lines += declaration_of(texture);
      return lines;
    });
    return text.empty() ? "" : "\n" + text + "#endif\n";
  }

  std::string includes() const {
    const auto lines = [this](const Selection& selection) {
      std::vector<std::string> included{file_of(selection.filter)};
      for (const CascadeRule& rule : rules_of(selection))
        if (std::find(included.begin(), included.end(), file_of(rule.filter)) == included.end())
          included.push_back(file_of(rule.filter));
      std::string text;
      for (const std::string& file : included) text += "#include \"" + (kLibrary + file) + "\"\n";
      return text;
    };
    return branches(lines) + "#else\n" + lines(*otherwise_) + "#endif\n";
  }

  std::vector<const ParameterStruct*> structs() const {
    std::vector<const ParameterStruct*> used;
    const auto use = [&](const FilterCall& filter) {
      const ParameterStruct* parameters = list_.find_struct(filter.parameters);
      if (parameters != nullptr && std::find(used.begin(), used.end(), parameters) == used.end())
        used.push_back(parameters);
    };
    for (const Selection* selection : in_shaders_) {
      use(selection->filter);
      for (const CascadeRule& rule : rules_of(*selection)) use(rule.filter);
    }
    return used;
  }

  static std::string unpacker_of(const ParameterStruct& parameters) {
    const std::size_t ending = parameters.name.rfind("Parameters");
    return "Penumbra" + parameters.name.substr(0, ending == 0 ? std::string::npos : ending);
  }

  std::string uniforms() const {
    std::string text;
    for (const ParameterStruct* parameters : structs()) {
      std::string declared, vectors;
      for (std::size_t i = 0; i < vector_count(*parameters); ++i) {
        declared += "float4 " + uniform_name(*parameters, i) + ";\n";
        vectors += (i == 0 ? "" : ", ") + uniform_name(*parameters, i);
      }
      text += fmt::format(
          kUniforms, fmt::arg("library", kLibrary),
          fmt::arg("folder", in_library(parameters->manifest.substr(0, parameters->manifest.rfind('/') + 1))),
          fmt::arg("name", parameters->name), fmt::arg("uniforms", declared),
          fmt::arg("function", unpacker_of(*parameters)), fmt::arg("vectors", vectors));
    }
    return text;
  }

  // Declares the uniforms of rules, only for shaders that have them.
  std::string rules() const {
    std::string text;
    for (const Selection* selection : in_shaders_) {
      std::string lines;
      for (const CascadeRule& rule : rules_of(*selection))
        if (const ParameterStruct* parameters = list_.find_struct(rule.filter.parameters))
          for (std::size_t i = 0; i < vector_count(*parameters); ++i)
            lines += "float4 " + uniform_name(*parameters, i, rule) + ";\n";
      if (lines.empty()) continue;
      const std::string condition =
          selection->keyword.empty() ? none_of_them() : "defined(" + macro_of(*selection) + ")";
      text += fmt::format(kRules, condition, lines);
    }
    return text;
  }

  std::string none_of_them() const {
    std::string condition;
    for (const Selection* selection : by_keyword_)
      condition += (condition.empty() ? "!defined(" : " && !defined(") + macro_of(*selection) + ")";
    return condition.empty() ? "1" : condition;
  }

  // The calls are in the order of falling index, each for its first cascade and those behind it.
  std::string calls_of(const Selection& selection) const {
    std::string calls;
    for (const CascadeRule& rule : rules_of(selection)) {
      std::string vectors;
      if (const ParameterStruct* parameters = list_.find_struct(rule.filter.parameters)) {
        for (std::size_t i = 0; i < vector_count(*parameters); ++i)
          vectors += (i == 0 ? "" : ", ") + uniform_name(*parameters, i, rule);
        vectors = "Unpack" + parameters->name + "(" + vectors + ")";
      }
      const std::string test = fmt::format("    if (cascade >= {}) return ", rule.from);
      calls.insert(0, call_of(selection, rule.filter, test, vectors) + "\n");
    }
    const ParameterStruct* parameters = list_.find_struct(selection.filter.parameters);
    return calls + call_of(selection, selection.filter, "    return ",
                           parameters == nullptr ? "" : unpacker_of(*parameters) + "()");
  }

  static std::string expression_of(const std::string& argument) {
    if (argument == shadow_map_name) return "TEXTURE2D_SHADOW_ARGS(shadowMap, sampler_shadowMap)";
    if (argument == "pointSampler") return "sampler_point";
    return argument == linear_sampler ? linear_sampler_name : argument_name(argument);
  }

  std::string call_of(const Selection& selection, const FilterCall& filter, const std::string& begin,
                      const std::string& parameters) const {
    const std::string opening = begin + filter.function + "(";
    const std::string indent(opening.size(), ' ');
    std::string call;
    std::string line = opening;
    const auto append = [&](const std::string& argument, bool wraps) {
      if (line != opening && (wraps || line.size() + argument.size() >= kWidestCall)) {
        call += line + "\n";
        line = indent;
      } else if (line != opening) {
        line += " ";
      }
      line += argument + ",";
    };
    for (const std::string& argument : filter.arguments) {
      if (filter.takes(shadow_map_name) && argument == "pointSampler" && !selection.reads_raw_depth())
        throw InputError(
            selection.where,
            "'" + selection.name + "' reads raw depths in far cascades alone: '" + filter.function +
                "' takes the point sampler",
            "shaders must know from the first cascade on that they do: give it a filter that does");
      append(expression_of(argument), false);
    }
    append("receiver, tile", false);
    if (!parameters.empty()) append(parameters, true);
    line.pop_back();
    return call + line + ");";
  }

  std::string calls() const {
    const auto lines = [this](const Selection& selection) { return calls_of(selection) + "\n"; };
    return branches(lines) + "#else\n" + lines(*otherwise_) + "#endif\n";
  }

  const TechniqueList& list_;
  std::vector<const Selection*> in_shaders_;
  std::vector<const Selection*> by_keyword_;
  const Selection* otherwise_ = nullptr;
};

}  // namespace

std::string emit_keywords_hlsl(const TechniqueList& list) {
  return KeywordWriter(list).text();
}

}  // namespace penumbra::techniques
