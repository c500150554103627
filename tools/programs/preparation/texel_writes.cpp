#include <map>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"
#include "preparation/passes.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

bool is_vector_swizzle(std::string_view word) {
  return !word.empty() && word.size() <= 4 && word.find_first_not_of("xyzwrgba") == std::string_view::npos;
}

// Returns the element type of a writable texture or typed buffer: float4 for RWTexture2D<unorm float4>; empty
// for other types.
std::string texel_type(const std::string& type) {
  if (type.rfind("RWTexture", 0) != 0 && type.rfind("RWBuffer", 0) != 0) return {};
  const std::size_t open = type.find('<');
  if (open == std::string::npos) return "float4";
  std::string inner = type.substr(open + 1, type.rfind('>') - open - 1);
  const std::size_t blank = inner.find_last_of(' ', inner.find_last_not_of(' '));
  if (blank != std::string::npos) inner.erase(0, blank + 1);
  return inner.find_first_of("<>,") == std::string::npos ? inner : std::string();
}

// Returns whether the declaration may be one of such a type.
bool names_one(const TokenText& text, const hlsl::Declaration& declaration) {
  for (std::size_t at = declaration.type; at <= declaration.last; ++at)
    if (text.lead(at) == 'R' && text.word(at).starts_with("RW")) return true;
  return false;
}

struct Texel {
  std::string type;
  std::string texture;  // its type
};

using Texels = std::map<std::string_view, Texel>;

Texels writable_textures(const TokenText& text, const std::vector<hlsl::Declaration>& declarations) {
  Texels texels;
  for (const hlsl::Declaration& declaration : declarations) {
    if (declaration.kind != hlsl::Declaration::Kind::variable || !names_one(text, declaration)) continue;
    for (const Declarator& declarator : declarators(text, declaration.type, declaration.last)) {
      const std::string type = texel_type(declarator.type);
      if (!type.empty() && declarator.dimension_count == 0)
        texels[text.word(declarator.name)] = {type, declarator.type};
    }
  }
  return texels;
}

// Returns one past `.xy` or `[1]` after a texel; the argument if there is neither.
std::size_t part_end(const TokenText& text, std::size_t at) {
  if (text.is(at, ".") && text.is_identifier(at + 1) && is_vector_swizzle(text.word(at + 1))) return at + 2;
  return text.is(at, "[") && text.matching_bracket(at) != npos ? text.matching_bracket(at) + 1 : at;
}

// Returns the type of an index of the texture.
const char* place_type(const std::string& texture) {
  if (texture.starts_with("RWTexture3D") || texture.starts_with("RWTexture2DArray")) return "int3";
  return texture.starts_with("RWTexture2D") || texture.starts_with("RWTexture1DArray") ? "int2" : "int";
}

// Returns one past `+= value`, or `++`; npos if nothing is written.
std::size_t write_end(const TokenText& text, std::size_t operation) {
  const bool step = text.is_any(operation, "+", "-") && text.is(operation + 1, text.word(operation));
  const std::size_t length = step ? 2 : assignment_length(text, operation);
  const std::size_t end = length == 0 ? npos : expression_end(text, operation + length);
  return end != npos && text.is(end, ";") ? end : npos;
}

void rewrite(TokenText& text, std::size_t name, const Texel& texel) {
  const std::size_t close = text.matching_bracket(name + 1);
  const std::size_t operation = part_end(text, close + 1);
  const std::size_t end = operation == close + 1 ? npos : write_end(text, operation);
  if (end == npos || !begins_statement(text, name)) return;
  std::string place = text.spelled(name + 2, close - name - 2);
  std::string before;
  if (!may_be_repeated(text, name + 2, close)) {
    before = std::string(place_type(texel.texture)) + " penumbra_place = " + place + "; ";
    place = "penumbra_place";
  }
  const std::string whole = text.spelled(name, 2) + place + "]";
  text.replace(name, close + 1 - name,
               "{ " + before + texel.type + " penumbra_texel = " + whole + "; penumbra_texel");
  text.replace(end, 1, "; " + whole + " = penumbra_texel; }");
}

}  // namespace

// Writes to some components of a texel, `_Result[id].xy += v;` or `_Result[uint2(x, y)][1] = v;`: glslang
// reports "unimplemented: partial image updates". The statement becomes a block that reads the texel, changes
// it and writes it back, which is also what the hardware does. An index with a call, ++ or -- is evaluated
// once, into a variable. Only for textures and buffers at file scope; a component as the argument of an out
// parameter remains an error.
void write_whole_texels(TokenText& text) {
  const std::vector<hlsl::Declaration>& declarations = text.declarations();
  const Texels texels = writable_textures(text, declarations);
  if (texels.empty()) return;
  for (const hlsl::Declaration& declaration : declarations) {
    if (declaration.kind != hlsl::Declaration::Kind::function) continue;
    for (std::size_t at = declaration.open; at < declaration.close; ++at) {
      if (!text.is_identifier(at) || !text.is(at + 1, "[") || text.matching_bracket(at + 1) == npos) continue;
      const auto texel = texels.find(text.word(at));
      if (texel != texels.end()) rewrite(text, at, texel->second);
    }
  }
  text.apply();
}

}  // namespace penumbra::preparation
