// Texture reads for which glslang cannot resolve the texture.
//
// - With a comparison sampler, if the texture is a parameter, a local variable or a member of a struct and is
//   also read otherwise: glslang creates two variables and sets only one; the other reads are silently lost
//   (tools/programs/shaders/module_problems.h detects such modules).
// - Of a texture in a nested struct, in an array element or in a function's result, `Build(a).map.Sample(s,
//   uv)`: "unable to find texture symbol".
//
// Such a read is moved into a function at the beginning of the text, one for each kind of texture and read,
// with the texture as its parameter: `Sample_of(Build(a).map, s, uv)`.
//
// Limits: reads with an offset are not changed, because the offset has to be a literal; nor are
// compare-gathers.

#include <algorithm>
#include <array>
#include <map>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"
#include "preparation/passes.h"
#include "preparation/postfix_expression.h"
#include "preparation/resource_types.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

struct Texture {
  std::string_view type;
  std::string_view coordinate;  // including the layer of an array
  std::string_view direction;   // without the layer: the dimension of gradients
};
constexpr std::array<Texture, 7> textures{{{"Texture1D", "float", "float"},
                                           {"Texture1DArray", "float2", "float"},
                                           {"Texture2D", "float2", "float2"},
                                           {"Texture2DArray", "float3", "float2"},
                                           {"Texture3D", "float3", "float3"},
                                           {"TextureCube", "float3", "float3"},
                                           {"TextureCubeArray", "float4", "float3"}}};

// A member function of textures. C and D in its parameters are replaced by the two types above.
struct ReadFunction {
  std::string_view name;
  std::string_view returned;  // if empty, the texture's element type
  std::string_view parameters;
  std::string_view arguments;
  int count;  // number of them
};
constexpr std::array<ReadFunction, 12> functions{
    {{"Sample", "", "SamplerState s, C c", "s, c", 2},
     {"SampleLevel", "", "SamplerState s, C c, float level", "s, c, level", 3},
     {"SampleBias", "", "SamplerState s, C c, float bias", "s, c, bias", 3},
     {"SampleGrad", "", "SamplerState s, C c, D dx, D dy", "s, c, dx, dy", 4},
     {"SampleCmp", "float", "SamplerComparisonState s, C c, float reference", "s, c, reference", 3},
     {"SampleCmpLevelZero", "float", "SamplerComparisonState s, C c, float reference", "s, c, reference", 3},
     {"Gather", "float4", "SamplerState s, C c", "s, c", 2},
     {"GatherRed", "float4", "SamplerState s, C c", "s, c", 2},
     {"GatherGreen", "float4", "SamplerState s, C c", "s, c", 2},
     {"GatherBlue", "float4", "SamplerState s, C c", "s, c", 2},
     {"GatherAlpha", "float4", "SamplerState s, C c", "s, c", 2},
     {"CalculateLevelOfDetail", "float", "SamplerState s, D c", "s, c", 2}}};

template <typename Row, std::size_t Size>
const Row* row(const std::array<Row, Size>& rows, std::string_view name, std::string_view Row::*key) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.*key == name; });
  return found == rows.end() ? nullptr : &*found;
}

bool compares(std::string_view function) {
  return function.substr(0, 9) == "SampleCmp" || function.substr(0, 9) == "GatherCmp";
}

// A read of a texture: `texture.function(`.
struct Read {
  std::size_t declared = npos;  // the variable or member that names the texture
  std::size_t first = npos;     // first token of the texture's chain
  std::size_t dot = npos;
};

class Reads {
 public:
  explicit Reads(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (std::size_t dot = 1; dot + 2 < text_.size(); ++dot)
      if (text_.is(dot, ".") && text_.is_identifier(dot + 1) && text_.is(dot + 2, "(")) find(dot);
    for (const Read& read : comparisons_)
      if (otherwise_.count(read.declared) != 0) separate(read);
    for (const Read& read : indirect_) separate(read);
    std::string definitions;
    for (const std::string& definition : needed_) definitions += definition;
    if (!definitions.empty()) text_.insert(0, definitions);
    text_.apply();
  }

 private:
  void find(std::size_t dot) {
    std::size_t name = dot - 1;
    while (text_.is(name, "]") && text_.matching_bracket(name) != npos && text_.matching_bracket(name) > 0)
      name = text_.matching_bracket(name) - 1;
    const std::size_t index = text_.is_identifier(name) ? types_.named(name) : npos;
    const std::size_t first = types_.begin(dot - 1);
    if (index == npos || first == npos || !is_texture(types_.at(dot - 1).name)) return;
    const bool comparison = compares(text_.word(dot + 1));
    if (!comparison) otherwise_.insert(index);
    if (is_indirect(first, dot)) {
      indirect_.push_back({index, first, dot});
    } else if (comparison && !is_resource_itself(types_.declared()[index])) {
      comparisons_.push_back({index, first, dot});
    }
  }

  // Returns whether the texture is a member that is accessed through another member, a call or an array
  // element.
  bool is_indirect(std::size_t first, std::size_t dot) const {
    int members = 0;
    bool brackets = false;
    for (std::size_t at = first; at < dot; ++at) {
      members += text_.is(at, ".") ? 1 : 0;
      brackets = brackets || text_.matching_bracket(at) != npos;
    }
    return members > 1 || (members == 1 && brackets);
  }

  static bool is_resource_itself(const DeclaredValue& value) {
    return value.place == DeclaredValue::Place::global && !value.is_static;
  }

  int arguments(std::size_t open) const {
    const std::size_t close = text_.matching_bracket(open);
    if (close == npos) return 0;
    int commas = 0;
    for (std::size_t at = open + 1; at < close; ++at) {
      if (text_.matching_bracket(at) != npos && text_.matching_bracket(at) > at)
        at = text_.matching_bracket(at);
      commas += text_.is(at, ",") ? 1 : 0;
    }
    return commas + 1;
  }

  void separate(const Read& read) {
    const ValueType& type = types_.at(read.dot - 1);
    const Texture* texture = row(textures, type.name, &Texture::type);
    const ReadFunction* function = row(functions, text_.word(read.dot + 1), &ReadFunction::name);
    if (texture == nullptr || function == nullptr || arguments(read.dot + 2) != function->count) return;
    needed_.insert(definition(*texture, type.element, *function));
    text_.insert(read.first, function_name(*function) + "(");
    text_.replace(read.dot, 3, ",");
  }

  std::string function_name(const ReadFunction& function) const {
    return text_.free_name(std::string(function.name) + "_of");
  }

  std::string definition(const Texture& texture, std::string_view element,
                         const ReadFunction& function) const {
    const std::string held(element.empty() ? "float4" : element);
    std::string text = std::string(function.returned.empty() ? held : function.returned) + " ";
    text.append(function_name(function)).append("(").append(texture.type);
    if (!element.empty()) text.append("<").append(held).append(">");
    text.append(" t, ");
    for (const char c : function.parameters) {
      if (c == 'C' && text.back() == ' ') {
        text.append(texture.coordinate);
      } else if (c == 'D' && text.back() == ' ') {
        text.append(texture.direction);
      } else {
        text += c;
      }
    }
    return text.append(") { return t.")
        .append(function.name)
        .append("(")
        .append(function.arguments)
        .append("); } ");
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<Read> comparisons_;
  std::vector<Read> indirect_;
  std::set<std::size_t> otherwise_;  // declared values that are read without comparison
  std::set<std::string> needed_;     // functions
};

}  // namespace

void separate_texture_reads(TokenText& text) {
  Reads(text).run();
}

}  // namespace penumbra::preparation
