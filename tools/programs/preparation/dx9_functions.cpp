#include "preparation/dx9_functions.h"

#include <algorithm>
#include <array>

namespace penumbra::preparation {

namespace {

struct Dimension {
  std::string_view name;
  std::string_view texture;
  std::string_view coordinate;  // its type
  std::string_view part;        // the part of a float4 that is the coordinate
};

constexpr std::array<Dimension, 4> dimensions{{{"1D", "Texture1D", "float", "x"},
                                               {"2D", "Texture2D", "float2", "xy"},
                                               {"3D", "Texture3D", "float3", "xyz"},
                                               {"CUBE", "TextureCube", "float3", "xyz"}}};

const Dimension* find(std::string_view name) {
  const auto* const found = std::find_if(dimensions.begin(), dimensions.end(),
                                         [&](const Dimension& dimension) { return dimension.name == name; });
  return found == dimensions.end() ? nullptr : found;
}

bool starts(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}

}  // namespace

std::optional<Dx9Function> dx9_function(std::string_view name) {
  if (!starts(name, "tex")) return std::nullopt;
  name.remove_prefix(3);
  for (const Dimension& dimension : dimensions) {
    if (!starts(name, dimension.name)) continue;
    const std::string_view kind = name.substr(dimension.name.size());
    if (kind.empty() || kind == "bias" || kind == "grad" || kind == "lod" || kind == "proj")
      return Dx9Function{dimension.name, kind};
  }
  return std::nullopt;
}

std::string_view dx9_dimension(std::string_view type) {
  if (!starts(type, "sampler")) return {};
  const Dimension* dimension = find(type.substr(7));
  return dimension == nullptr ? std::string_view{} : dimension->name;
}

std::string texture_type(std::string_view dimension) {
  const Dimension* known = find(dimension);
  return known == nullptr ? std::string{} : std::string(known->texture);
}

std::string dx9_definition(std::string_view name, int arguments) {
  const std::optional<Dx9Function> function = dx9_function(name);
  if (!function) return {};
  const Dimension& dimension = *find(function->dimension);
  const std::string coordinate(dimension.coordinate);
  const std::string part = "c." + std::string(dimension.part);
  const bool four = function->kind.empty() || function->kind == "grad";
  const bool gradients = four && arguments == 4;
  if (!gradients && (arguments != 2 || function->kind == "grad")) return {};
  std::string parameters = (function->kind.empty() || gradients ? coordinate : "float4") + " c";
  std::string read = ".Sample(s, c)";
  if (gradients) {
    parameters.append(", ").append(coordinate).append(" dx, ").append(coordinate).append(" dy");
    read = ".SampleGrad(s, c, dx, dy)";
  } else if (function->kind == "lod") {
    read = ".SampleLevel(s, " + part + ", c.w)";
  } else if (function->kind == "bias") {
    read = ".SampleBias(s, " + part + ", c.w)";
  } else if (function->kind == "proj") {
    read = ".Sample(s, " + part + " / c.w)";
  }
  return "float4 " + std::string(name) + "(" + std::string(dimension.texture) + " t, SamplerState s, " +
         parameters + ") { return t" + read + "; }";
}

}  // namespace penumbra::preparation
