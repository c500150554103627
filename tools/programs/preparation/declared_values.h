// Variables as they are declared, at file scope, in structs, as parameters and in functions. Internal to this
// room.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "preparation/token_text.h"

namespace penumbra::preparation {

struct ValueType {
  std::string_view name;     // of the type, without what stands in <>; empty: not known
  std::string_view element;  // the first word in the <>
  int dimensions = 0;        // array sizes that follow
  bool constant = false;     // declared const
  bool is(std::string_view type) const { return name == type && dimensions == 0; }
};

struct DeclaredValue {
  enum class Place { global, member, parameter, local };
  Place place = Place::global;
  ValueType type;
  bool is_static = false;
  std::size_t first = npos;     // modifiers included; npos for all but the first of a statement
  std::size_t type_at = npos;   // the word that names the type
  std::size_t type_end = npos;  // one past the type and its <>
  std::size_t name = npos;      // npos for a parameter without one
  std::size_t end = npos;       // one past the name and its array sizes
  std::size_t last = npos;      // the ',' ';' or ')' after all that belongs to it
};

// Where a declaration begins and what it must not go beyond. With `type` the type has been read already.
struct DeclarationRange {
  std::size_t first = 0;
  std::size_t end = 0;
  DeclaredValue::Place place = DeclaredValue::Place::global;
  std::string_view type{};
};

// Appends what `modifiers type<...> name[2] : semantic = value, name...;` declares; one past its ';'. A
// parameter ends at its ','.
std::size_t read_declaration(const TokenText& text, const DeclarationRange& range,
                             std::vector<DeclaredValue>& to);

bool is_modifier(std::string_view word);  // const, static, in, row_major, ...

// One past the <...> that opens here, if it is one a type can have; else `at`.
std::size_t after_template(const TokenText& text, std::size_t at, std::size_t end);

// One past the brackets that open here, or past this token.
std::size_t after_brackets(const TokenText& text, std::size_t at);

}  // namespace penumbra::preparation
