#include "shaders/parse_message.h"

#include <array>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "hlsl/identifier.h"
#include "hlsl/name_set.h"
#include "input/nearest_name.h"
#include "shaders/parse_log.h"

namespace penumbra::shaders {

namespace {

struct Names {
  std::string_view glsl;
  std::string_view hlsl;
};

constexpr Names names[] = {{"vec2", "float2"},
                           {"vec3", "float3"},
                           {"vec4", "float4"},
                           {"ivec2", "int2"},
                           {"ivec3", "int3"},
                           {"ivec4", "int4"},
                           {"uvec2", "uint2"},
                           {"uvec3", "uint3"},
                           {"uvec4", "uint4"},
                           {"bvec2", "bool2"},
                           {"bvec3", "bool3"},
                           {"bvec4", "bool4"},
                           {"mat2", "float2x2"},
                           {"mat3", "float3x3"},
                           {"mat4", "float4x4"},
                           {"sampler2DArray", "Texture2DArray"},
                           {"samplerCube", "TextureCube"},
                           {"dFdx", "ddx"},
                           {"dFdy", "ddy"},
                           {"floatBitsToInt", "asint"},
                           {"floatBitsToUint", "asuint"},
                           {"fract", "frac"},
                           {"intBitsToFloat", "asfloat"},
                           {"inversesqrt", "rsqrt"},
                           {"mix", "lerp"},
                           {"mod", "fmod"},
                           {"texelFetch", "Load"},
                           {"textureGrad", "SampleGrad"},
                           {"textureLod", "SampleLevel"},
                           {"uintBitsToFloat", "asfloat"}};

// GLSL's names of types and functions that HLSL names otherwise, for messages.
//
// Returns HLSL's name; empty if GLSL has no such name, or HLSL the same.
std::string_view hlsl_name(std::string_view glsl) {
  const auto* const found =
      std::find_if(std::begin(names), std::end(names), [&](const Names& one) { return one.glsl == glsl; });
  return found == std::end(names) ? std::string_view{} : found->hlsl;
}

// {token, prefix of the message, our message}: an empty token matches any. In our message % is the token and
// $ the rest of glslang's message after the prefix.
struct Phrase {
  std::string_view token;
  std::string_view message;
  std::string_view words;
};

constexpr std::array<Phrase, 27> phrases{{
    {"assign", "l-value required (can't modify a const)", "the left side of '=' is const"},
    {"assign", "l-value required", "the left side of '=' cannot be written$"},
    {"", "l-value required", "'%' needs a variable that can be written$"},
    {"", "no matching overloaded function found", "no function '%' takes these arguments"},
    {"", "ambiguous best function under implicit type conversion",
     "several overloads of '%' fit these arguments: cast the arguments to the types of one"},
    {"", "function already has a body", "function '%' already has a body"},
    {"", "redefinition", "'%' is already declared$"},
    {"[", "array index out of range", "the index $ is outside of the array"},
    {"constructor", "not enough data provided for construction", "too few components for this constructor"},
    {"constructor", "too many arguments", "too many components for this constructor"},
    {"conditional expression", "", "a condition must be one value, not a vector"},
    {"", "vector swizzle selection out of range", "'.%' asks for components that the vector does not have"},
    {"", "vector swizzle selectors not from the same set", "'.%' mixes xyzw with rgba"},
    {"", "unknown swizzle selection", "'.%' is not a swizzle"},
    {"", "Reserved word.",
     "'%' is a reserved word; the enum, operator and template of HLSL 2017 and 2021 are not supported"},
    {"", "no such field in structure", "the structure has no member '%'"},
    {"register", "ignoring unrecognized register type", "'$' is not a kind of register: use b, t, s, u or c"},
    {"", "Could not perform requested binary operation", "'@' cannot combine these two types"},
    {"", "array size must be a constant integer expression", "an array's size must be a constant integer"},
    {"return", "void function cannot return a value", "a void function returns no value"},
    {"", "function does not return a value:", "function '$' must return a value"},
    {"return", "type does not match, or is not convertible to, the function's return type",
     "this cannot be converted to the function's return type"},
    {"", "numeric literal too big", "this number is too big for an int"},
    {"", "octal literal digit too large", "a number that starts with 0 is octal: no digit is above 7"},
    {"", "expected: SamplerComparisonState",
     "a method that compares takes a SamplerComparisonState: declare its sampler so, or read with Sample"},
    {"", "expected: mul arguments", "mul takes two arguments"},
    {"", "could not create assignment",
     "'@' cannot assign this value: its type cannot be converted to the variable's, or the variable is a "
     "bool"},
}};

// Returns the text trimmed, without quotes around it.
std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  text = text.substr(first, text.find_last_not_of(' ') - first + 1);
  const bool quoted = text.size() > 2 && text.front() == '\'' && text.back() == '\'';
  return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

// Turns " (can't read from writeonly object)" into ": can't read ..."; " 4" stays as it is.
std::string as_reason(const std::string& rest) {
  if (rest.size() > 2 && rest.front() == '(' && rest.back() == ')')
    return ": " + rest.substr(1, rest.size() - 2);
  return rest.empty() ? "" : " " + rest;
}

std::string fill(std::string_view words, const LogLine& line, std::string_view rest,
                 const Surroundings& around) {
  std::string text;
  for (const char c : words) {
    if (c == '%') {
      text += line.token;
    } else if (c == '@') {
      text += around.found.empty() ? "this operator" : around.found;
    } else if (c == '$') {
      const bool quoted = !text.empty() && (text.back() == '\'' || text.back() == '#' || text.back() == ' ');
      text += quoted ? trimmed(rest) : as_reason(trimmed(rest));
    } else {
      text += c;
    }
  }
  return text;
}

// Returns the grammar's name of the missing part; punctuation and keywords of HLSL are quoted.
std::string in_words(const std::string& part) {
  static const std::map<std::string, std::string> words{
      {"declaration", "a declaration"},
      {"identifier", "a name"},
      {"namespace name", "a name of the namespace"},
      {"type", "a type"},
      {"literal", "a number or a text"},
      {"expression", "an expression"},
      {"assignment expression", "an expression"},
      {"initializer", "an initial value"},
      {"layout, semantic, packoffset, or register", "a semantic, packoffset or register"}};
  const auto found = words.find(part);
  return found == words.end() ? "'" + part + "'" : found->second;
}

std::string expected(const LogLine& line, const Surroundings& around) {
  if (line.token == "loop or switch") return "'break' is outside of every loop and switch";
  if (line.token == "loop") return "'continue' is outside of every loop";
  if (around.found == "else") return "'else' has no 'if'";
  const std::string found = std::string(around.found);
  if (around.found_is_identifier && around.next_is_identifier && line.token == ")")
    return "unknown type '" + found + "'";
  std::string text = "expected " + in_words(line.token);
  if (found.empty() || (line.token == ";" && !around.same_line_as_before)) return text;
  text += ", found '" + found + "'";
  if (line.token == "declaration" && around.found_is_identifier && around.next == "(")
    text += "; is its return type missing?";
  return text;
}

bool is_storage(const std::string& word) {
  static const std::set<std::string> words{"temp",    "global", "const",  "in",     "out",
                                           "uniform", "inout",  "buffer", "shared", "noContraction"};
  return words.count(word) != 0;
}

std::string vector_or_matrix(const std::string& size, const std::string& kind, const std::string& type) {
  if (kind == "vector") return type + size.substr(0, size.find('-'));
  std::string shape = size;  // glslang's 4X3 has the order of HLSL's rows and columns
  std::replace(shape.begin(), shape.end(), 'X', 'x');
  return type + shape;
}

// Converts the inside of one quoted type: storage qualifiers are removed, "N-component vector of T" becomes
// TN.
std::string hlsl_type(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    if (!is_storage(word)) words.push_back(word);
  std::string type;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!type.empty()) type += ' ';
    const bool built = i + 3 < words.size() && (words[i + 1] == "vector" || words[i + 1] == "matrix") &&
                       words[i + 2] == "of";
    type += built ? vector_or_matrix(words[i], words[i + 1], words[i + 3]) : words[i];
    if (built) i += 3;
  }
  return type;
}

}  // namespace

