#include "preparation/entry_functions.h"

namespace penumbra::preparation {

std::vector<const hlsl::Declaration*> entry_functions(const TokenText& text, const EntryPoint& entry) {
  std::vector<const hlsl::Declaration*> found;
  for (const hlsl::Declaration& declaration : text.declarations())
    if (declaration.kind == hlsl::Declaration::Kind::function && text.word(declaration.name) == entry.name)
      found.push_back(&declaration);
  return found;
}

}  // namespace penumbra::preparation
