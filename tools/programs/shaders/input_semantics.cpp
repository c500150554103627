#include "shaders/input_semantics.h"

#include <algorithm>
#include <cctype>

namespace penumbra::shaders {
namespace {

std::string numbered(std::string semantic) {
  std::transform(semantic.begin(), semantic.end(), semantic.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const bool has_number = !semantic.empty() && std::isdigit(static_cast<unsigned char>(semantic.back())) != 0;
  return has_number ? semantic : semantic + "0";
}

}  // namespace

std::map<std::uint32_t, std::string> input_semantics(const glslang::TIntermediate& tree) {
  std::map<std::uint32_t, std::string> semantics;
  for (const TIntermNode* node : tree.findLinkerObjects()->getSequence()) {
    const glslang::TIntermSymbol* symbol = const_cast<TIntermNode*>(node)->getAsSymbolNode();
    if (symbol == nullptr) continue;
    const glslang::TQualifier& qualifier = symbol->getQualifier();
    if (qualifier.storage != glslang::EvqVaryingIn || !qualifier.hasLocation()) continue;
    if (qualifier.semanticName == nullptr) continue;
    semantics[qualifier.layoutLocation] = numbered(qualifier.semanticName);
  }
  return semantics;
}

}  // namespace penumbra::shaders