std::string with_hlsl_types(const std::string& message) {
  std::string text;
  std::size_t at = 0;
  while (true) {
    const std::size_t open = message.find('\'', at);
    const std::size_t close = open == std::string::npos ? open : message.find('\'', open + 1);
    if (close == std::string::npos) return text + message.substr(at);
    const std::string quoted = message.substr(open + 1, close - open - 1);
    const std::string type = hlsl_type(quoted);
    text += message.substr(at, open - at) + "'" + (type.empty() ? quoted : type) + "'";
    at = close + 1;
  }
}

std::string sentence(const LogLine& line, const Surroundings& around) {
  if (line.message == "Expected") return expected(line, around);
  constexpr std::string_view argument = "cannot convert input argument, argument ";
  if (std::string_view(line.message).substr(0, argument.size()) == argument)  // counts from 0
    return "argument " + std::to_string(std::atoi(line.message.c_str() + argument.size()) + 1) +
           " does not fit its parameter";
  if (line.message == "unknown variable" && around.found == line.token && around.next_is_identifier)
    return "unknown type '" + line.token + "'";
  for (const Phrase& phrase : phrases) {
    const bool known = (phrase.token.empty() || phrase.token == line.token) &&
                       std::string_view(line.message).substr(0, phrase.message.size()) == phrase.message;
    if (known)
      return fill(phrase.words, line, std::string_view(line.message).substr(phrase.message.size()), around);
  }
  std::string message = with_hlsl_types(line.message);
  if (line.token.empty()) return message;
  if (hlsl::is_identifier(line.token) || message == "unexpected token")
    return message + " '" + line.token + "'";
  return "'" + line.token + "': " + message;
}

