// Semantics that two inputs or two outputs of a program share. Internal to this room.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "preparation/token_text.h"

namespace penumbra::preparation {

// `float4 c[2] : TEXCOORD1` takes TEXCOORD1 and TEXCOORD2.
struct SemanticUse {
  std::size_t type = npos;  // the tokens of its type, its name and its semantic
  std::size_t name = npos;
  std::size_t semantic = npos;
  bool output = false;
};

class RepeatedSemantics {
 public:
  // `same_type`: whether two inputs of one type may share a semantic.
  RepeatedSemantics(TokenText& text, bool same_type) : text_(text), same_type_(same_type) {}

  // An error where one before it has the semantic.
  void add(const SemanticUse& use);

 private:
  std::size_t elements(const SemanticUse& use) const;

  TokenText& text_;
  const bool same_type_;
  std::map<std::string, SemanticUse> uses_;  // by direction, name in capitals and index
};

}  // namespace penumbra::preparation
