#include "techniques/parameter_emit.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>

#include "techniques/emitted_text.h"
#include "techniques/parameter_packing.h"

namespace penumbra::techniques {
namespace {

constexpr std::string_view kComponents = "xyzw";

constexpr const char* kHlsl = R"({doc}// Written by `penumbra emit` from {manifest}; do not edit.
//
// The comment above each field gives its unit, then its meaning. Cost: no fetch.
#ifndef {guard}
#define {guard}

struct {name}
{{
{fields}}};

{unpacks}{name} Unpack{name}({vectors})
{{
    {name} parameters;
{unpacked}    return parameters;
}}

#endif
)";

constexpr const char* kHlslField = R"({comment}    {type} {name};
)";

constexpr const char* kHlslUnpacked = R"(    parameters.{name} = {value};
)";

constexpr const char* kCsharp = R"(using System;
using UnityEngine;
using UnityEngine.Rendering;

// Written by `penumbra emit` from the manifests, *.technique.json; do not edit. Of each struct:
// Default: the manifest's defaults; a field without one is 0, or the low end of its range.
// VectorN: the uniform UniformN, each component clamped to its range; NaN gives the low end.
// SetGlobal: sets the uniforms for all later draws. It does not allocate.
namespace Penumbra
{{
{structs}}}
)";

constexpr const char* kCsharpStruct = R"(    /// <summary>{doc}</summary>
    [Serializable]
    public struct {name}
    {{
{fields}{ids}        public static {name} Default => new {name}
            {{ {defaults} }};
{vectors}        public void SetGlobal(CommandBuffer commands){sets}
    }}
)";

constexpr const char* kCsharpId =
    R"(        public static readonly int Uniform{index} = Shader.PropertyToID("{uniform}");
)";

constexpr const char* kCsharpField = R"(        [Tooltip({tooltip}){range}] public {type} {name};
)";

constexpr const char* kCsharpVector =
    R"(        public Vector4 Vector{index} => new Vector4({components});
)";

constexpr const char* kCsharpSet = R"( => commands.SetGlobalVector(Uniform0, Vector0);)";

constexpr const char* kCsharpSets = R"(
        {{
{sets}        }})";

constexpr const char* kCsharpSetOf = R"(            commands.SetGlobalVector(Uniform{index}, Vector{index});
)";

// Returns PENUMBRA_PCSS_ANGULAR_PARAMETERS_HLSL and the like.
std::string guard(const std::string& name) {
  std::string text = "PENUMBRA";
  for (const char character : name) {
    if (std::isupper(static_cast<unsigned char>(character)) != 0) text += '_';
    text += static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
  }
  return text + "_HLSL";
}

std::string sentence(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string swizzle(const PackedPlace& place, std::size_t count) {
  return std::string(kComponents.substr(place.component, count));
}

std::string csharp_type(const ParameterField& field) {
  return component_count(field) == 1 ? field.type : "Vector" + std::to_string(component_count(field));
}

std::string csharp_number(const ParameterField& field, double value) {
  return field.type == "int" ? std::to_string(static_cast<long long>(value)) : csharp_float(value);
}

std::string csharp_value(const ParameterField& field, const std::vector<double>& value) {
  if (component_count(field) == 1) return csharp_number(field, value.front());
  std::string text = "new " + csharp_type(field) + "(";
  for (std::size_t i = 0; i < component_count(field); ++i)
    text += (i == 0 ? "" : ", ") + csharp_number(field, value[i]);
  return text + ")";
}

std::string csharp_default(const ParameterField& field) {
  const double low = field.range ? field.range->smallest : 0.0;
  return csharp_value(
      field, field.otherwise.empty() ? std::vector<double>(component_count(field), low) : field.otherwise);
}

// Returns one component as the vector holds it.
std::string csharp_bounded(const ParameterField& field, const std::string& expression) {
  if (!field.range)
    return field.type == "int" ? expression
                               : "Bounded.OrLow(" + expression + ", float.MinValue, float.MaxValue)";
  return std::string(field.type == "int" ? "Bounded.Count(" : "Bounded.OrLow(") + expression + ", " +
         csharp_number(field, field.range->smallest) + ", " + csharp_number(field, field.range->largest) +
         ")";
}

std::string hlsl_fields(const ParameterStruct& parameters) {
  std::string text;
  for (const ParameterField& field : parameters.fields)
    text +=
        fmt::format(kHlslField, fmt::arg("type", field.type), fmt::arg("name", field.name),
                    fmt::arg("comment", comment_lines(field.unit + ": " + field.doc, "    //", "    //")));
  return text;
}

std::string hlsl_unpacked(const ParameterStruct& parameters) {
  std::string text;
  const std::vector<PackedPlace> places = packed_places(parameters);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ParameterField& field = parameters.fields[i];
    const std::string components =
        fmt::format("packed{}.{}", places[i].vector, swizzle(places[i], component_count(field)));
    text += fmt::format(kHlslUnpacked, fmt::arg("name", field.name),
                        fmt::arg("value", field.type == "int" ? "int(" + components + ")" : components));
  }
  return text;
}