std::string nearest_function(const std::string& unknown, const hlsl::TokenPlaces& text) {
  std::set<std::string> functions;
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if (text[i].kind == hlsl::Token::Kind::identifier && text[i].spelling.size() <= 64 &&
        text[i - 1].kind == hlsl::Token::Kind::identifier && text[i - 1].spelling != "return" &&
        text[i + 1].spelling == "(")
      functions.emplace(text[i].spelling);
  functions.erase("return");
  const std::string nearest = nearest_name(unknown, {functions.begin(), functions.end()});
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

std::string nearest_method(const std::string& unknown) {
  static const std::vector<std::string> methods = hlsl::names_in(
      "Append CalculateLevelOfDetail CalculateLevelOfDetailUnclamped Consume Gather GatherAlpha "
      "GatherBlue GatherCmp GatherGreen GatherRed GetDimensions GetSamplePosition InterlockedAdd Load "
      "Load2 Load3 Load4 RestartStrip Sample SampleBias SampleCmp SampleCmpLevelZero SampleGrad "
      "SampleLevel Store Store2 Store3 Store4");
  if (std::find(methods.begin(), methods.end(), unknown) != methods.end()) return {};
  const std::string nearest = nearest_name(unknown, methods);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

bool is_intrinsic(const std::string& name) {
  static const std::set<std::string> names{"abs",
                                           "acos",
                                           "all",
                                           "any",
                                           "asdouble",
                                           "asfloat",
                                           "asin",
                                           "asint",
                                           "asuint",
                                           "atan",
                                           "atan2",
                                           "ceil",
                                           "clamp",
                                           "clip",
                                           "cos",
                                           "cosh",
                                           "countbits",
                                           "cross",
                                           "D3DCOLORtoUBYTE4",
                                           "ddx",
                                           "ddx_coarse",
                                           "ddx_fine",
                                           "ddy",
                                           "ddy_coarse",
                                           "ddy_fine",
                                           "degrees",
                                           "determinant",
                                           "distance",
                                           "dot",
                                           "dst",
                                           "exp",
                                           "exp2",
                                           "f16tof32",
                                           "f32tof16",
                                           "faceforward",
                                           "firstbithigh",
                                           "firstbitlow",
                                           "floor",
                                           "fma",
                                           "fmod",
                                           "frac",
                                           "frexp",
                                           "fwidth",
                                           "InterlockedAdd",
                                           "InterlockedAnd",
                                           "InterlockedCompareExchange",
                                           "InterlockedCompareStore",
                                           "InterlockedExchange",
                                           "InterlockedMax",
                                           "InterlockedMin",
                                           "InterlockedOr",
                                           "InterlockedXor",
                                           "isfinite",
                                           "isinf",
                                           "isnan",
                                           "ldexp",
                                           "length",
                                           "lerp",
                                           "lit",
                                           "log",
                                           "log10",
                                           "log2",
                                           "mad",
                                           "max",
                                           "min",
                                           "modf",
                                           "mul",
                                           "normalize",
                                           "pow",
                                           "radians",
                                           "rcp",
                                           "reflect",
                                           "refract",
                                           "reversebits",
                                           "round",
                                           "rsqrt",
                                           "saturate",
                                           "sign",
                                           "sin",
                                           "sincos",
                                           "sinh",
                                           "smoothstep",
                                           "sqrt",
                                           "step",
                                           "tan",
                                           "tanh",
                                           "tex1D",
                                           "tex2D",
                                           "tex2Dbias",
                                           "tex2Dgrad",
                                           "tex2Dlod",
                                           "tex2Dproj",
                                           "tex3D",
                                           "texCUBE",
                                           "texCUBElod",
                                           "transpose",
                                           "trunc"};
  return names.count(name) != 0;
}

std::string nearest_word(std::string_view unknown, const hlsl::TokenPlaces& text) {
  constexpr std::size_t longest = 64;
  if (const std::string_view known = hlsl_name(unknown); !known.empty())
    return "; HLSL has '" + std::string(known) + "'";
  if (unknown.size() < 4 || unknown.size() > longest) return {};
  std::set<std::string> words{"float",  "float2",    "float3",       "float4",    "float3x3", "float4x4",
                              "half",   "half2",     "half3",        "half4",     "int",      "uint",
                              "bool",   "return",    "saturate",     "normalize", "length",   "smoothstep",
                              "struct", "Texture2D", "SamplerState", "sampler",   "discard",  "matrix"};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view word = text[i].spelling;
    const bool near = word.size() + 3 >= unknown.size() && word.size() <= unknown.size() + 3;
    if (text[i].kind == hlsl::Token::Kind::identifier && near && word.size() >= 3) words.emplace(word);
  }
  words.erase(std::string(unknown));
  const std::string nearest = nearest_name(unknown, {words.begin(), words.end()});
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

}  // namespace penumbra::shaders
