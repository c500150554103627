// Declarations of variables: at file scope, in structs, as parameters and in functions. Internal to this
// folder.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

struct ValueType {
  std::string_view name;     // name of the type, without its template arguments; empty if unknown
  std::string_view element;  // the first template argument
  int dimensions = 0;        // array sizes that follow
  bool constant = false;     // declared const
  bool is(std::string_view type) const { return name == type && dimensions == 0; }
};

struct DeclaredValue {
  enum class Place { global, member, parameter, local };
  Place place = Place::global;
  ValueType type;
  bool is_static = false;  // for every declarator of the statement, like is_groupshared
  bool is_groupshared = false;
  std::size_t first = npos;     // including modifiers; npos for all but the first declarator of a statement
  std::size_t type_at = npos;   // the token of the type's name
  std::size_t type_end = npos;  // one past the type and its template arguments
  std::size_t name = npos;      // npos for a parameter without one
  std::size_t end = npos;       // one past the name and its array sizes
  std::size_t last = npos;      // the ',' ';' or ')' that ends it
};

// The tokens in which a declaration is read. If `type` is set, the type has already been read.
struct DeclarationRange {
  std::size_t first = 0;
  std::size_t end = 0;
  DeclaredValue::Place place = DeclaredValue::Place::global;
  std::string_view type{};
};

// Appends the values that `modifiers type<...> name[2] : semantic = value, name...;` declares; returns one
// past its ';'. A parameter ends at its ','.
std::size_t read_declaration(const TokenText& text, const DeclarationRange& range,
                             std::vector<DeclaredValue>& to);

bool is_modifier(std::string_view word);  // true for const, static, in, row_major, ...

// Returns whether the modifier stands before the value's type. Declarators after a statement's first, and
// those behind the body of a struct, have none of their own.
bool has_modifier(const TokenText& text, const DeclaredValue& value, std::string_view modifier);

bool is_written_parameter(const TokenText& text, const DeclaredValue& parameter);  // true for out and inout

// Returns one past the template arguments that open here, if a type can have them; else `at`.
std::size_t after_template(const TokenText& text, std::size_t at, std::size_t end);

}  // namespace penumbra::preparation