std::string csharp_fields(const ParameterStruct& parameters) {
  std::string text;
  for (const ParameterField& field : parameters.fields) {
    const std::string summary =
        sentence(field.doc) + (field.unit == "1" ? "." : ". Unit: " + field.unit + ".");
    std::string range;
    if (field.range && component_count(field) == 1)
      range = ", Range(" + csharp_number(field, field.range->smallest) + ", " +
              csharp_number(field, field.range->largest) + ")";
    text += fmt::format(kCsharpField, fmt::arg("tooltip", csharp_text(summary)), fmt::arg("range", range),
                        fmt::arg("type", csharp_type(field)), fmt::arg("name", field.name));
  }
  return text;
}

std::string csharp_vectors(const ParameterStruct& parameters) {
  std::vector<std::vector<std::string>> vectors(vector_count(parameters), {"0.0f", "0.0f", "0.0f", "0.0f"});
  const std::vector<PackedPlace> places = packed_places(parameters);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ParameterField& field = parameters.fields[i];
    const std::size_t count = component_count(field);
    for (std::size_t k = 0; k < count; ++k)
      vectors[places[i].vector][places[i].component + k] =
          csharp_bounded(field, count == 1 ? field.name : field.name + "." + kComponents[k]);
  }
  std::string text;
  for (std::size_t i = 0; i < vectors.size(); ++i)
    text += fmt::format(kCsharpVector, fmt::arg("index", i),
                        fmt::arg("components", csharp_list(vectors[i], 12, 33)));
  return text;
}

std::string csharp_defaults(const ParameterStruct& parameters) {
  std::vector<std::string> defaults;
  for (const ParameterField& field : parameters.fields)
    defaults.push_back(field.name + " = " + csharp_default(field));
  return csharp_list(defaults, 14);
}

// Joins the results of `of` for each vector, by its number.
template <typename Of>
std::string of_each_vector(const ParameterStruct& parameters, const char* between, Of of) {
  std::string text;
  for (std::size_t i = 0; i < vector_count(parameters); ++i) text += (i == 0 ? "" : between) + of(i);
  return text;
}

std::string csharp_struct(const ParameterStruct& parameters) {
  const auto id = [&](std::size_t i) {
    return fmt::format(kCsharpId, fmt::arg("index", i), fmt::arg("uniform", uniform_name(parameters, i)));
  };
  const auto set = [](std::size_t i) { return fmt::format(kCsharpSetOf, fmt::arg("index", i)); };
  const std::string sets =
      vector_count(parameters) == 1
          ? kCsharpSet
          : fmt::format(kCsharpSets, fmt::arg("sets", of_each_vector(parameters, "", set)));
  return fmt::format(kCsharpStruct, fmt::arg("doc", xml_text(parameters.doc)),
                     fmt::arg("name", parameters.name), fmt::arg("ids", of_each_vector(parameters, "", id)),
                     fmt::arg("fields", csharp_fields(parameters)),
                     fmt::arg("defaults", csharp_defaults(parameters)),
                     fmt::arg("vectors", csharp_vectors(parameters)), fmt::arg("sets", sets));
}

}  // namespace

EmittedFile emit_hlsl(const ParameterStruct& parameters) {
  const std::filesystem::path folder = std::filesystem::path(parameters.manifest).parent_path();
  const auto uniform = [&](std::size_t i) { return uniform_name(parameters, i); };
  const auto argument = [](std::size_t i) { return "float4 packed" + std::to_string(i); };
  return {
      (folder / "Parameters" / (parameters.name + ".hlsl")).generic_string(),
      fmt::format(kHlsl, fmt::arg("doc", comment_lines(parameters.doc, "//", "//")),
                  fmt::arg("manifest", parameters.manifest), fmt::arg("guard", guard(parameters.name)),
                  fmt::arg("name", parameters.name), fmt::arg("fields", hlsl_fields(parameters)),
                  fmt::arg("unpacks",
                           comment_lines("Unpacks the uniforms " + of_each_vector(parameters, ", ", uniform) +
                                             ", which the package's C# struct of the same name sets.",
                                         "//", "//")),
                  fmt::arg("vectors", of_each_vector(parameters, ", ", argument)),
                  fmt::arg("unpacked", hlsl_unpacked(parameters)))};
}

EmittedFile emit_csharp(const std::vector<ParameterStruct>& structs, const std::string& name) {
  std::string text;
  for (const ParameterStruct& parameters : structs)
    text += (text.empty() ? "" : "\n") + csharp_struct(parameters);
  return {"Runtime/Parameters/" + name + ".cs", fmt::format(kCsharp, fmt::arg("structs", text))};
}

}  // namespace penumbra::techniques
