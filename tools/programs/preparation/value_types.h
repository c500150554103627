// Name lookup and types: the variable that a name refers to, and its type, as far as the passes need it that
// trace textures, samplers and buffers through a text.
//
// The lookup knows globals (including members of cbuffers), members of structs, parameters, locals with their
// blocks, results of functions if all overloads return the same type, and chains of these with '.', '[]' and
// calls: `scene.maps[2].albedo`, `Load(x).tint`. Everything else - operators, swizzles, casts, built-in
// functions - is unknown instead of guessed. It takes one pass over the tokens and linear time.
#pragma once

#include <unordered_map>

#include "hlsl/declarations.h"
#include "preparation/declared_values.h"
#include "preparation/token_text.h"

namespace penumbra::preparation {

struct StructType {
  std::size_t declaration = 0;       // index into ValueTypes::declarations()
  std::string_view base;             // base in `struct S : base`
  std::vector<std::size_t> members;  // indices into ValueTypes::declared(), in their order
  std::unordered_map<std::string_view, std::size_t> member_names;  // the same by name
  std::vector<hlsl::Declaration> functions;                        // functions with bodies
};

struct FunctionType {
  std::size_t name = npos;              // its token
  std::vector<std::size_t> parameters;  // indices into ValueTypes::declared()
  std::size_t body = npos;              // its '{'; npos for a prototype
};

class ValueTypes {
 public:
  explicit ValueTypes(const TokenText& text);  // valid until its apply()

  // Returns the type of the chain that ends with this token, and the chain's first token (npos if there is no
  // known chain).
  const ValueType& at(std::size_t token) const { return types_[places_[token].type]; }
  std::size_t begin(std::size_t token) const { return wide(places_[token].begin); }
  // Returns the index into declared() of the variable or member that this identifier refers to; npos
  // otherwise.
  std::size_t named(std::size_t token) const { return wide(places_[token].named); }

  const std::vector<DeclaredValue>& declared() const { return declared_; }
  const std::vector<hlsl::Declaration>& declarations() const { return declarations_; }
  const std::unordered_map<std::string_view, StructType>& structs() const { return structs_; }
  const StructType* find_struct(std::string_view name) const {  // null if there is none
    const auto known = structs_.find(name);
    return known == structs_.end() ? nullptr : &known->second;
  }
  const std::vector<FunctionType>& functions() const { return functions_; }  // including those of structs

 private:
  friend class ValueTypesReader;

  // The information about one token. It is small: a text has a hundred thousand tokens, and most are no
  // value.
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  struct Place {
    std::uint32_t type = 0;  // index into types_, of which the first is the unknown type
    std::uint32_t begin = none;
    std::uint32_t named = none;
  };
  static std::size_t wide(std::uint32_t index) { return index == none ? npos : index; }
  static std::uint32_t narrow(std::size_t index) { return static_cast<std::uint32_t>(index); }  // npos: none

  const std::vector<hlsl::Declaration>& declarations_;
  std::vector<DeclaredValue> declared_;
  std::unordered_map<std::string_view, StructType> structs_;
  std::vector<FunctionType> functions_;
  std::vector<ValueType> types_;
  std::vector<Place> places_;
};

}  // namespace penumbra::preparation
