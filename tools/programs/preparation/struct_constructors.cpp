#include <string>
#include <string_view>
#include <unordered_set>

#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

void check_struct_constructors(TokenText& text) {
  const ValueTypes& types = text.types();
  std::unordered_set<std::string_view> functions;
  for (const FunctionType& function : types.functions()) functions.insert(text[function.name].spelling);
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (!text.is_identifier(at) || !text.is(at + 1, "(") || types.begin(at) == npos) continue;
    const std::string_view name = text[at].spelling;
    if (!types.structs().contains(name) || functions.contains(name)) continue;
    text.note(at, hlsl::Severity::error,
              "HLSL has no constructors of structs: write " + std::string(name) +
                  " value = {...}; or assign the members of a '" + std::string(name) + "' one by one");
  }
}

}  // namespace penumbra::preparation
