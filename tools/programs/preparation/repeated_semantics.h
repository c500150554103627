// Semantics that two inputs or two outputs of a program share. Internal to this folder.
//
// FXC rejects shared outputs and system values (X4504, X4574) and inputs of different types (X3536); for
// other inputs it warns (X4711). DXC rejects all.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "preparation/token_text.h"

namespace penumbra::preparation {

// A use of a semantic: `float4 c[2] : TEXCOORD1` takes TEXCOORD1 and TEXCOORD2.
struct SemanticUse {
  std::size_t type = npos;  // the tokens of its type, its name and its semantic
  std::size_t name = npos;
  std::size_t semantic = npos;
  bool output = false;
};

class RepeatedSemantics {
 public:
  RepeatedSemantics(TokenText& text, bool dxc) : text_(text), dxc_(dxc) {}

  // Reports an error or a warning if an earlier one has the semantic.
  void add(const SemanticUse& use);

 private:
  std::size_t elements(const SemanticUse& use) const;

  TokenText& text_;
  const bool dxc_;
  std::map<std::string, SemanticUse> uses_;  // by direction, name in capitals and index
};

}  // namespace penumbra::preparation
